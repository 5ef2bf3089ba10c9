"""The diagnosis of any rig: by features of its runs, or sample by sample where the motion was measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from torquerig.diagnosis.engine import Outcome, diagnose
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome, diagnose_motion
from torquerig.diagnosis.motion.moved import under_measured_motion
from torquerig.recordings.recording import Recording
from torquerig.scenario.catalog_values.readings import other_readings
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import (
    as_measured,
    what_is_compared,
    with_sensor_errors,
    without_sensor_errors,
)
from torquerig.scenario.recorded.input_checks import as_driven

AnyOutcome = Outcome | MotionOutcome


def diagnosed(
    scenario: Scenario, recordings: Sequence[Recording], *, seed: int, progress: Callable[[str], None] = lambda _: None
) -> AnyOutcome:
    """Return the diagnosis of recordings of one rig.

    Where the catalog leaves whole numbers open, such as pole pairs, the scenario's other readings are tried too, with
    what was added to it.

    Raises
    ------
    InputError
        Where recordings and scenario do not fit each other.
    """
    read, stated = as_driven(scenario, as_measured(recordings, scenario.rig)), scenario.rig
    choices = tuple(said for one in read if (said := what_is_compared(one, stated)) is not None)
    outcome = _diagnosed(replace(scenario, rig=without_sensor_errors(stated)), read, seed=seed, progress=progress)
    diagnosis = replace(outcome.diagnosis, remarks=(*choices, *outcome.diagnosis.remarks))
    return replace(outcome, diagnosis=diagnosis, completed=with_sensor_errors(outcome.completed, stated))


def _diagnosed(
    scenario: Scenario, recordings: Sequence[Recording], *, seed: int, progress: Callable[[str], None]
) -> AnyOutcome:
    """Return the diagnosis of recordings whose compared channel is chosen."""
    if under_measured_motion(scenario.rig):
        return diagnose_motion(scenario, recordings, seed=seed, progress=progress)
    others: tuple[Scenario, ...] = ()
    if scenario.catalog is not None:
        others = other_readings(scenario.document, scenario.catalog, seed=scenario.seed)
        others = tuple(_with(replace(one, rig=without_sensor_errors(one.rig)), scenario) for one in others)
    return diagnose(scenario, recordings, others=others, seed=seed, progress=progress)


def _with(other: Scenario, scenario: Scenario) -> Scenario:
    rig = other.rig
    for part in scenario.added:
        rig = rig + part
    return replace(other, rig=rig, added=scenario.added)
