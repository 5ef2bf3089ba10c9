"""Whether every recording has the input channels that a scenario takes."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.errors import InputError, TorquerigError
from torquerig.recordings.inputs import driven_by
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.recorded.compared_channel import check_parts
from torquerig.simulation.input_channels import channel_of, driven_parts


def as_driven(scenario: Scenario, recordings: Sequence[Recording]) -> list[Recording]:
    """Return the recordings with their channels as inputs of their runs, where the scenario takes any.

    Raises
    ------
    InputError
        With the scenario's file, line and key, for the first recording that lacks an input, or whose channel does not
        fit the part.
    """
    parts = driven_parts(scenario.rig)
    if not parts:
        return [*recordings]
    for one in recordings:
        check_parts(one, scenario.rig)
    driven = [driven_by(one) for one in recordings]
    for part in parts:
        for one in driven:
            try:
                part.terms(scenario.rig.at(one.run))
            except TorquerigError as error:
                place = scenario.document.place(("rig", part.name, "from"))
                raise InputError(f"{place}: {error}") from None
    return driven


def inputs_shown(scenario: Scenario, recording: Recording) -> list[str]:
    """Return which channel of a recording drives which part, one sentence each."""
    return [
        f"{recording.name}: input: {channel_of(part, recording)} drives {part.name} ({part.kind})"
        for part in driven_parts(scenario.rig)
    ]
