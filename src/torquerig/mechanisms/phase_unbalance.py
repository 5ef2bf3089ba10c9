"""Phase unbalance: one phase of the motor, its cable or connector differs, which causes a torque line of order 2p."""

from __future__ import annotations

from cmath import exp, phase
from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts.motor_phases import phases_of
from torquerig.rig.terms import Term, Wave

Ohms = Annotated[float, Parameter("ohm", "extra resistance of a phase")]
Henries = Annotated[float, Parameter("H", "extra inductance of a phase")]


@dataclass(frozen=True, kw_only=True)
class PhaseUnbalance(Part):
    """``T = T_motor (1 + |d| cos(2 p theta + arg d))``, ``d = Y(2 f_e) / 3 sum_x (dR_x + j w_e dL_x) exp(-4j pi x/3)``.

    The unequal drops are a voltage of negative sequence, at twice the electrical frequency seen from the rotor; the
    current loop lets Y of it become current. A fast loop, or a slow motor, moves the line from the torque into the
    voltage; equal extras of all phases make none. A variant of commutation_ripple, and of current_gain by its order.

    Source: signatures.md 2.4 (Hang et al. 2016, IEEE Trans. Power Electronics). To first order in the unbalance, under
    field-oriented control; the size is that of the set-point's speed.
    """

    kind: Literal["phase_unbalance"] = "phase_unbalance"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    extra_resistance: tuple[Ohms, Ohms, Ohms] = (0.0, 0.0, 0.0)
    extra_inductance: tuple[Henries, Henries, Henries] = (0.0, 0.0, 0.0)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive carries the ripple; InputError where nothing is known of the motor's phases."""
        phases_of(rig, self.at)
        return ()

    def line(self, rig: Rig) -> complex:
        """Return depth and phase as one complex number."""
        phases = phases_of(rig, self.at)
        electrical = phases.pole_pairs * abs(rig.run.speed or 0.0)
        drops = zip(self.extra_resistance, self.extra_inductance, strict=True)
        unequal = sum((r + 1j * electrical * l) * exp(-4j * pi * x / 3) for x, (r, l) in enumerate(drops))
        return complex(phases.admittance(electrical / pi) * unequal / 3)

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple of the motor's torque; none where the phases are alike."""
        if not any((*self.extra_resistance, *self.extra_inductance)):
            return ()
        line, order = self.line(rig), 2.0 * phases_of(rig, self.at).pole_pairs
        return (DriveRipple((Wave(order=order, amplitude=abs(line), phase=phase(line)),)),) if line else ()
