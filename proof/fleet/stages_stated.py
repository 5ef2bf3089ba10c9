"""Transmissions as a scenario states them: belt, one to three gear stages, worm."""

from __future__ import annotations

from dataclasses import dataclass
from math import gcd, pi
from typing import Any

import numpy as np

from proof.fleet.scale import Scale
from proof.fleet.stated import Stated

PAIRS = ((17, 51), (18, 72), (19, 57), (20, 64), (16, 60), (21, 55), (23, 71))
PLANETARIES = ((24, 72, 3), (20, 70, 3), (18, 63, 3), (28, 68, 4))  # sun, ring, planets; ring fixed
BELTS = ((20, 40, 110), (24, 48, 120), (22, 55, 130), (18, 54, 120))
WORMS = ((1, 30), (1, 40), (2, 50), (2, 36))


@dataclass(frozen=True)
class Stage:
    """One stage: its name, signed ratio, part of the scenario and how it meshes.

    ``mesh_order`` is the order of its teeth on its output shaft (0: it has none), ``output_turns`` the turns of that
    shaft per turn of the last shaft, ``loss`` the stated loss at full load.
    """

    name: str
    ratio: float
    part: dict[str, Any]
    mesh_order: int
    output_turns: float
    error_periods: int = 1


def state_stages(rng: np.random.Generator, drive: str, scale: Scale) -> list[Stage]:
    """Return the stages of a transmission, from the motor on."""
    if drive == "direct":
        return []
    if drive == "belt":
        return [_belt(rng, scale)]
    if drive == "worm":
        return [_worm(rng, scale)]
    if drive == "one_stage" and rng.random() < 0.5:
        return [_planetary(rng, scale)]
    count = {"one_stage": 1, "two_stage": 2, "three_stage": 3}[drive]
    pairs = [PAIRS[i] for i in rng.choice(len(PAIRS), size=count, replace=False)]
    turns = [1.0]
    for pinion, wheel in reversed(pairs[1:]):
        turns.append(turns[-1] * wheel / pinion)
    names = ["gearbox"] if count == 1 else [f"stage_{i + 1}" for i in range(count)]
    rows = zip(names, pairs, reversed(turns), strict=True)
    return [_pair(rng, scale, name, pair, output_turns=turn) for name, pair, turn in rows]


def _spring(rng: np.random.Generator, scale: Scale, output_turns: float) -> dict[str, Any]:
    """Return stiffness, damping and inertia at the output of a stage whose shaft turns faster than the last one."""
    stiffness = scale.stiffness * float(rng.uniform(2.0, 6.0)) / output_turns**2
    inertia = scale.inertia * float(rng.uniform(0.05, 0.2)) / output_turns**2
    damping = 2.0 * scale.damping * (stiffness * inertia) ** 0.5
    return {
        "stiffness": Stated(stiffness, "N*m/rad", float(rng.choice([0.1, 0.15, 0.2]))),
        "damping": Stated(damping, "N*m*s/rad", 0.3),
        "inertia": Stated(inertia, "kg*m^2", 0.1),
    }


def _pair(rng: np.random.Generator, scale: Scale, name: str, pair: tuple[int, int], *, output_turns: float) -> Stage:
    pinion, wheel = pair
    spring = _spring(rng, scale, output_turns)
    part = {
        "kind": "fixed_axis_gear",
        "teeth": {"pinion": pinion, "wheel": wheel},
        "stiffness": spring["stiffness"],
        "damping": spring["damping"],
        "efficiency": Stated(float(rng.uniform(0.95, 0.98)), "", 0.01),
        "output_inertia": spring["inertia"],
    }
    return Stage(name, -wheel / pinion, part, wheel, output_turns)


def _planetary(rng: np.random.Generator, scale: Scale) -> Stage:
    sun, ring, planets = PLANETARIES[int(rng.integers(len(PLANETARIES)))]
    spring = _spring(rng, scale, 1.0)
    part = {
        "kind": "planetary_gear",
        "teeth": {"sun": sun, "ring": ring, "planets": planets},
        "stiffness": spring["stiffness"],
        "damping": spring["damping"],
        "efficiency": Stated(float(rng.uniform(0.94, 0.97)), "", 0.01),
        "output_inertia": spring["inertia"],
    }
    return Stage("gearbox", 1.0 + ring / sun, part, ring, 1.0)


def _belt(rng: np.random.Generator, scale: Scale) -> Stage:
    pinion, wheel, teeth = BELTS[int(rng.integers(len(BELTS)))]
    spring = _spring(rng, scale, 1.0)
    pitch = 0.005
    radius = wheel * pitch / (2.0 * pi)
    strand = _free_strand(pinion, wheel, teeth) * pitch
    part = {
        "kind": "belt",
        "pinion_teeth": pinion,
        "wheel_teeth": wheel,
        "belt_teeth": teeth,
        "pitch": "5 mm",
        "belt_stiffness": Stated(spring["stiffness"].value * strand / (2.0 * radius**2), "N", 0.15),
        "strand_damping": Stated(spring["damping"].value / (2.0 * radius**2), "N*s/m", 0.3),
        "efficiency": Stated(float(rng.uniform(0.96, 0.98)), "", 0.01),
        "wheel_inertia": spring["inertia"],
    }
    return Stage("belt", wheel / pinion, part, 0, 1.0, error_periods=teeth // gcd(wheel, teeth))


def belt_spring(part: dict[str, Any]) -> tuple[float, float]:
    """Return stiffness [N m/rad] and damping [N m s/rad] of a true belt at its output pulley."""
    radius = part["wheel_teeth"] * 0.005 / (2.0 * pi)
    strand = _free_strand(part["pinion_teeth"], part["wheel_teeth"], part["belt_teeth"]) * 0.005
    return 2.0 * part["belt_stiffness"] / strand * radius**2, 2.0 * part["strand_damping"] * radius**2


def _free_strand(pinion: int, wheel: int, teeth: int) -> float:
    """Return the free strand of an open belt [pitches], from its length; bisection over the centre distance."""
    small, large = pinion / (2.0 * pi), wheel / (2.0 * pi)
    low, high = large - small + 1e-9, float(teeth)
    for _ in range(80):
        middle = 0.5 * (low + high)
        wrap = np.arcsin((large - small) / middle)
        length = 2.0 * middle * np.cos(wrap) + pi * (small + large) + 2.0 * wrap * (large - small)
        low, high = (middle, high) if length < teeth else (low, middle)
    return float(np.sqrt(middle**2 - (large - small) ** 2))


def _worm(rng: np.random.Generator, scale: Scale) -> Stage:
    starts, wheel = WORMS[int(rng.integers(len(WORMS)))]
    spring = _spring(rng, scale, 1.0)
    part = {
        "kind": "worm_gear",
        "starts": starts,
        "wheel_teeth": wheel,
        "lead_angle": f"{rng.uniform(6.0, 12.0):.3g} deg",
        "forward_efficiency": Stated(float(rng.uniform(0.6, 0.8)), "", 0.03),
        "stiffness": spring["stiffness"],
        "damping": spring["damping"],
        "wheel_inertia": spring["inertia"],
    }
    return Stage("worm", wheel / starts, part, wheel, 1.0)
