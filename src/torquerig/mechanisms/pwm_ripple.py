"""PWM ripple: torque ripple at the switching frequency of the inverter, and its small part that reaches the sensor."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts.motor_phases import phases_of
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.terms import Inertia, Spring
from torquerig.sensor_stages.tone import Tone


@dataclass(frozen=True, kw_only=True)
class PwmRipple(Part):
    """``dI = U_dc / (8 L f)`` and ``T = 3/2 p lambda dI`` at the switching frequency, whatever the speed.

    At 4 to 40 kHz the shafts are free masses: the rig's springs let through what ``(K + j w C - w^2 M)^-1`` says, some
    1e-4 of it or less, which is put on the sensor's signal before its amplifier. There the samples show it folded, and
    the amplifier's low-pass meets it folded as well, so that the line is an upper bound. What the cable picks up of
    the switching is larger by far: pwm_aliasing.

    Source: Holmes & Lipo 2003, Pulse Width Modulation for Power Converters. The size is that of a leg at half its
    duty; the side lines at multiples of the electrical frequency are not in here.
    """

    kind: Literal["pwm_ripple"] = "pwm_ripple"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    switching_frequency: Annotated[float, Parameter("Hz", "switching frequency", above=0)]
    phase: float | None = None

    def motor_torque(self, rig: Rig) -> float:
        """Return the ripple of the torque between rotor and frame, zero to peak [N m]."""
        phases = phases_of(rig, self.at)
        return phases.torque_per_ampere * phases.dc_link / (8 * phases.phase_inductance * self.switching_frequency)

    def sensor_torque(self, rig: Rig) -> float:
        """Return the ripple in the measured spring, zero to peak [N m]; gaps are taken as closed."""
        terms = [term for part in rig.parts if part is not self for term in part.terms(rig)]
        inertias = [term for term in terms if isinstance(term, Inertia) and term.inertia > 0]
        springs = [term for term in terms if isinstance(term, Spring)]
        row = {name: k for k, name in enumerate(dict.fromkeys(term.node for term in inertias))}
        s = 2j * pi * self.switching_frequency
        dynamic = np.zeros((len(row), len(row)), dtype=np.complex128)
        for term in inertias:
            dynamic[row[term.node], row[term.node]] += s**2 * term.inertia
        twists = {spring.name: _twist(spring, row) for spring in springs}
        for spring in springs:
            twist = twists[spring.name]
            dynamic += (spring.stiffness + s * spring.damping) * np.outer(twist, twist)
        torque = np.zeros(len(row))
        torque[row[rig.node(self.at)]] = self.motor_torque(rig)
        angles = np.linalg.solve(dynamic, torque)
        measured = next(spring for spring in springs if spring.name == rig.measured)
        return float(abs((measured.stiffness + s * measured.damping) * (twists[measured.name] @ angles)))

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the tone in the measured torque."""
        sensor = rig.part(rig.measured)
        sensitivity = sensor.sensitivity if isinstance(sensor, AmplifiedTorqueSensor) else 1.0
        tone = Tone(
            frequency=self.switching_frequency,
            amplitudes=(self.sensor_torque(rig) * sensitivity,),
            phases=() if self.phase is None else (self.phase,),
            source=self.name,
        )
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=tone),)


def _twist(spring: Spring, row: dict[str, int]) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    twist = np.zeros(len(row))
    for node, turns in ((spring.a, 1 / spring.ratio), (spring.b, -1.0)):
        if node in row:
            twist[row[node]] += turns
    return twist
