"""Scenario and recordings as a diagnosis compares them: a known error of the sensor is corrected once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import as_measured, what_is_compared, without_sensor_errors
from torquerig.scenario.recorded.input_checks import as_driven


@dataclass(frozen=True)
class Compared:
    """A scenario and recordings of its rig.

    Parameters
    ----------
    scenario : Scenario
        Its compared sensor reads as the data sheet states.
    recordings : tuple of Recording
        Corrected by the scale, zero and mounting that the scenario states; with their channels as inputs of the model.
    choices : tuple of str
        Which of several measured channels is compared, in a sentence for each recording that has several.
    """

    scenario: Scenario
    recordings: tuple[Recording, ...]
    choices: tuple[str, ...]


def as_compared(scenario: Scenario, recordings: Sequence[Recording]) -> Compared:
    """Return what is compared.

    Raises
    ------
    InputError
        Where a channel belongs to no part of the rig, or several may be the compared one, or an input is missing.
    """
    rig = scenario.rig
    read = as_driven(scenario, as_measured(recordings, rig))
    choices = tuple(said for one in read if (said := what_is_compared(one, rig)) is not None)
    return Compared(replace(scenario, rig=without_sensor_errors(rig)), tuple(read), choices)
