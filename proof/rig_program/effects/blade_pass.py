"""Blade pass: each blade of the wear part meets the bed once in a turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.effects.visible import just_visible, output_frequency
from proof.rig_program.machine import WEAR, Machine
from proof.rig_program.plan import Run
from proof.rig_program.transfer import gain_of
from proof.rig_program.waves import OUTPUT_POINTS, angles

FIRST_HARMONIC = 4.0 / (3.0 * np.pi)  # of max(0, cos x)^2


@dataclass(frozen=True)
class BladePass(Effect):
    """Load torque += A max(0, cos(b theta))^2 [Nm]."""

    kind: ClassVar[str] = "blade_pass"
    blades: int
    amplitude: float

    def parameters(self) -> dict[str, float | None]:
        """Blades and amplitude."""
        return {"order_output": float(self.blades), "amplitude_Nm": self.amplitude}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Add the blades to the load."""
        wave = np.maximum(0.0, np.cos(self.blades * angles(OUTPUT_POINTS))) ** 2
        return machine._replace(blade_table=self.amplitude * wave)


def draw_blade_pass(rng: np.random.Generator, setting: Setting, *, size: float) -> BladePass:
    """Draw 6 to 16 blades, where no line of the wear part or the motor lies, and from just visible to 2 Nm."""
    blades = int(rng.choice([6, 7, 8, 9, 11, 12, 13, 14, 16]))
    low = just_visible(
        setting, output_frequency(blades), lambda machine, f, _: FIRST_HARMONIC * gain_of(machine, f, WEAR)
    )
    return BladePass(blades, between(max(low, 0.01), 2.0, size=size))
