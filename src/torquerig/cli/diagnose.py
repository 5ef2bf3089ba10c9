"""``torquerig diagnose``: where recordings and model differ, and which physics was left out."""

from __future__ import annotations

import json
import os
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from torquerig.catalog.search import catalog_for
from torquerig.cli.inputs import catalog_option, edited, set_option
from torquerig.cli.targets import check_targets
from torquerig.errors import InputError
from torquerig.recordings.files import read_recording
from torquerig.recordings.files.sidecar import sidecar_path
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.readings import other_readings
from torquerig.scenario.writing import scenario_text, write_scenario
from torquerig.whole_file import whole_file

if TYPE_CHECKING:
    from torquerig.diagnosis.engine import Outcome
    from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
    from torquerig.recordings.recording import Recording

_PAGE = "<!-- written by torquerig diagnose -->"
_MOST_WORKERS = 4  # of their own accord: each holds some 200 MB of its own
_HEAD = "Written by torquerig diagnose: the nominal rig, fitted, with what was found missing."


@click.command("diagnose")
@click.argument("recordings", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--scenario", required=True, type=click.Path(path_type=Path), help="The rig's nominal scenario.")
@click.option("--json", "out", default=None, help="Diagnosis to write; - is standard output.")
@click.option(
    "--report",
    type=click.Path(path_type=Path),
    default=None,
    help="HTML page to write: the diagnosis with its pictures, in one file.",
)
@click.option("--model", type=click.Path(path_type=Path), default=None,
              help="Completed scenario to write; beside the JSON when not given.")  # fmt: skip
@click.option("--check", is_flag=True, help="Only say whether scenario and recordings fit, and what is compared.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Fixes every random number.")
@click.option(
    "--workers", type=click.IntRange(1), default=None, help="Fits at a time; default: one per core, four at most."
)
@set_option
@catalog_option
def command(
    *, recordings: tuple[Path, ...], scenario: Path, out: str | None, report: Path | None, model: Path | None,
    check: bool, seed: int, workers: int | None, settings: tuple[str, ...], catalogs: tuple[Path, ...],
) -> None:  # fmt: skip
    """Say where RECORDINGS (runs of one rig) and the SCENARIO differ, which effect was left out, and how sure that is.

    Exit code 0 means that a diagnosis was reached, whatever it says.
    """
    from torquerig.cli.progress import stages
    from torquerig.diagnosis.engine import diagnose
    from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome, diagnose_motion, under_measured_motion
    from torquerig.diagnosis.outcome import SCHEMA, as_json
    from torquerig.diagnosis.side_by_side import side_by_side

    if check:
        _check(recordings, scenario, settings, catalogs, seed=seed)
        return
    if out is None:
        raise click.UsageError("Missing option '--json': name the file that the diagnosis goes into, or - to print it.")
    target = model or (Path("diagnosed.yaml") if out == "-" else Path(out).with_suffix(".model.yaml"))
    written = [(target, _HEAD), *([] if out == "-" else [(Path(out), SCHEMA)]), *([(report, _PAGE)] if report else [])]
    check_targets(written, inputs=(*recordings, *map(sidecar_path, recordings), scenario))
    document, catalog = edited(scenario, settings), catalog_for(scenario, catalogs)
    made = read_scenario(document, catalog, seed=seed)
    read = _read(recordings)
    outcome: Outcome | MotionOutcome
    with stages("diagnose") as progress, side_by_side(workers or min(os.cpu_count() or 1, _MOST_WORKERS)):
        if under_measured_motion(made.rig):
            outcome = diagnose_motion(made, read, seed=seed, progress=progress)
        else:
            others = other_readings(document, catalog, seed=seed)
            outcome = diagnose(made, read, others=others, seed=seed, progress=progress)
    data = outcome.as_json() if isinstance(outcome, MotionOutcome) else as_json(outcome.diagnosis)
    if outcome.completes:
        text = scenario_text(
            outcome.completed, title=made.title, operating_point=made.document.data.get("operating_point", {}),
            head=_HEAD,
        )  # fmt: skip
        write_scenario(target, text, overwrite=True)
        data["model"] = str(target)
    text = json.dumps(data, indent=2, ensure_ascii=False) + "\n"
    if report is not None:
        again = _command(recordings, scenario, settings=settings, seed=seed)
        page = _page(outcome, title=made.title, command=again, model=_named(data["model"]), seed=seed)
        with whole_file(report) as partial:
            partial.write_text(page, encoding="utf-8", newline="\n")
    if out == "-":
        click.echo(text, nl=False)
        return
    with whole_file(Path(out)) as partial:
        partial.write_text(text, encoding="utf-8", newline="\n")
    click.echo("\n".join(_told(outcome)))
    for path in (out, report, data["model"]):
        if path is not None:
            click.echo(f"wrote {path}")


def _told(outcome: Outcome | MotionOutcome) -> Iterator[str]:
    """Yield the verdict and the remarks, a sentence each."""
    from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
    from torquerig.reporting.diagnosis.sentences import EFFORT, FEATURES, verdict_sentence

    yardstick = EFFORT if isinstance(outcome, MotionOutcome) else FEATURES
    yield verdict_sentence(outcome.diagnosis, outcome.left, yardstick=yardstick)
    yield from outcome.diagnosis.remarks


def _read(paths: tuple[Path, ...]) -> list[Recording]:
    read = [read_recording(path) for path in paths]
    if len({recording.name for recording in read}) < len(read):
        raise InputError("two recordings have the same file name; rename one, so that the diagnosis can name them")
    return read


def _check(
    recordings: tuple[Path, ...], scenario: Path, settings: tuple[str, ...], catalogs: tuple[Path, ...], *, seed: int
) -> None:
    from torquerig.cli.diagnose_check import checked

    made = read_scenario(edited(scenario, settings), catalog_for(scenario, catalogs), seed=seed)
    click.echo(checked(made, _read(recordings)))


def _page(outcome: Outcome | MotionOutcome, *, title: str, command: str, model: str | None, seed: int) -> str:
    from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
    from torquerig.reporting.diagnosis.motion_page import motion_page
    from torquerig.reporting.diagnosis.page import diagnosis_page

    if isinstance(outcome, MotionOutcome):
        return motion_page(outcome, title=title, command=command, model=model, seed=seed)
    return diagnosis_page(outcome, title=title, command=command, model=model, seed=seed)


def _command(recordings: tuple[Path, ...], scenario: Path, *, settings: tuple[str, ...], seed: int) -> str:
    """Return the command that makes the diagnosis again, without any folder of this machine."""
    edits = [part for setting in settings for part in ("--set", setting)]
    names = [_named(path) or "" for path in recordings]
    fixed = ["--seed", str(seed)] if seed else []
    return shlex.join(
        ["torquerig", "diagnose", *names, "--scenario", _named(scenario) or "", *edits, *fixed, "--json",
         "diagnosis.json", "--report", "diagnosis.html"]
    )  # fmt: skip


def _named(path: Path | str | None) -> str | None:
    """Return a path as it is shown: its name alone where it is of this machine."""
    if path is None:
        return None
    return Path(path).name if Path(path).is_absolute() else Path(path).as_posix()
