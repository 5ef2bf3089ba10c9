"""Runs as people make them: one speed, one run-up, several speeds, long ones, a reversal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from proof.fleet.design import Design

MOST_SAMPLES = 400e3  # of a long run, as a file that people still open
PLANS = ("one_speed", "run_up", "two_speeds", "several", "reversal", "long")


@dataclass(frozen=True)
class Run:
    """One recording: set-point of the motor [rad/s, positive], profile, occupancy [%], length [s]."""

    speed: float
    profile: str
    occupancy: int
    duration: float


def draw_plan(rng: np.random.Generator, design: Design, *, plans: tuple[str, ...] = PLANS) -> tuple[str, list[Run]]:
    """Draw the runs of a rig; the name of the plan and the runs."""
    if design.motor_kind == "induction":
        plans = tuple(plan for plan in plans if plan != "reversal") or ("several",)
    plan = str(rng.choice(plans))
    speeds = design.scale.motor_speed * np.array([1.0, float(rng.uniform(0.42, 0.48)), float(rng.uniform(0.68, 0.74))])
    has_levels = "load" in design.parts
    low, high = (int(rng.choice([25, 50])), 100) if has_levels else (0, 0)
    length = _length(rng, design)

    def run(speed: float, profile: str = "steady", occupancy: int = high, duration: float = length) -> Run:
        return Run(float(speed), profile, occupancy, duration)

    top, half, middle = speeds
    return plan, {
        "one_speed": [run(top), run(top, occupancy=low)],
        "run_up": [run(top, "ramp", duration=1.5 * length)],
        "two_speeds": [run(top), run(half), run(top, occupancy=low)],
        "several": [run(top), run(half, occupancy=low), run(middle), run(top, "ramp")],
        "reversal": [run(top), run(half, occupancy=low), run(half, "reversal", occupancy=0), run(top, "ramp")],
        "long": [run(middle, duration=max(length, min(3.0 * length, MOST_SAMPLES / design.sample_rate)))],
    }[plan]


def _length(rng: np.random.Generator, design: Design) -> float:
    """Return the length of a run [s]: shorter at high sample rates, eight turns of the output at half speed or more."""
    usual = float(rng.choice([6.0, 8.0])) if design.sample_rate > 12000.0 else float(rng.choice([8.0, 10.0, 12.0]))
    slow = 0.42 * design.scale.output_speed / (2.0 * np.pi)
    return float(np.clip(8.0 / slow, usual, 20.0))
