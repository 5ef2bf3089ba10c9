"""Strangers of stiffness, friction and load: a spring that softens, friction with a kink, build-up and release."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from proof.fleet.effect import Floats, Motion
from proof.fleet.scale import RPM
from proof.fleet.setting import Setting
from proof.fleet.settling import first_mode
from proof.strangers.stranger import Stranger


@dataclass(frozen=True)
class SofteningSpring(Stranger):
    """A coupling that loses 15 to 50 % of its stiffness while it warms up, in every recording anew."""

    kind: ClassVar[str] = "softening_spring"
    domain: ClassVar[str] = "frequency"
    axis: ClassVar[str] = "Hz"
    width: ClassVar[float] = 0.3

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the factor of the stiffness."""
        share = 1.0 - np.exp(-2.5 * np.clip(motion.time / motion.duration, 0.0, 1.0))
        return {"soft": 1.0 - self.size * share}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw the loss; the place is the first torsional mode."""
        return cls(part=setting.rig.design.coupling, at=first_mode(setting.train), size=float(rng.uniform(0.15, 0.5)))


class BreathingSpring(SofteningSpring):
    """A coupling whose stiffness swings by 10 to 40 % every 1.5 to 3 s."""

    kind: ClassVar[str] = "breathing_spring"

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the factor of the stiffness."""
        return {"soft": 1.0 + self.size * np.sin(2.0 * np.pi * motion.time * self.phase)}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw swing and period; ``phase`` holds its frequency [Hz]."""
        return cls(part=setting.rig.design.coupling, at=first_mode(setting.train), size=float(rng.uniform(0.1, 0.4)),
                   phase=1.0 / float(rng.uniform(1.5, 3.0)))  # fmt: skip


class TwoSlopeFriction(Stranger):
    """Friction that starts to grow with the speed above a kink; ``at`` is the kink [rpm of the output]."""

    kind: ClassVar[str] = "two_slope_friction"
    domain: ClassVar[str] = "speed"
    axis: ClassVar[str] = "rpm"
    width: ClassVar[float] = 1.0

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the friction: ``size`` at the highest speed."""
        kink, top = self.at * RPM, self.more[0]
        above = np.maximum(np.abs(motion.output_speed) - kink, 0.0) / (top - kink)
        return {"push_load": -self.size * above * np.sign(motion.output_speed)}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw kink and size; None where no run changes its speed over the range."""
        if not any(run.profile == "ramp" for run in setting.rig.runs):
            return None
        top = setting.output_speed
        return cls(part=setting.rig.design.body, at=top * float(rng.uniform(0.4, 0.65)) / RPM,
                   size=setting.torque * float(10.0 ** rng.uniform(-1.5, -0.4)), more=(top,))  # fmt: skip


class SpeedWindowTorque(TwoSlopeFriction):
    """Resistance in a window of speeds only, as of a membrane that flutters; ``at`` is its middle [rpm]."""

    kind: ClassVar[str] = "speed_window_torque"
    width: ClassVar[float] = 0.2

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the resistance."""
        middle = self.at * RPM
        return {
            "push_load": -self.size * np.exp(-0.5 * ((np.abs(motion.output_speed) - middle) / (0.07 * middle)) ** 2)
        }


class BuildUpAndRelease(Stranger):
    """Resistance that builds up for 0.4 to 1.6 s and breaks off, at random instants: clumps."""

    kind: ClassVar[str] = "build_up_and_release"
    domain: ClassVar[str] = "distribution"
    axis: ClassVar[str] = "V"
    width: ClassVar[float] = 1.0

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return the saw of random period."""
        gaps = rng.uniform(0.4, 1.6, int((motion.time[-1] - motion.time[0]) / 0.4) + 2)
        edges = motion.time[0] + np.concatenate([[0.0], np.cumsum(gaps)])
        index = np.searchsorted(edges, motion.time, side="right") - 1
        return {"push_load": -self.size * (motion.time - edges[index]) / gaps[index]}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Draw 3 to 40 % of the rated torque."""
        return cls(part=setting.rig.design.body, at=0.0, size=setting.torque * float(10.0 ** rng.uniform(-1.5, -0.4)))
