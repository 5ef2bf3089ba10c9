"""Bearing defect: impacts each 1/order of a turn of the output shaft, each of which rings a local mode."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Motion, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class BearingDefect(Effect):
    """Impacts per turn, ring [Hz] with its damping ratio, its first peak [N m], scatter of the gaps, load zone."""

    kind: ClassVar[str] = "bearing_defect"
    mechanical: ClassVar[bool] = False
    order: float
    ring: float
    damping: float
    torque: float
    slip: float
    loaded: float

    def parameters(self) -> dict[str, float | None]:
        """Order and frequency of the ring."""
        return {"order_output": self.order, "ring_frequency_Hz": self.ring}

    def places(self) -> tuple[Place, ...]:
        """Return the band of the ring and the order of the impacts."""
        return (Place("frequency", "Hz", self.ring, 0.2), Place("order", "output_shaft", self.order))

    def on_torque(self, torque: Floats, motion: Motion, rng: np.random.Generator) -> Floats:
        """Add a ring from the instant of every impact."""
        from scipy.signal import oaconvolve

        travel = np.cumsum(np.abs(np.diff(motion.output_angle, prepend=motion.output_angle[0])))
        count = int(travel[-1] * self.order / (2.0 * np.pi)) + 1
        gaps = 2.0 * np.pi / self.order * np.maximum(1.0 + self.slip * rng.standard_normal(count), 0.1)
        places = np.cumsum(gaps) - rng.uniform(0.0, gaps[0])
        frames = np.searchsorted(travel, places[places < travel[-1]])
        kicks = np.zeros(torque.size)
        sizes = 1.0 + self.loaded * np.cos(motion.output_angle[frames]) + 0.1 * rng.standard_normal(frames.size)
        np.add.at(kicks, frames, sizes)
        t = np.arange(int(8.0 / (self.damping * 2.0 * np.pi * self.ring) * motion.rate) + 2) / motion.rate
        w = 2.0 * np.pi * self.ring
        ring = np.exp(-self.damping * w * t) * np.sin(w * t)
        return np.asarray(torque + self.torque * oaconvolve(kicks, ring)[: torque.size])


def draw_bearing_defect(rng: np.random.Generator, setting: Setting) -> BearingDefect | None:
    """Draw a race or ball of a common bearing (order 2.3 to 9, never whole); the ring lies within the bandwidth."""
    highest = min(1.2 * setting.bandwidth, 0.8 * setting.nyquist)
    if highest < 120.0:
        return None
    order = float(rng.uniform(2.3, 9.0))
    while abs(order - round(order)) < 0.06:
        order = float(rng.uniform(2.3, 9.0))
    return BearingDefect(
        part=setting.rig.design.body, order=order, ring=float(rng.uniform(0.3, 1.0) * highest),
        damping=float(rng.uniform(0.01, 0.06)), torque=setting.line_size(rng) * 2.0,
        slip=float(rng.uniform(0.0, 0.012)), loaded=float(rng.choice([0.0, rng.uniform(0.1, 0.6)])),
    )  # fmt: skip
