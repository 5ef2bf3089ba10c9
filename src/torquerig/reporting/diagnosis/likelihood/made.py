"""A diagnosis by the likelihood: the answer in words and pages, of features or along a measured motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from torquerig.inference.answer import as_json
from torquerig.inference.engine import Outcome, diagnose
from torquerig.inference.motion.answer import as_json as motion_json
from torquerig.inference.motion.engine import MotionOutcome, diagnose_motion
from torquerig.recordings.recording import Recording
from torquerig.reporting.diagnosis.answer_text import answer_lines
from torquerig.reporting.diagnosis.diagnosed import Diagnosed
from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
from torquerig.reporting.diagnosis.sentences import MOTION_RESIDUAL
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.as_compared import as_compared
from torquerig.scenario.recorded.compared_channel import with_sensor_errors


def diagnosed_by_likelihood(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[str], seed: int,
    progress: Callable[[str], None],
) -> Diagnosed:  # fmt: skip
    """Return the diagnosis; ``held_out`` names recordings that are not fitted."""
    if imposed_part(scenario.rig) is not None:
        moved = diagnose_motion(scenario, recordings, held_out_runs=held_out, progress=progress)
        data = motion_json(moved)
        return Diagnosed(
            data=data, completed=moved.completed if moved.completes else None,
            sentence=verdict_of(data, measure=MOTION_RESIDUAL), answer=partial(first_screen, data, percent=True),
            lines=_motion_lines, page=partial(_motion_page, outcome=moved, title=scenario.title, seed=seed),
        )  # fmt: skip
    compared = as_compared(scenario, recordings)
    outcome = diagnose(compared.scenario, compared.recordings, held_out=held_out, progress=progress)
    data = {**as_json(outcome), "remarks": [*compared.choices]}
    completed = with_sensor_errors(outcome.completed, scenario.rig) if outcome.completes else None
    return Diagnosed(
        data=data, completed=completed, sentence=verdict_of(data),
        answer=partial(first_screen, data), lines=_lines,
        page=partial(_page, outcome=outcome, title=scenario.title, seed=seed),
    )  # fmt: skip


def _motion_lines(data: Mapping[str, Any]) -> list[str]:
    return answer_lines(data, verdict=verdict_of(data, measure=MOTION_RESIDUAL), remarks=remarks_of(data))


def _motion_page(
    data: Mapping[str, Any], *, outcome: MotionOutcome, title: str, command: str, model: str | None, seed: int
) -> str:  # fmt: skip
    from torquerig.reporting.diagnosis.likelihood.motion_page import motion_page

    return motion_page(outcome, data, title=title, command=command, model=model, seed=seed)


def _lines(data: Mapping[str, Any]) -> list[str]:
    """Return what is missing, how large in N m, how sure, what it cannot be separated from, and what to do next."""
    return answer_lines(data, verdict=verdict_of(data), remarks=remarks_of(data))


def _page(data: Mapping[str, Any], *, outcome: Outcome, title: str, command: str, model: str | None, seed: int) -> str:
    from torquerig.reporting.diagnosis.likelihood.page import likelihood_page

    return likelihood_page(outcome, data, title=title, command=command, model=model, seed=seed)
