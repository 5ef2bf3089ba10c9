"""Regenerated energy of a cycle: braking energy at the shaft, and its part that reaches the DC link."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.parameter import Estimate
from torquerig.scenario.drive_requirement import DriveRequirement
from torquerig.thermal.motor_variants import copper_bounds


def regeneration(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``braking_energy`` and ``regenerated_energy`` [J] of one cycle.

    Regenerated power is the braking power minus the copper loss ``3 R T^2 / Kt^2`` of a cold winding. Losses of
    inverter and iron reduce it further, so that the figure is an upper bound for a brake resistor. Where resistance or
    torque constant are not known, it is between zero and the braking energy.
    """
    braking = over_intervals(
        drive.data, lambda v: regenerated(drive.requirement(v)), unit="J", source="rigid body, at the shaft"
    )
    bounds, name = copper_bounds(drive.motor), f"phase resistance and torque constant of {drive.motor_name}"
    if bounds is None:
        highest = braking.value if braking.high is None else braking.high
        return {
            "braking_energy": braking,
            "regenerated_energy": Figure(low=0.0, high=highest, unit="J", missing=name) if highest else braking,
        }
    exact = bounds[0] == bounds[1]
    copper = Estimate(bounds[0]) if exact else Estimate(low=bounds[0], high=bounds[1])

    def to_dc_link(values: Values) -> float:
        return regenerated(drive.requirement(values), copper=values[name])

    return {
        "braking_energy": braking,
        "regenerated_energy": over_intervals(
            {**drive.data, name: copper}, to_dc_link, unit="J", source="shaft minus copper loss"
        ),
    }


def regenerated(requirement: DriveRequirement, *, copper: float = 0.0) -> float:
    """Return the energy [J] of all moments at which ``T w + copper T^2`` [W] is negative.

    Torque and speed are linear within a piece, so that the power is a parabola and its negative part is integrated
    exactly. ``copper`` [W/(N m)^2].
    """
    total = 0.0
    for span, torque, speed in zip(requirement.duration, requirement.torque, requirement.speed, strict=True):
        (t0, t1), (w0, w1) = torque, speed
        bend = (t1 - t0) * (w1 - w0) + copper * (t1 - t0) ** 2
        slope = t0 * (w1 - w0) + w0 * (t1 - t0) + 2 * copper * t0 * (t1 - t0)
        total += float(span) * _negative_part(np.array([bend, slope, t0 * w0 + copper * t0**2]))
    return total


def _negative_part(power: NDArray[np.float64]) -> float:
    """Return minus the integral over 0..1 of the polynomial where it is negative."""
    roots = np.roots(power) if np.any(power[:-1]) else np.array([])
    within = sorted(float(one.real) for one in roots if abs(one.imag) < 1e-12 and 0 < one.real < 1)
    edges, whole, total = [0.0, *within, 1.0], np.polyint(power), 0.0
    for start, end in pairwise(edges):
        if np.polyval(power, 0.5 * (start + end)) < 0:
            total -= float(np.polyval(whole, end) - np.polyval(whole, start))
    return total
