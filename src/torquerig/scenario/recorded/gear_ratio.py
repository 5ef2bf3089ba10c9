"""The gear ratio of recordings, as the rig of their scenario has it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.gear_stage import gear_stages
from torquerig.scenario.kinematics import kinematics_of, shaft_turns_to

_SAME = 0.02  # [1] relative: a ratio is rounded in a sidecar, and the next one of a catalog differs by more


def at_ratio_of(recordings: Sequence[Recording], rig: Rig) -> list[Recording]:
    """Return the recordings as runs of the rig's gear ratio up to the sensor, whatever their sheets say of it."""
    if not gear_stages(rig):
        return [*recordings]
    ratio = kinematics_of(rig).ratio
    return [replace(recording, run=replace(recording.run, gear_ratio=ratio)) for recording in recordings]


def at_stated_ratio(recordings: Sequence[Recording], rig: Rig) -> list[Recording]:
    """Return the recordings with the rig's gear ratio where their sidecars state none.

    Raises
    ------
    InputError
        Where the sidecars state several ratios.
    RecordingError
        Where one states another ratio than the rig has up to the sensor or to any of its gears.
    """
    stated = {one.run.gear_ratio: one for one in recordings if one.run.gear_ratio}
    listed = sorted(stated)
    if listed and listed[-1] > (1 + _SAME) * listed[0]:
        raise InputError(
            f"the recordings are of different rigs: their sidecars state the gear ratio as "
            f"{' and '.join(f'{one:g}' for one in listed)}; diagnose the runs of one rig in one call"
        )
    gears = gear_stages(rig)
    known = [shaft_turns_to(rig, last) for last in (rig.measured, *(gear.name for gear in gears))] if gears else []
    for ratio, one in stated.items():
        if known and all(abs(ratio / each - 1) > _SAME for each in known):
            raise RecordingError(
                f"{one.name}: its sidecar states a gear ratio of {ratio:g}, but the scenario's rig has {known[0]:g}; "
                "correct the sidecar, or use the scenario of the recorded rig"
            )
    same = zip(recordings, at_ratio_of(recordings, rig), strict=True)
    return [one if one.run.gear_ratio else other for one, other in same]
