"""Temperatures over time with the band of all variants: one settled cycle, and the warm-up from cold."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.motor_variants import ThermalVariants
from torquerig.thermal.warming import Warming, warming

Floats = NDArray[np.float64]
POINTS = 60  # points of the warm-up


@dataclass(frozen=True, kw_only=True)
class Band:
    """Temperatures [C] at ``time`` [s], all of shape (n,): of the nominal variant, and the extremes of all variants."""

    time: Floats
    winding: Floats
    low: Floats
    high: Floats
    housing: Floats


def settled_band(duty: MotorDuty, variants: ThermalVariants, *, ambient: float) -> Band | None:
    """Return one settled cycle; None where the nominal variant never settles. Variants with a runaway are omitted."""
    found = []
    for motor in (variants.nominal, *variants.corners):
        made = warming(motor, duty, ambient=ambient)
        settled = made.settled()
        if settled is not None:
            found.append(made.course(settled))
        elif motor is variants.nominal:
            return None
    return _band(found[0][0], [course for _, course in found])


def warm_up(duty: MotorDuty, variants: ThermalVariants, *, ambient: float) -> Band:
    """Return the highest of winding and housing in each cycle, from cold over four slow time constants."""
    slowest = max(one.network.time_constants()[1] for one in variants.corners)
    last = max(1, round(4 * slowest / duty.length))
    cycles = np.unique(np.linspace(0, last, POINTS).astype(np.int64))
    courses = [
        _highest(warming(motor, duty, ambient=ambient), cycles) for motor in (variants.nominal, *variants.corners)
    ]
    return _band(np.asarray((cycles + 0.5) * duty.length, dtype=np.float64), courses)


def _highest(made: Warming, cycles: NDArray[np.int64]) -> Floats:
    """Return the highest temperatures of winding and housing in each of ``cycles`` [C], shape (n, 2)."""
    matrix, offset = made.cycle_map()
    rows, state, at = [], np.zeros(2), 0
    with np.errstate(over="ignore", invalid="ignore"):
        for cycle in cycles.tolist():
            ahead, gained = _power(matrix, offset, cycle - at)
            state, at = ahead @ state + gained, cycle
            rows.append(made.extremes(state)[1:])
    return np.array(rows)


def _power(matrix: Floats, offset: Floats, count: int) -> tuple[Floats, Floats]:
    """Return the map ``x -> matrix x + offset`` applied ``count`` times."""
    whole, added = np.eye(2), np.zeros(2)
    while count:
        if count & 1:
            whole, added = matrix @ whole, matrix @ added + offset
        matrix, offset, count = matrix @ matrix, matrix @ offset + offset, count >> 1
    return whole, added


def _band(time: Floats, courses: list[Floats]) -> Band:
    windings = np.array([course[:, 0] for course in courses])
    return Band(
        time=time, winding=windings[0], low=windings.min(axis=0), high=windings.max(axis=0), housing=courses[0][:, 1]
    )
