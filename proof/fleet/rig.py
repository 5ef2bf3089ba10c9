"""One rig of the fleet: its design, true numbers, laws, runs and hidden effects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from proof.fleet.design import Design, draw_design
from proof.fleet.effect import Effect
from proof.fleet.laws import FleetLaws, draw_laws
from proof.fleet.plans import PLANS, Run, draw_plan
from proof.fleet.scale import RPM
from proof.fleet.stated import true_over_stated, true_values, written


@dataclass(frozen=True)
class FleetRig:
    """A drawn rig, ready to be recorded.

    Parameters
    ----------
    name : str
    seed : tuple of int
        Of everything random in its runs.
    truth : dict
        The parts with true numbers.
    plan : str
    runs : tuple of Run
    effects : tuple of Effect
    speed_error, wander : float
        Relative error and slow wander of the speed.
    gain_error, zero : float
        Of the torque sensor, relative and [N m].
    angle_zero : float
        Motor angle at the first sample [rad].
    """

    name: str
    seed: tuple[int, ...]
    design: Design
    truth: dict[str, Any]
    laws: FleetLaws
    plan: str
    runs: tuple[Run, ...]
    effects: tuple[Effect, ...] = ()
    speed_error: float = 0.0
    wander: float = 0.0
    gain_error: float = 0.0
    zero: float = 0.0
    angle_zero: float = 0.0

    def scenario(self) -> dict[str, Any]:
        """Return the scenario as the rig's owner writes it."""
        design = self.design
        first = self.runs[0]
        point: dict[str, Any] = {"motor_speed": f"{np.sign(design.ratio) * first.speed / RPM:.6g} rpm"}
        if "load" in design.parts:
            point["load"] = {"occupancy": f"{first.occupancy} %"}
        if first.profile != "steady":
            point["profile"] = first.profile
        return {
            "scenario": f"{design.load_kind} on {design.drive.replace('_', ' ')}, {design.motor_kind}",
            "operating_point": point | {"speed_set_point_error_max": 0.005, "slow_speed_wander": 5.0e-4},
            "recording": {"sample_rate": f"{design.sample_rate:g} Hz", "duration": f"{first.duration:g} s"},
            "measured": design.sensor,
            "rig": written(design.parts),
        }

    def numbers(self) -> dict[str, float]:
        """Return true over stated value of every uncertain number."""
        return true_over_stated(self.design.parts, self.truth)


def draw_rig(name: str, seed: tuple[int, ...], *, plans: tuple[str, ...] = PLANS, **kinds: Any) -> FleetRig:
    """Draw a rig without hidden effects; ``kinds`` restricts motors, drives and loads as in `draw_design`."""
    rng = np.random.default_rng([*seed, 11])
    design = draw_design(rng, **kinds)
    truth = true_values(design.parts, rng)
    for lines in ("motor_lines", "load_lines"):
        sizes = truth[lines]["amplitudes"]
        truth[lines]["amplitudes"] = {k: v * float(np.exp(0.25 * rng.standard_normal())) for k, v in sizes.items()}
    laws = draw_laws(rng)
    plan, runs = draw_plan(rng, design, plans=plans)
    sensor = design.parts[design.sensor]
    tolerance = float(sensor["zero_tolerance"].split()[0])
    exact = design.motor_kind == "induction"
    return FleetRig(
        name=name, seed=seed, design=design, truth=truth, laws=laws, plan=plan, runs=tuple(runs),
        speed_error=0.0 if exact else float(rng.uniform(-0.004, 0.004)),
        wander=float(10.0 ** rng.uniform(-4.3, -3.3)),
        gain_error=sensor["gain_tolerance"] * float(rng.uniform(-0.8, 0.8)),
        zero=tolerance * float(rng.uniform(-0.8, 0.8)), angle_zero=float(rng.uniform(0.0, 2.0 * np.pi)),
    )  # fmt: skip
