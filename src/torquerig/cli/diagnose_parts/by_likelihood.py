"""``torquerig diagnose --engine likelihood``: what it refuses, and its answer in words."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from torquerig.cli.diagnose_parts.diagnosed import Diagnosed
from torquerig.diagnosis.motion.moved import under_measured_motion
from torquerig.errors import InputError
from torquerig.inference.answer import as_json
from torquerig.inference.engine import Outcome, diagnose
from torquerig.recordings.recording import Recording
from torquerig.reporting.diagnosis.answer_text import answer_lines
from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import as_measured


def refuse_measured_motion(scenario: Scenario) -> None:
    """Raise InputError for a rig whose motion was measured, which this engine does not compare yet."""
    if under_measured_motion(scenario.rig):
        raise InputError("--engine likelihood does not compare rigs whose motion was measured yet; leave --engine out")


def diagnosed_by_likelihood(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[Path], seed: int,
    progress: Callable[[str], None],
) -> Diagnosed:  # fmt: skip
    """Return the diagnosis by the second engine.

    ``held_out`` holds recordings that are not fitted.

    Raises
    ------
    InputError
        For a rig whose motion was measured, which this engine does not compare yet.
    """
    refuse_measured_motion(scenario)
    names = [one.name for one in held_out]
    outcome = diagnose(scenario, as_measured(recordings, scenario.rig), held_out=names, progress=progress)
    return Diagnosed(
        data=as_json(outcome), completed=outcome.completed if outcome.completes else None, lines=_lines,
        page=partial(_page, outcome=outcome, title=scenario.title, seed=seed),
    )  # fmt: skip


def _lines(data: Mapping[str, Any]) -> list[str]:
    """Return what is missing, how large in N m, how sure, what it cannot be separated from, and what to do next."""
    return answer_lines(data, verdict=verdict_of(data), remarks=remarks_of(data))


def _page(data: Mapping[str, Any], *, outcome: Outcome, title: str, command: str, model: str | None, seed: int) -> str:
    from torquerig.reporting.diagnosis.likelihood.page import likelihood_page

    return likelihood_page(outcome, data, title=title, command=command, model=model, seed=seed)
