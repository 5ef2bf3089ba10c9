"""Dead time: the inverter's pause at switching is a voltage drop, six steps per electrical turn."""

from __future__ import annotations

from cmath import phase
from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts.motor_phases import MotorPhases, phases_of
from torquerig.rig.terms import HarmonicTorque, Term, Wave

MULTIPLES = (1, 2, 3)  # of order 6p; the line at 24p has a fifteenth of the volts of the first


@dataclass(frozen=True, kw_only=True)
class DeadTime(Part):
    """``dV = U_dc t_d / T_pwm`` against each phase current; its 5th and 7th harmonic are a torque of order 6p.

    On the axis of the torque the square wave has ``(4/pi) dV (1/(6k-1) - 1/(6k+1)) cos(6 k p theta)``; the current
    loop turns it into current by its admittance Y and the magnets into torque by 3/2 p lambda. Independent of load;
    grows with speed up to the loop's bandwidth. A variant of commutation_ripple under field-oriented control.

    Source: Jeong & Park 1991, IEEE Trans. Industrial Electronics 38(2). True while the current is well above its
    ripple and the line below a fifth of the loop's bandwidth; the size is that of the set-point's speed.
    """

    kind: Literal["dead_time"] = "dead_time"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    dead_time: Annotated[float, Parameter("s", "dead time of a leg that nothing compensates", low=0)]

    def volts(self, phases: MotorPhases) -> float:
        """Return the mean voltage drop of a phase [V]."""
        return phases.dc_link * self.dead_time / phases.control_period

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the lines between rotor and frame; InputError where nothing is known of the motor's phases."""
        node, phases = rig.node(self.at), phases_of(rig, self.at)
        speed = abs(rig.run.speed or 0.0)
        waves = []
        for k in MULTIPLES:
            order = 6 * k * phases.pole_pairs
            volts = 4 / pi * self.volts(phases) * (1 / (6 * k - 1) - 1 / (6 * k + 1))
            line = phases.torque_per_ampere * volts * phases.admittance(order * speed / (2 * pi))
            if line:
                waves.append(Wave(order=float(order), amplitude=abs(line), phase=phase(line)))
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=tuple(waves)),)
