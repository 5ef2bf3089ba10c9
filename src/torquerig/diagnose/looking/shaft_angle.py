"""What angle the motor turned through in each run: measured, followed in the torque's lines, or simulated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from statistics import median

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.linear.twin import Twin
from torquerig.diagnose.side_by_side import of_each
from torquerig.mechanisms import TorqueRipple
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.signals.angle import MotorAngle, measured_motor_angle
from torquerig.signals.recording import Recording
from torquerig.signals.set_point import set_point_speed
from torquerig.signals.speed_far_off import speed_far_off
from torquerig.signals.speed_from_torque import motor_angle_from_torque
from torquerig.simulate.simulate import simulate

_NEAR = 0.013  # [1] a set-point off by more is out of the reach of those who follow the lines around it
_STRAYED = 0.02  # [1] from the speed that the sheet or the comb of all lines tells
_FOLLOWED = 0.003  # [1] uncertainty of the speed above which a run's own torque does not tell it


@dataclass(frozen=True)
class ShaftAngle:
    """Angle of the motor at each sample [rad], shape (samples,), whether it was measured, and how it was got."""

    values: NDArray[np.float64]
    measured: bool
    origin: str


def shaft_angles(
    recordings: Sequence[Recording], rig: Rig, *, also: Sequence[float] = ()
) -> tuple[list[ShaftAngle], float]:
    """Return the angle of each run and the factor by which the rig's speeds differ from their set-points.

    ``also`` are orders of the motor that stand out beside those that the rig's kinematics know.

    The factor is the median over the runs whose angle was measured or followed: one drive has one error of scale. A
    ramp or reversal without an encoder, or a run whose lines do not stand out, turns as the nominal rig does when its
    set-point is scaled by that factor; its ripple is left out, for nobody knows at which phase it moves the shaft.
    """
    found = of_each(partial(_told, rig=rig, also=also), recordings)
    factors = [factor for _, factor in found if factor is not None]
    factor = median(factors) if factors else 1.0
    pairs = zip(recordings, found, strict=True)
    return [_simulated(recording, rig, factor) if angle is None else angle for recording, (angle, _) in pairs], factor


def _told(recording: Recording, *, rig: Rig, also: Sequence[float]) -> tuple[ShaftAngle | None, float | None]:
    """Return the angle that was measured or is followed, and of steady runs the speed over its set-point."""
    run = recording.run
    asked = run.speed if run.profile == "steady" else None
    angle = measured_motor_angle(recording, ratio=kinematics_of(rig).ratio)
    measured = angle is not None
    if angle is None and asked:
        angle = _followed(recording, rig, also)
    if angle is None:
        return None, None
    factor = angle.mean_speed(recording.sample_rate) / asked if asked else None
    return ShaftAngle(angle.values, measured, angle.origin), factor


def _followed(recording: Recording, rig: Rig, also: Sequence[float]) -> MotorAngle | None:
    """Return the angle of a steady run by the lines of its torque; None where none stand out: other runs know more."""
    run = recording.run
    stated = run.speed or 0.0
    known = [line.order for line in Twin(rig.at(run)).lines()]
    told = speed_far_off(recording.torque(), recording.sample_rate, set_point=stated, orders=[*known, *also])
    if told is not None and abs(told / stated - 1) > _NEAR:
        recording = replace(recording, run=replace(run, speed=told))
    angle = motor_angle_from_torque(recording, kinematics_of(rig).lines(), also=also, strays=_STRAYED)
    return angle if angle.speed_sd < _FOLLOWED else None


def _simulated(recording: Recording, rig: Rig, factor: float) -> ShaftAngle:
    run = replace(recording.run, speed=set_point_speed(recording, "recordings without an angle channel") * factor)
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitudes={}))
    turned = simulate(rig.at(run), duration=recording.duration, seed=0, sample_rate=recording.sample_rate)
    return ShaftAngle(
        turned.channels["true_motor_angle_rad"].values, False, f"simulated from the set-point times {factor:.5f}"
    )
