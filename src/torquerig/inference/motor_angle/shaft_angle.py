"""What angle the motor turned through in each run: measured, followed in the torque's lines, or simulated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from statistics import median

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motor_angle.speed_factor import speed_factor
from torquerig.linear_twin.field_speed import share_of_field
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import TorqueRipple
from torquerig.orders.angle.measured_angle import MotorAngle
from torquerig.orders.angle.speed_from_torque import motor_angle_from_torque
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.orders.angle.wide_speed_search import wide_speed_search
from torquerig.parallel import parallel_map
from torquerig.recordings.recording import Recording
from torquerig.recordings.set_point import set_point_speed
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.simulation.simulator import simulate

_NEAR = 0.013  # [1] a set-point off by more is out of the reach of those who follow the lines around it
_STRAYED = 0.02  # [1] from the speed that the sheet or the comb of all lines tells
_FOLLOWED = 0.005  # [1] half the 95 % interval of the speed; a wider one does not tell it
_WANDERS, _ANOTHER = 1e-3, 0.03  # [1] from the factor of the rig: less is how a speed wanders, more no error of scale


@dataclass(frozen=True)
class ShaftAngle:
    """Angle of the motor at each sample [rad], shape (samples,), whether it was measured, and how it was got.

    ``factor`` is the real speed over its set-point.
    """

    values: NDArray[np.float64]
    measured: bool
    origin: str
    factor: float = 1.0


def shaft_angles(recordings: Sequence[Recording], rig: Rig, *, also: Sequence[float] = ()) -> list[ShaftAngle]:
    """Return the angle of each run.

    ``also`` are orders of the motor that stand out beside those that the rig's kinematics know.

    Most drives have one error of scale: the factor by which the rig's speeds differ from their set-points is the median
    over the steady runs whose angle was measured or followed, and a run has another one only where it clearly differs.
    The slip of an induction motor is no such error: it depends on the load of each run. A ramp or reversal without an
    encoder, or a run whose lines do not stand out, turns as the nominal rig does when its set-point is scaled by that
    factor, or by the one along which its lines stand out; its ripple is left out, for nobody knows at which phase it
    moves the shaft.
    """
    found = parallel_map(partial(_told, rig=rig, also=also), recordings)
    pairs = [*zip(recordings, found, strict=True)]
    shares = [share_of_field(rig, run.run) if _asked(run) else 1.0 for run in recordings]
    factors = [angle.factor / share for (run, angle), share in zip(pairs, shares, strict=True)
               if angle is not None and _asked(run)]  # fmt: skip
    factor = median(factors) if factors else 1.0
    return [
        _simulated(run, rig, factor, also, share=share) if angle is None
        else _scaled(angle, factor * share, own=bool(_asked(run)))
        for (run, angle), share in zip(pairs, shares, strict=True)
    ]  # fmt: skip


def _asked(recording: Recording) -> float | None:
    """Return the speed that the sheet asks of a steady run [rad/s]."""
    return (recording.run.speed or None) if recording.run.profile == "steady" else None


def _scaled(angle: ShaftAngle, factor: float, *, own: bool) -> ShaftAngle:
    """Return the angle with the factor of the rig, or its ``own`` where that is another."""
    another = own and _WANDERS < abs(angle.factor / factor - 1) < _ANOTHER
    return angle if another else replace(angle, factor=factor)


def _told(recording: Recording, *, rig: Rig, also: Sequence[float]) -> ShaftAngle | None:
    """Return the angle that was measured or, in a steady run, is followed."""
    asked = _asked(recording)
    angle = recorded_motor_angle(recording, ratio=kinematics_of(rig).ratio)
    measured = angle is not None
    if angle is None and asked:
        angle = _followed(recording, rig, also)
    if angle is None:
        return None
    factor = angle.mean_speed(recording.sample_rate) / asked if asked else 1.0
    return ShaftAngle(angle.values, measured, angle.origin, factor)


def _followed(recording: Recording, rig: Rig, also: Sequence[float]) -> MotorAngle | None:
    """Return the angle of a steady run by the lines of its torque; None where none stand out: other runs know more."""
    run = recording.run
    stated = run.speed or 0.0
    known = [line.order for line in Twin(rig.at(run)).lines()]
    told = wide_speed_search(recording.torque(), recording.sample_rate, set_point=stated, orders=[*known, *also])
    if told is not None and abs(told / stated - 1) > _NEAR:
        recording = replace(recording, run=replace(run, speed=told))
    angle = motor_angle_from_torque(recording, kinematics_of(rig).lines(), also=also, largest_deviation=_STRAYED)
    return angle if angle.half_width < _FOLLOWED else None


def _simulated(recording: Recording, rig: Rig, factor: float, also: Sequence[float], *, share: float) -> ShaftAngle:
    run = replace(recording.run, speed=set_point_speed(recording, "recordings without an angle channel") * factor)
    orders = [*(line.order for line in Twin(rig.at(run)).lines()), *also]
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitudes={}))
    turned = simulate(rig.at(run), duration=recording.duration, seed=0, sample_rate=recording.sample_rate)
    angle = turned.channels["true_motor_angle_rad"].values
    if run.profile != "steady":
        own = speed_factor(recording.torque(), recording.sample_rate, angle, orders, expected=factor)
        angle, factor = angle * own, factor * own
    return ShaftAngle(angle, False, f"simulated from the set-point times {factor:.5f}", factor * share)
