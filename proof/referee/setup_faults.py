"""Set-up faults: what a test sheet or scenario says wrongly about mounting, calibration, acquisition or a part."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from proof.fleet.draw import RIGS, FleetCase, NoRigError
from proof.fleet.rig import FleetRig, draw_rig
from proof.fleet.stages_stated import PAIRS
from proof.referee.edits import Columns, Edit, Tree, number_of, times

PLANS = ("two_speeds", "several", "reversal")


@dataclass(frozen=True)
class SetupFault:
    """A fault: the edit of the files, and the fact that a diagnosis should report."""

    edit: Edit
    kind: str
    of: str
    stated: float
    true: float

    def as_dict(self) -> dict[str, Any]:
        """Return the fact for the answer; ``also`` are kinds of the same class."""
        return {
            "kind": self.kind,
            "of": self.of,
            "stated": self.stated,
            "true": self.true,
            "also": ALSO.get(self.kind, []),
        }


ALSO: dict[str, list[str]] = {"gear_ratio": ["teeth"], "teeth": ["gear_ratio"]}
Make = Callable[[np.random.Generator, FleetRig], SetupFault | None]


def scale(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """State a sensitivity that is off by a usual slip, in scenario and sidecars."""
    factor = float(rng.choice([2.0, 0.5, 1.41421, 10.0, 0.1]))
    sensor = rig.design.sensor

    def sidecar(facts: Tree) -> Tree:
        channel = facts["channels"]["torque_V"]
        channel["Nm_per_V"] = times(channel["Nm_per_V"], factor)
        return facts

    def scenario(tree: Tree) -> Tree:
        tree["rig"][sensor]["sensitivity"] = times(tree["rig"][sensor]["sensitivity"], 1.0 / factor)
        return tree

    return SetupFault(Edit(scenario, sidecar), "sensor_scale", sensor, 1.0, factor)


def sign(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """Turn the sensor round without a word."""

    def columns(table: Columns, rate: float) -> Columns:
        return table | {"torque_V": -table["torque_V"]}

    return SetupFault(Edit(columns=columns), "sensor_sign", rig.design.sensor, 1.0, -1.0)


def zero(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """Shift the zero by 15 to 50 % of the rated torque, far beyond its tolerance."""
    torque = rig.design.scale.torque * float(rng.uniform(0.15, 0.5)) * float(rng.choice([-1.0, 1.0]))
    volts = torque * number_of(rig.design.parts[rig.design.sensor]["sensitivity"])

    def columns(table: Columns, rate: float) -> Columns:
        return table | {"torque_V": (table["torque_V"] + np.float32(volts)).astype(np.float32)}

    return SetupFault(Edit(columns=columns), "sensor_zero", rig.design.sensor, 0.0, torque)


def rate(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """State a sample rate that is off by a usual slip."""
    factor = float(rng.choice([2.0, 0.5, 1.024, 1.1, 0.9]))

    def sidecar(facts: Tree) -> Tree:
        facts["sample_rate_Hz"] = float(f"{facts['sample_rate_Hz'] * factor:.9g}")
        return facts

    def scenario(tree: Tree) -> Tree:
        tree["recording"]["sample_rate"] = times(tree["recording"]["sample_rate"], factor)
        return tree

    true = rig.design.sample_rate
    return SetupFault(Edit(scenario, sidecar), "sample_rate", "recording", true * factor, true)


def counts(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """State counts per turn that are off by the evaluation of edges; None without an encoder."""
    if rig.design.angle != "encoder":
        return None
    factor = float(rng.choice([4.0, 2.0, 0.25, 0.5]))
    true = rig.design.angle_counts

    def sidecar(facts: Tree) -> Tree:
        facts["channels"]["encoder_count"]["counts_per_rev"] = round(true * factor)
        return facts

    def scenario(tree: Tree) -> Tree:
        tree["rig"]["encoder"]["counts_per_rev"] = round(true * factor)
        return tree

    return SetupFault(Edit(scenario, sidecar), "counts_per_rev", "encoder", true * factor, float(true))


def ratio(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """State another pair of the catalog in the last stage; None without a pair of gears."""
    last = rig.design.stages[-1] if rig.design.stages else None
    if last is None or last.part["kind"] != "fixed_axis_gear":
        return None
    pairs = [pair for pair in PAIRS if abs(pair[1] / pair[0] / abs(last.ratio) - 1.0) > 0.05]
    return _teeth(rig, pairs[int(rng.integers(len(pairs)))], "gear_ratio")


def teeth(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """Count a tooth of the last wheel too many or too few; None without a pair of gears."""
    last = rig.design.stages[-1] if rig.design.stages else None
    if last is None or last.part["kind"] != "fixed_axis_gear":
        return None
    pinion, wheel = last.part["teeth"]["pinion"], last.part["teeth"]["wheel"]
    return _teeth(rig, (pinion, wheel + int(rng.choice([-1, 1]))), "teeth")


def _teeth(rig: FleetRig, pair: tuple[int, int], kind: str) -> SetupFault:
    last = rig.design.stages[-1]
    stated = pair[1] / pair[0]
    factor = stated / abs(last.ratio)

    def sidecar(facts: Tree) -> Tree:
        facts["run"]["gear_ratio"] = float(f"{facts['run']['gear_ratio'] * factor:.9g}")
        return facts

    def scenario(tree: Tree) -> Tree:
        tree["rig"][last.name]["teeth"] = {"pinion": pair[0], "wheel": pair[1]}
        mesh = tree["rig"].get(f"{last.name}_mesh")
        if mesh is not None:
            mesh["order_output"] = pair[1]
        return tree

    true = abs(last.ratio) if kind == "gear_ratio" else float(last.part["teeth"]["wheel"])
    return SetupFault(
        Edit(scenario, sidecar), kind, last.name, stated if kind == "gear_ratio" else float(pair[1]), true
    )


def wrong_mass(rng: np.random.Generator, rig: FleetRig) -> SetupFault | None:
    """State an inertia of the body that is off by a factor of 2 to 4, with its usual small spread."""
    factor = float(rng.choice([0.25, 0.4, 2.5, 4.0]))
    body = rig.design.body

    def scenario(tree: Tree) -> Tree:
        tree["rig"][body]["inertia"] = times(tree["rig"][body]["inertia"], factor)
        return tree

    true = float(rig.truth[body]["inertia"])
    stated = number_of(rig.scenario()["rig"][body]["inertia"]) * factor
    return SetupFault(Edit(scenario), "parameter", f"{body}.inertia", stated, true)


FAULTS: dict[str, Make] = {
    "scale": scale, "sign": sign, "zero": zero, "rate": rate, "counts": counts, "ratio": ratio, "teeth": teeth,
    "wrong_mass": wrong_mass,
}  # fmt: skip


def fault_case(name: str, seed: tuple[int, ...], kind: str) -> tuple[FleetCase, SetupFault]:
    """Draw a clean rig that can have the fault, and the fault."""
    drives = ("one_stage", "two_stage", "three_stage") if kind in ("ratio", "teeth") else None
    for attempt in range(RIGS):
        rig = draw_rig(name, (*seed, attempt), plans=PLANS, **({"drives": drives} if drives else {}))
        fault = FAULTS[kind](np.random.default_rng([*seed, attempt, 23]), rig)
        if fault is not None:
            return FleetCase(rig), fault
    raise NoRigError(f"{name}: none of {RIGS} drawn rigs can have the fault {kind}")
