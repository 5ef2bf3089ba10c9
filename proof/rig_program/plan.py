"""Plan of runs: test conditions, drawn as an engineer would choose them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np


class Profile(Enum):
    """Course of the speed set-point over a recording."""

    STEADY = "steady"
    RAMP = "ramp"
    REVERSAL = "reversal"


class PlanKind(Enum):
    """Kind of test programme."""

    TYPICAL = "typical"
    TURNING = "turning"
    OTHER = "other"
    ONE_SPEED = "one_speed"


@dataclass(frozen=True)
class Run:
    """Test conditions of one run: motor speed [rpm], occupancy [%], particle size [mm], length [s]."""

    speed: float
    profile: Profile
    occupancy: float
    particle: float = 0.5
    duration: float = 12.0

    @property
    def motor_speed(self) -> float:
        """The set-point in rad/s of the motor."""
        return self.speed * 2.0 * np.pi / 60.0


def draw_plan(rng: np.random.Generator, kind: PlanKind, *, duration: float = 12.0) -> tuple[Run, ...]:
    """Draw four runs of one kind of programme, each ``duration`` [s] long."""
    if kind is PlanKind.TYPICAL:
        rows = [(1000.0, Profile.STEADY, 5.0), (1000.0, Profile.STEADY, 15.0)]
        rows += [(700.0, Profile.STEADY, 5.0), (1400.0, Profile.RAMP, 0.0)]
        return tuple(Run(*row, duration=duration) for row in rows)
    if kind is PlanKind.TURNING:
        rows = [(1000.0, Profile.STEADY, 5.0), (400.0, Profile.STEADY, 0.0)]
        rows += [(600.0, Profile.REVERSAL, 0.0), (1400.0, Profile.RAMP, 0.0)]
        return tuple(Run(*row, duration=duration) for row in rows)
    particle = float(rng.choice([0.2, 0.3, 0.5, 0.8, 1.0, 1.5, 2.0]))
    if kind is PlanKind.ONE_SPEED:
        speed = float(rng.choice([1000.0, 1000.0, _speed(rng)]))
        return tuple(Run(speed, Profile.STEADY, level, particle, duration) for level in (0.0, 5.0, 11.0, 15.0))
    return _other(rng, particle=particle, duration=duration)


def _speed(rng: np.random.Generator) -> float:
    """Draw a speed as one would set it: 300 to 1500 rpm in tens."""
    return float(10 * rng.integers(30, 151))


def _other(rng: np.random.Generator, *, particle: float, duration: float) -> tuple[Run, ...]:
    """Draw two or three steady speeds at different loads, and a ramp or a reversal besides."""
    levels = rng.permutation([0.0, 5.0, 8.0, 11.0, 15.0, 21.0])
    speeds = [_speed(rng) for _ in range(3)]
    while max(speeds) < 1.25 * min(speeds):
        speeds = [_speed(rng) for _ in range(3)]
    steady = [
        Run(speed, Profile.STEADY, float(level), particle, duration)
        for speed, level in zip(speeds, levels, strict=False)
    ]
    if rng.random() < 0.6:
        last = Run(float(100 * rng.integers(8, 16)), Profile.RAMP, float(rng.choice([0.0, 5.0])), particle, duration)
    else:
        last = Run(float(100 * rng.integers(3, 9)), Profile.REVERSAL, float(rng.choice([0.0, 5.0])), particle, duration)
    return (*steady, last)
