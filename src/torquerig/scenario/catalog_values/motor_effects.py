"""Ripple lines of a catalog motor, as effects of the rig."""

from __future__ import annotations

from collections.abc import Mapping

from torquerig.catalog.entry import estimates
from torquerig.catalog.lines import RippleLine, ripple_lines
from torquerig.catalog.motor import Motor
from torquerig.catalog.sampling import Sample
from torquerig.parameter import Estimate
from torquerig.scenario.catalog_values.filled import Filled
from torquerig.units import written_quantity

GROUPS = {
    "motor": "mechanical",
    "cogging": "cogging",
    "cogging_per_pole": "cogging",
    "cogging_tolerance_slots": "cogging",
    "cogging_tolerance_poles": "cogging",
    "electrical": "electrical",
    "six_pulse": "electrical",
}
"""The share of the reading to which each family of lines belongs."""


def motor_effects(motor: Sample[Motor], name: str) -> tuple[Filled, ...]:
    """Return the lines of the motor part ``name``: one effect per group, and one per line that follows the torque."""
    lines, known = ripple_lines(motor), dict(estimates(motor.entry))
    effects = []
    for group in dict.fromkeys(GROUPS.values()):
        steady = [line for line in lines if GROUPS[line.family] == group and line.torque > 0]
        if steady:
            effects.append(_ripple(name, group, steady, known))
        effects += [
            Filled(
                name=f"{name}.ripple_{line.order}",
                values={"kind": "commutation_ripple", "at": name, "order_motor": line.order, "depth": line.share},
                uncertainties=_spread("depth", known[line.field]),
            )
            for line in lines
            if GROUPS[line.family] == group and line.share > 0
        ]
    return tuple(effects)


def _spread(field: str, known: Estimate) -> dict[str, float]:
    return {field: known.part_rel_sd} if known.part_rel_sd else {}


def _ripple(name: str, group: str, lines: list[RippleLine], known: Mapping[str, Estimate]) -> Filled:
    amplitudes: dict[int, float] = {}
    for line in lines:
        amplitudes[line.order] = amplitudes.get(line.order, 0.0) + line.torque
    return Filled(
        name=f"{name}.{group}",
        values={
            "kind": "torque_ripple",
            "at": name,
            "group": group,
            "amplitudes": {order: written_quantity(torque, "N*m") for order, torque in amplitudes.items()},
            "amplitude_rel_sd": max(known[line.field].part_rel_sd for line in lines),
        },
    )
