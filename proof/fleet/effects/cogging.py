"""Cogging: torque between rotor and stator at orders LCM(Q, 2p), Q and 2p of a motor with stated slots."""

from __future__ import annotations

from dataclasses import dataclass
from math import lcm
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.response import sensed_per_torque
from proof.fleet.setting import Setting
from proof.fleet.train import ANGLE, Train


@dataclass(frozen=True)
class Cogging(Effect):
    """Orders of the motor, their torques [N m at the motor] and phases; the first is the largest at the sensor."""

    kind: ClassVar[str] = "cogging"
    orders: tuple[int, ...]
    torques: tuple[float, ...]
    phases: tuple[float, ...]

    def parameters(self) -> dict[str, float | None]:
        """Order of the largest line and its torque at the motor."""
        largest = int(np.argmax(self.torques))
        return {"order_motor": float(self.orders[largest]), "amplitude_Nm": self.torques[largest]}

    def places(self) -> tuple[Place, ...]:
        """Return every order on the motor shaft."""
        return tuple(Place("order", "motor_shaft", float(order)) for order in self.orders)

    def on_train(self, train: Train) -> Train:
        """Add the lines to the motor's table."""
        table = train.motor_table.copy()
        for order, size, phase in zip(self.orders, self.torques, self.phases, strict=True):
            table += size * np.cos(order * ANGLE + phase)
        return train._replace(motor_table=table)


def draw_cogging(rng: np.random.Generator, setting: Setting) -> Cogging | None:
    """Draw native and tolerance lines within the sensor's range; None without any, or without slots."""
    design = setting.rig.design
    if design.motor_kind == "induction":
        return None
    slots, poles = design.parts[design.motor]["slots"], 2 * design.parts[design.motor]["pole_pairs"]
    known = set(design.parts["motor_lines"]["amplitudes"])
    turning = setting.rotation(abs(design.ratio))
    families = [order for order in dict.fromkeys((lcm(slots, poles), slots, poles)) if order not in known]
    highest = min(setting.bandwidth, 0.9 * setting.nyquist)
    orders = [order for order in families if order * turning < highest]
    if not orders:
        return None
    size = setting.line_size(rng)
    torques = []
    for i, order in enumerate(orders):
        gain = abs(sensed_per_torque(setting.train, order * turning, 0, speed=setting.output_speed)) * abs(design.ratio)
        limit = 0.2 * setting.torque / abs(design.ratio)
        torques.append(min(size * (1.0 if i == 0 else float(rng.uniform(0.1, 0.8))) / gain, limit))
    return Cogging(part=design.motor, orders=tuple(orders), torques=tuple(torques),
                   phases=tuple(float(rng.uniform(0.0, 2.0 * np.pi)) for _ in orders))  # fmt: skip
