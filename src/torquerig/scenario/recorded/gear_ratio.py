"""The gear ratio of recordings, as the rig of their scenario has it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.gear_stage import gear_stages
from torquerig.scenario.kinematics import kinematics_of


def at_ratio_of(recordings: Sequence[Recording], rig: Rig) -> list[Recording]:
    """Return the recordings as runs of the rig's gear ratio up to the sensor, whatever their sheets say of it."""
    if not gear_stages(rig):
        return [*recordings]
    ratio = kinematics_of(rig).ratio
    return [replace(recording, run=replace(recording.run, gear_ratio=ratio)) for recording in recordings]
