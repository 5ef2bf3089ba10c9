"""In no library: a line locked to an irrational order of the wear part whose phase jumps."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.effects.visible import just_visible, output_frequency, unit_reading
from proof.rig_program.forcing import Forcing
from proof.rig_program.machine import WEAR, Machine
from proof.rig_program.plan import Run
from proof.rig_program.transfer import gain_of


@dataclass(frozen=True)
class JumpingLine(Effect):
    """Torque [Nm] at this order of the wear part; its phase jumps anywhere, so often in a second."""

    kind: ClassVar[str] = "jumping_line"
    in_library: ClassVar[bool] = False
    order: float
    torque: float
    jumps_per_second: float

    def parameters(self) -> dict[str, float | None]:
        """Order, torque and jumps."""
        return {"order_output": self.order, "amplitude_Nm": self.torque, "jumps_per_s": self.jumps_per_second}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Return the wear part the line."""
        return machine._replace(line_order=self.order, line_torque=self.torque)

    def on_forcing(self, forcing: Forcing, run: Run, rng: np.random.Generator) -> Forcing:
        """Let its phase jump."""
        jumps = rng.random(forcing.samples) < self.jumps_per_second / nominal.SAMPLE_RATE
        phases = rng.uniform(0.0, 2.0 * np.pi, int(jumps.sum()) + 1)
        return replace(forcing, line_phase=phases[np.cumsum(jumps)])


def draw_jumping_line(rng: np.random.Generator, setting: Setting, *, size: float) -> JumpingLine:
    """Draw an order of 10 to 40 between whole ones, from well visible to a reading of 0.6 V."""
    order = float(int(rng.integers(10, 40)) + rng.uniform(0.2, 0.8))
    at = output_frequency(order)

    def gain(machine: Machine, frequency: float, _: Run) -> float:
        return gain_of(machine, frequency, WEAR)

    low = 2.0 * just_visible(setting, at, gain)
    torque = between(low, 0.6 / unit_reading(setting, at, gain), size=size)
    return JumpingLine(order, torque, float(rng.uniform(1.0, 5.0)))
