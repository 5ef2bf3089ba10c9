"""Strangers that are locked to a shaft: torque on the body by its angle, at orders that no part of a rig has."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from proof.fleet.effect import Floats, Motion
from proof.fleet.setting import Setting
from proof.strangers.stranger import Stranger, any_phase, load_size, uneven_order


@dataclass(frozen=True)
class OrderLine(Stranger):
    """A torque at an order of the output shaft; kinds differ in how its amplitude and phase change."""

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the torque on the body."""
        wave = np.cos(self.at * motion.output_angle + self.phase + self.shift(motion))
        return {"push_load": self.size * self.growth(motion) * wave}

    def growth(self, motion: Motion) -> Floats | float:
        """Return the factor of the amplitude over time."""
        return 1.0

    def shift(self, motion: Motion) -> Floats | float:
        """Return the shift of the phase over time [rad]."""
        return 0.0

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw an order between 2.3 and 9.8."""
        order = uneven_order(rng, 2.3, 9.8)
        size = load_size(rng, setting, order * setting.rotation())
        return cls(
            part=setting.rig.design.body,
            at=order,
            size=size,
            phase=any_phase(rng),
            more=(float(rng.uniform(0.3, 1.5)),),
        )


class IrrationalOrder(OrderLine):
    """A line at an irrational order."""

    kind: ClassVar[str] = "irrational_order"


class GrowingLine(OrderLine):
    """A line that grows from nothing to twice its mean over the run."""

    kind: ClassVar[str] = "growing_line"

    def growth(self, motion: Motion) -> Floats | float:
        """Return a straight rise."""
        return np.clip(2.0 * motion.time / motion.duration, 0.0, 2.0)


class PhaseModulatedLine(OrderLine):
    """A line whose phase sways by 0.8 rad at 0.3 to 1.5 Hz."""

    kind: ClassVar[str] = "phase_modulated_line"

    def shift(self, motion: Motion) -> Floats | float:
        """Return the sway."""
        return 0.8 * np.sin(2.0 * np.pi * self.more[0] * motion.time)


class FadingLine(OrderLine):
    """A line that comes and goes with a period of 0.7 to 3 s."""

    kind: ClassVar[str] = "fading_line"

    def growth(self, motion: Motion) -> Floats | float:
        """Return the swell."""
        return np.asarray(np.sqrt(2.0) * np.maximum(np.sin(2.0 * np.pi * self.more[0] * motion.time), 0.0) + 0.2)


class BeatingBelt(OrderLine):
    """Two lines 3 % apart, as two belts of unequal length side by side."""

    kind: ClassVar[str] = "beating_belt"
    width: ClassVar[float] = 0.05

    def growth(self, motion: Motion) -> Floats | float:
        """Return the beat of both."""
        return np.asarray(np.cos(0.015 * self.at * motion.output_angle) * np.sqrt(2.0))


class HalfOrders(OrderLine):
    """Orders 1/2, 3/2 and 5/2 of a loose fit; the strongest is named."""

    kind: ClassVar[str] = "half_orders"

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the three lines."""
        angle = motion.output_angle + self.phase
        return {"push_load": self.size * (np.cos(1.5 * angle) + 0.5 * np.cos(0.5 * angle) + 0.4 * np.cos(2.5 * angle))}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw the size."""
        size = load_size(rng, setting, 1.5 * setting.rotation())
        return cls(part=setting.rig.design.body, at=1.5, size=size, phase=any_phase(rng))


class IntermittentRub(OrderLine):
    """A rub of 20 degrees once in three turns: a family of thirds of an order."""

    kind: ClassVar[str] = "intermittent_rub"

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the resistance of the rub."""
        place = np.mod(motion.output_angle + self.phase, 6.0 * np.pi)
        inside = np.where(place < 0.35, np.sin(np.pi * place / 0.35) ** 2, 0.0)
        return {
            "push_load": -self.size
            * inside
            * np.tanh(motion.output_speed / (1e-3 + 0.01 * np.abs(motion.output_speed).max()))
        }

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw the size: 5 to 100 % of the rated torque."""
        size = setting.torque * float(10.0 ** rng.uniform(-1.3, 0.0))
        return cls(part=setting.rig.design.body, at=1.0 / 3.0, size=size, phase=any_phase(rng))


class GainByAngle(OrderLine):
    """A sensor whose gain varies with its angle at an uneven order: a line in proportion to the torque."""

    kind: ClassVar[str] = "gain_by_angle"
    mechanical: ClassVar[bool] = False
    acts_as: ClassVar[str] = "signal"

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return nothing: the torque stays."""
        return {}

    def on_torque(self, torque: Floats, motion: Motion, rng: np.random.Generator) -> Floats:
        """Let the gain vary."""
        return np.asarray(torque * (1.0 + self.size * np.cos(self.at * motion.output_angle + self.phase)))

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw a share of 0.1 to 8 %."""
        order = uneven_order(rng, 2.3, 9.8)
        return cls(
            part=setting.rig.design.sensor, at=order, size=float(10.0 ** rng.uniform(-3.0, -1.1)), phase=any_phase(rng)
        )
