"""Whether the recordings of one call can be runs of the scenario's rig, before anything is computed."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.errors import InputError, RecordingError
from torquerig.rig.parts import Gear
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.signals.recording import Recording

_RATIO_KEPT = 0.02
SPEED_KEPT = 0.03  # a set-point is kept within a per cent; beyond this the sheet and the encoder tell of two speeds


def check_recordings(recordings: Sequence[Recording], rig: Rig) -> None:
    """Raise where the sheets contradict each other or the scenario: other motor, other gear ratio, no torque."""
    for recording in recordings:
        recording.torque_name()
    for what, values in (
        ("motor", {recording.run.motor for recording in recordings if recording.run.motor}),
        ("gear ratio", {recording.run.gear_ratio for recording in recordings if recording.run.gear_ratio}),
    ):
        if len(values) > 1:
            listed = " and ".join(sorted(str(value) for value in values))
            raise InputError(
                f"the recordings are of different rigs: their sheets state the {what} as {listed}; diagnose the runs "
                "of one rig in one call"
            )
    ratio = kinematics_of(rig).ratio
    for recording in recordings:
        stated = recording.run.gear_ratio
        if stated and rig.parts_of(Gear) and abs(stated / ratio - 1) > _RATIO_KEPT:
            raise RecordingError(
                f"{recording.name}: its sheet states a gear ratio of {stated:g}, the scenario's rig has {ratio:g}; "
                "correct the sheet, or diagnose with the scenario of that rig"
            )
