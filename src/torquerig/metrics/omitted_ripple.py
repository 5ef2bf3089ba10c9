"""Commutation ripple of a motor's class that the motor's known lines omit."""

from __future__ import annotations

from math import pi, sqrt
from typing import TYPE_CHECKING

import numpy as np

from torquerig.catalog.entry import counts_of
from torquerig.metrics.figure import Figure
from torquerig.rig.parts import SpeedController
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower

if TYPE_CHECKING:
    from torquerig.catalog.motor import Motor
    from torquerig.rig.assembly import Rig


def omitted_six_pulse(rig: Rig, motor: Motor, *, motor_torque: float) -> Figure:
    """Return the rms at the sensor of the six-pulse ripple that is not simulated [N m]; unknown where none is omitted.

    ``depth x motor torque / sqrt(2) x |transfer|``: depth from the catalog's interval for the class, the transfer from
    a torque on the rotor to the sensor by the linear twin with its speed loop closed, at motor order 6 p of the run's
    speed. Only the fundamental; the shafts attenuate the higher harmonics.

    Parameters
    ----------
    motor_torque : float
        Mean torque of the motor [N m].
    """
    if rig.of_kind("six_step_commutation"):
        return Figure(unit="N*m")
    share, known = motor.ripple.six_pulse_ripple, motor.ripple.known_lines
    poles = counts_of(motor.pole_pairs)
    if known is None or share.unknown or not poles or 6 * poles[0] in known.electrical or not rig.run.speed:
        return Figure(unit="N*m")
    controller = rig.parts_of(SpeedController)[0]
    frequency = np.array([6 * poles[0] * abs(rig.run.speed) / (2 * pi)])
    passed = spring_response(lower(rig, 0), rig.measured, frequency, speed_loop=True)
    gain = float(abs(passed[rig.node(controller.motor)][0])) * motor_torque / sqrt(2)
    low, high = (gain * end for end in share.bounds)
    source = f"linear twin at {frequency[0]:.0f} Hz, {share.source} ({share.evidence})"
    return Figure(low=low, high=high, unit="N*m", source=source)
