"""The check of recordings against a scenario, for the page: made in another process, returned as plain values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from torquerig.catalog.search import catalog_for
from torquerig.document import parse_document
from torquerig.errors import TorquerigError


@dataclass(frozen=True)
class RunsChecked:
    """What a diagnosis would compare; ``problem`` is why it would refuse, empty where it would not.

    Parameters
    ----------
    head, rows : tuple of str, tuple of rows
        Table of the recordings.
    compared, suspicious, fitted : tuple of str
        What is compared, what looks wrong, which parameters are fitted first.
    can, cannot : tuple of str
        What these runs can tell apart, and what they cannot.
    """

    head: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    compared: tuple[str, ...] = ()
    suspicious: tuple[str, ...] = ()
    fitted: tuple[str, ...] = ()
    can: tuple[str, ...] = ()
    cannot: tuple[str, ...] = ()
    problem: str = ""


def runs_checked(
    text: str, path: Path, recordings: Sequence[Path], *, catalogs: Sequence[Path] = (), seed: int = 0
) -> RunsChecked:
    """Return the check of recordings against the text of a scenario; a refusal is a result.

    Parameters
    ----------
    text : str
        The scenario as it is edited.
    path : Path
        Its file, from whose folder other files are read.
    recordings : sequence of Path
    catalogs : sequence of Path
        Further catalog folders.
    """
    from torquerig.orders.angle.suspicions import suspicions_in
    from torquerig.recordings.files import read_recording
    from torquerig.recordings.inspection.recording_info import recording_info
    from torquerig.reporting.diagnosis.run_check import run_check
    from torquerig.scenario.kinematics import kinematics_of
    from torquerig.scenario.reading import read_scenario
    from torquerig.studio.check.separable import separable

    try:
        scenario = read_scenario(parse_document(text, path), catalog_for(path, catalogs), seed=seed)
        read = [read_recording(one) for one in recordings]
        made = run_check(scenario, read)
    except TorquerigError as error:
        return RunsChecked(problem=str(error))
    samples = [f"{one.name}: {text}" for one in read for text in suspicions_in(recording_info(one), one)[0]]
    parts = separable(kinematics_of(scenario.rig), read)
    return RunsChecked(
        head=tuple(made.head), rows=tuple(tuple(row) for row in made.rows),
        compared=(*made.compared, *made.sensors, *made.condensed),
        suspicious=tuple(dict.fromkeys((*made.suspicious, *samples))), fitted=made.fitted, can=parts.can,
        cannot=parts.cannot,
    )  # fmt: skip
