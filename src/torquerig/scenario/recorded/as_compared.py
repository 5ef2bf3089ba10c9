"""Scenario and recordings as a diagnosis compares them: a known error of the sensor is corrected once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from torquerig.recordings.recording import Recording
from torquerig.rig.imposed_part import imposed_part
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import as_measured, what_is_compared, without_sensor_errors
from torquerig.scenario.recorded.gear_ratio import at_stated_ratio
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
        Which of several measured channels is compared, in a sentence for each recording that has several; and which
        counts of the catalog are not known.
    """

    scenario: Scenario
    recordings: tuple[Recording, ...]
    choices: tuple[str, ...]


def as_compared(scenario: Scenario, recordings: Sequence[Recording]) -> Compared:
    """Return what is compared.

    Raises
    ------
    InputError
        Where a channel belongs to no part of the rig, or several may be the compared one, or an input is missing, or
        the sidecars state other gear ratios than the scenario.
    """
    rig = scenario.rig
    read = as_driven(scenario, as_measured(recordings, rig))
    read = read if imposed_part(rig) is not None else at_stated_ratio(read, rig)
    choices = tuple(said for one in read if (said := what_is_compared(one, rig)) is not None)
    return Compared(replace(scenario, rig=without_sensor_errors(rig)), tuple(read), (*choices, *_open_counts(scenario)))


def _open_counts(scenario: Scenario) -> Iterator[str]:
    drawn = ", ".join(f"{name} = {value:g}" for name, value in scenario.choices().items())
    if drawn:
        yield (
            f"The catalog leaves whole numbers open, and no other ones are tried: {drawn}, drawn from the seed. State "
            "them in the scenario; wrong ones look like missing lines."
        )
