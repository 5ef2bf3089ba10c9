"""The torque lines of a motor at the set-point of a run, from its phase-level model: computed once and cached."""

from __future__ import annotations

from collections.abc import Mapping
from math import copysign
from typing import TYPE_CHECKING

import numpy as np

from torquerig.rig.assembly import Rig
from torquerig.rig.parts.motor import Motor
from torquerig.rig.parts.motor_phases import MotorPhases
from torquerig.rig.steady import steady_torque
from torquerig.rig.terms import Wave

if TYPE_CHECKING:
    from torquerig.machines.control import Control

SMALLEST_DEPTH = 1e-4  # shares of the mean torque below this are left out
LEAST_TORQUE = 0.01  # share of the drive's limit: a ripple relative to no torque is none
REACHED = 0.5  # share of the demanded torque below which lines are counted from the demanded one


def lines_at_set_point(rig: Rig, phases: MotorPhases, control: Control) -> Mapping[int, complex]:
    """Return ``depth exp(j phase)`` by motor order, ``T = T_mean (1 + depth cos(order theta + phase))``.

    Speed and mean torque are those of the run, rounded to four and three digits, so that machine, control, speed and
    torque by value name one result and a rig that changes a little does not ask again. Empty where the run states no
    speed. In a ramp or reversal the lines stay those of the set-point. Where the DC link cannot give the torque, the
    lines are counted from the one demanded.
    """
    from torquerig.machines.ripple_orders import ripple_orders

    speed = rig.run.speed
    if not speed:
        return {}
    torque = _rounded(_demanded(rig, phases.motor, speed), 3)
    found = ripple_orders(phases.machine(), control, speed=_rounded(speed, 4), torque=torque)
    scale = found.mean_torque / torque if abs(found.mean_torque) < REACHED * abs(torque) else 1.0
    return {
        line.order_motor: scale * line.depth * complex(np.exp(1j * line.phase))
        for line in found.lines
        if line.depth > SMALLEST_DEPTH
    }


def as_waves(lines: Mapping[int, complex]) -> tuple[Wave, ...]:
    """Return the lines as the ripple of the drive."""
    return tuple(
        Wave(order=float(order), amplitude=abs(line), phase=float(np.angle(line)))
        for order, line in sorted(lines.items())
        if abs(line) > 0
    )


def _demanded(rig: Rig, motor: str, speed: float) -> float:
    part, torque = rig.part(motor), steady_torque(rig, motor)
    least = LEAST_TORQUE * part.torque_limit if isinstance(part, Motor) else 0.0
    return torque if abs(torque) > least else copysign(least, torque or speed)


def _rounded(value: float, digits: int) -> float:
    return float(f"{value:.{digits}g}")
