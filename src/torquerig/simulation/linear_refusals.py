"""Nonlinearities that the exact linear path refuses, each with its name and a remedy."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.simulation.lower import Lowered
from torquerig.simulation.term_kinds import KINDS
from torquerig.simulation.twin.operating_point import OperatingPoint

NEAR_STANDSTILL = 3.0  # [1] speeds over the smoothing of a sign: tanh(3) is 0.995


def refuse_nonlinear(rig: Rig, lowered: Lowered, point: OperatingPoint) -> None:
    """Raise InputError for the first thing that is not linear anywhere near the operating point."""
    if not lowered.drive_terms and (lowered.arrays.waves.base_node.size or rig.run.speed):
        raise InputError("nothing controls the speed, so that lines have no frequency of their own; use simulate")
    if rig.run.profile != "steady" and lowered.drive_terms:
        raise InputError(
            f"profile {rig.run.profile}: the linear path needs one speed, at which lines stand still in frequency; "
            "use simulate for it"
        )
    for name, why in (*_terms(lowered), *_gaps(lowered, point)):
        raise InputError(f"{name}: {why} is not in the linear path; use simulate")
    for name, what in _standing(lowered, point):
        raise InputError(
            f"{name}: {what} on a shaft that stands or creeps is not linear; give the run a speed, or use simulate"
        )


def _terms(lowered: Lowered) -> Iterator[tuple[str, str]]:
    for kind in KINDS:
        yield from kind.refused(lowered.rows_of[kind.field])


def _gaps(lowered: Lowered, point: OperatingPoint) -> Iterator[tuple[str, str]]:
    for row in np.flatnonzero(lowered.arrays.springs.half_gap):
        if point.spring_torques[row] == 0:
            gap = 2 * lowered.arrays.springs.half_gap[row]
            yield lowered.spring_names[int(row)], f"a gap of {gap:.3g} rad that no steady torque holds closed"


def _standing(lowered: Lowered, point: OperatingPoint) -> Iterator[tuple[str, str]]:
    """Yield dry friction and opposing loads on shafts that stop or creep."""
    speeds, frictions = point.speeds, lowered.arrays.frictions
    for row in range(frictions.on.size):
        slide = speeds[frictions.on[row]] - speeds[frictions.against[row]]
        dry = frictions.coulomb[row].any() or frictions.excess[row].any()
        if dry and abs(slide) * frictions.inverse_smoothing[row] < NEAR_STANDSTILL:
            yield lowered.nodes[int(frictions.on[row])], "dry friction"
    for term, on, smooth in zip(
        lowered.load_terms, lowered.arrays.loads.on, lowered.arrays.loads.inverse_smoothing, strict=True
    ):
        if smooth and abs(speeds[on]) * smooth < NEAR_STANDSTILL:
            yield term.name, "a load that opposes its motion"
