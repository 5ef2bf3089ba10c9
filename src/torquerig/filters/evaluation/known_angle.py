"""A recording with the estimated motor angle as a channel, so that a shifted chain uses the same angle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from torquerig.errors import TorquerigError
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.recordings.recording import Channel

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

FOUND_ANGLE = "found_motor_angle_rad"


def with_known_angle(recording: Recording, lines: Sequence[KinematicLine]) -> Recording:
    """Return ``recording`` with the angle estimated from ``lines``, where it has no angle channel.

    At empty orders there are no lines to estimate the angle from. The placebo would use the set-point and so differ
    from the chain in speed, too. A recording without usable angle is returned unchanged.
    """
    ratio = lines[0].output_order / lines[0].motor_order if lines else recording.run.gear_ratio or 1.0
    if recorded_motor_angle(recording, ratio=ratio) is not None:
        return recording
    try:
        angle = best_motor_angle(recording, lines)
    except TorquerigError:
        return recording
    return recording.with_channel(FOUND_ANGLE, Channel(values=angle.values, quantity="motor_angle", unit="rad"))
