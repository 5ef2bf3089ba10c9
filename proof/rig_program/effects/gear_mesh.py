"""Gear mesh: the output's twist gains an error that repeats with every tooth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.effects.visible import just_visible, output_frequency, unit_reading
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Run
from proof.rig_program.transfer import gain_of_twist
from proof.rig_program.waves import OUTPUT_POINTS, angles, slope_of

PLANETS = 3


@dataclass(frozen=True)
class GearMesh(Effect):
    """e(theta) = sum_h e_h cos(h z theta + phi_h) (1 + m cos(n_p theta)) at the output shaft.

    Parameters
    ----------
    teeth : int
        z, the order of the output shaft.
    errors, phases : tuple of float
        e_h zero to peak [rad] and phi_h [rad].
    modulation : float
        m, the share that repeats with the three planets.
    reading : float
        Zero-to-peak amplitude of the first harmonic at the sensor [Nm] in the best steady run.
    """

    kind: ClassVar[str] = "gear_mesh"
    teeth: int
    errors: tuple[float, ...]
    phases: tuple[float, ...]
    modulation: float
    reading: float

    def parameters(self) -> dict[str, float | None]:
        """Order, error and reading of the first harmonic."""
        return {
            "order_output": float(self.teeth),
            "transmission_error_rad": self.errors[0],
            "amplitude_Nm": self.reading,
        }

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Put the error into the gear's spring."""
        turn = angles(OUTPUT_POINTS)
        twist = np.zeros(OUTPUT_POINTS)
        for h, (error, phase) in enumerate(zip(self.errors, self.phases, strict=True), start=1):
            twist += error * np.cos(h * self.teeth * turn + phase)
        twist *= 1.0 + self.modulation * np.cos(PLANETS * turn)
        return machine._replace(twist_table=twist, twist_slope=slope_of(twist))


def draw_gear_mesh(rng: np.random.Generator, setting: Setting, *, size: float) -> GearMesh:
    """Draw teeth of a 5:1 planetary gear or any other, and an error from just visible to 1 mrad or 1 Nm."""
    teeth = int(rng.choice([48, 64, 72, 80, 84, 96, 108, 112, int(rng.integers(25, 150))]))
    while teeth % round(nominal.RATIO) == 0 and teeth // round(nominal.RATIO) in nominal.MOTOR_LINES:
        teeth = int(rng.integers(25, 150))  # a line of the motor has this order: not distinguishable
    at = output_frequency(teeth)
    low = just_visible(setting, at, lambda machine, f, _: gain_of_twist(machine, f))
    per_rad = unit_reading(setting, at, lambda machine, f, _: gain_of_twist(machine, f))
    first = between(low, min(1.0e-3, 1.0 / per_rad), size=size)
    harmonics = int(rng.integers(1, 5))
    shares = [1.0] + [float(rng.uniform(0.05, 0.5)) / h for h in range(1, harmonics)]
    return GearMesh(
        teeth=teeth,
        errors=tuple(first * share for share in shares),
        phases=tuple(float(x) for x in rng.uniform(0.0, 2.0 * np.pi, harmonics)),
        modulation=float(rng.choice([0.0, rng.uniform(0.03, 0.3)])),
        reading=first * per_rad,
    )
