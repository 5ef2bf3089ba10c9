"""Bearing defect: impacts at a non-integer order of the output shaft, each of which rings a local mode."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.laws import SAME_LAWS
from proof.rig_program.machine import GEAR, RING_AT_SENSOR, Machine, machine_of
from proof.rig_program.plan import Run
from proof.rig_program.transfer import gain_of


@dataclass(frozen=True)
class BearingDefect(Effect):
    """Impacts each 1/order of a turn, with a little slip of the rolling elements, that ring a mode.

    Parameters
    ----------
    order : float
        Impacts per turn of the output shaft.
    ring_frequency, ring_damping : float
        Of the local mode [Hz], ratio.
    torque : float
        Peak of one ring [Nm].
    node : int
        The mass that the ring acts on, or the sensor itself.
    slip : float
        Relative scatter of the angle between impacts.
    loaded : float
        Share by which the impacts swell and fall once in a turn.
    """

    kind: ClassVar[str] = "bearing_defect"
    order: float
    ring_frequency: float
    ring_damping: float
    torque: float
    node: int
    slip: float
    loaded: float

    def parameters(self) -> dict[str, float | None]:
        """Order and frequency of the ring."""
        return {"order_output": self.order, "ring_frequency_Hz": self.ring_frequency}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Lay the impacts on the way that the shaft will turn."""
        turns = 1.3 * (run.duration + nominal.SETTLING) * run.motor_speed / nominal.RATIO / (2.0 * np.pi)
        count = max(int(turns * self.order), 1)
        gaps = (2.0 * np.pi / self.order) * (1.0 + self.slip * rng.standard_normal(count))
        travel = np.cumsum(gaps) + float(rng.uniform(0.0, 2.0 * np.pi / self.order))
        sizes = self.torque * (1.0 + self.loaded * np.cos(travel)) * (1.0 + 0.1 * rng.standard_normal(count))
        return machine._replace(
            ring=2.0 * np.pi * self.ring_frequency,
            ring_damping=self.ring_damping,
            ring_node=self.node,
            impact_travel=travel,
            impact_size=sizes,
        )


def draw_bearing_defect(rng: np.random.Generator, setting: Setting, *, size: float) -> BearingDefect:
    """Draw races and balls of common bearings (orders 2.3 to 9, never whole); rings of 12 mV to 0.8 V peak."""
    order = float(rng.uniform(2.3, 9.0))
    while abs(order - round(order)) < 0.06:
        order = float(rng.uniform(2.3, 9.0))
    reading = between(0.012, 0.8, size=size)
    node = int(rng.choice([RING_AT_SENSOR, RING_AT_SENSOR, GEAR]))
    frequency = float(rng.uniform(300.0, 2800.0)) if node == RING_AT_SENSOR else float(rng.uniform(450.0, 1000.0))
    machine = machine_of(setting.rig, SAME_LAWS)
    gain = 1.0 if node == RING_AT_SENSOR else gain_of(machine, frequency, GEAR)
    return BearingDefect(
        order=order,
        ring_frequency=frequency,
        ring_damping=float(rng.uniform(0.01, 0.06)),
        torque=reading / gain,
        node=node,
        slip=float(rng.uniform(0.0, 0.012)),
        loaded=float(rng.choice([0.0, rng.uniform(0.1, 0.6)])),
    )
