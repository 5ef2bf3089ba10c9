"""A diagnosis with its answer in words and pages, of features or along a measured motion."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from torquerig.inference.answer import as_json
from torquerig.inference.answer.stated_numbers import with_stated_numbers
from torquerig.inference.engine import Outcome, diagnose
from torquerig.inference.knobs import unvaried
from torquerig.inference.motion.answer import as_json as motion_json
from torquerig.inference.motion.engine import MotionOutcome, diagnose_motion
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.recording_faults import recording_faults
from torquerig.reporting.diagnosis.answer_text import answer_lines
from torquerig.reporting.diagnosis.diagnosed import Diagnosed
from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
from torquerig.reporting.diagnosis.sentences import MOTION_RESIDUAL
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.as_compared import Compared, as_compared
from torquerig.scenario.recorded.compared_channel import with_sensor_errors


def diagnosed(
    scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[str] = (), seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> Diagnosed:  # fmt: skip
    """Return the diagnosis.

    Parameters
    ----------
    held_out : sequence of str
        Names of recordings that are not fitted and judge the models.
    progress : callable
        Called with the name of each stage.

    Raises
    ------
    InputError, RecordingError
        Where scenario and recordings do not fit each other.
    """
    compared = as_compared(scenario, recordings)
    if imposed_part(scenario.rig) is not None:
        return _moved(scenario, compared, held_out=held_out, seed=seed, progress=progress)
    outcome = with_stated_numbers(
        diagnose(compared.scenario, compared.recordings, held_out=held_out, progress=progress)
    )  # fmt: skip
    found = as_json(outcome)
    data = {**found, "remarks": [*_before(compared), *found["remarks"]]}
    completed = with_sensor_errors(outcome.completed, scenario.rig) if outcome.completes else None
    return Diagnosed(
        data=data, completed=completed, sentence=verdict_of(data),
        answer=partial(first_screen, data), lines=_lines,
        page=partial(_page, outcome=outcome, title=scenario.title, seed=seed),
    )  # fmt: skip


def _moved(
    scenario: Scenario, compared: Compared, *, held_out: Sequence[str], seed: int, progress: Callable[[str], None]
) -> Diagnosed:  # fmt: skip
    """Return the diagnosis where the motion was measured."""
    outcome = diagnose_motion(compared.scenario, compared.recordings, held_out_runs=held_out, progress=progress)
    found = motion_json(outcome)
    data = {**found, "remarks": [*_before(compared), *_left_in(compared.recordings)]}
    completed = with_sensor_errors(outcome.completed, scenario.rig) if outcome.completes else None
    return Diagnosed(
        data=data, completed=completed, sentence=verdict_of(data, measure=MOTION_RESIDUAL),
        answer=partial(first_screen, data, percent=True), lines=_motion_lines,
        page=partial(_motion_page, outcome=outcome, title=scenario.title, seed=seed),
    )  # fmt: skip


def _before(compared: Compared) -> tuple[str, ...]:
    """Return what is known before any fit: what is compared, and which uncertain numbers no fit varies."""
    scenario = compared.scenario
    return (*compared.choices, *unvaried(scenario.rig, scenario.uncertainties))


def _left_in(recordings: Sequence[Recording]) -> Iterator[str]:
    """Yield the faults of samples that nothing repairs where the motion was measured; a limit is a hypothesis there."""
    for recording in recordings:
        for fault in recording_faults(recording):
            if fault.mechanism != "clipping":
                yield f"{recording.name}: {fault.of_channel}; the diagnosis compares these samples as they are"


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
