"""Catalog values of a motor on a gearbox as figures, without scenario or simulation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import pi
from typing import TYPE_CHECKING

from torquerig.metrics.figure import Figure, scaled, yes_no
from torquerig.metrics.sizing.open_data import exact_value, over_intervals

if TYPE_CHECKING:
    from torquerig.catalog.gearbox import Gearbox
    from torquerig.catalog.motor import Motor
    from torquerig.parameter import Estimate

FACT_UNITS: Mapping[str, str] = {
    "rated_speed": "rpm", "rated_torque": "N*m", "output_torque": "N*m", "unlimited_peak": "N*m",
    "rotor_inertia": "kg*m^2", "inertia_at_output": "kg*m^2", "servo": "1", "a_series_adapter": "1",
    "same_shaft": "1",
}  # fmt: skip
"""The figures of ``motor_facts`` with their units."""


def motor_facts(motor: Motor, gearbox: Gearbox, *, present: Motor) -> Mapping[str, Figure]:
    """Return the figures by the names of ``FACT_UNITS``.

    ``output_torque`` is rated torque x ratio x efficiency, ``unlimited_peak`` the same of the peak torque;
    ``inertia_at_output`` the rotor's inertia x ratio^2; ``same_shaft`` is 1 where the shaft has the diameter of that of
    the ``present`` motor, 0 where it certainly has not.
    """
    name, box = motor.stands_for or motor.name, gearbox.name
    rated, peak, eta = f"rated torque of {name}", f"peak torque of {name}", f"efficiency of {box}"
    efficiency = gearbox.efficiency
    return {
        "rated_speed": _rounded(scaled(motor.rated_speed, 30 / pi, unit="rpm", missing=f"rated speed of {name}")),
        "rated_torque": scaled(motor.rated_torque, 1.0, unit="N*m", missing=rated),
        "output_torque": over_intervals(
            {rated: motor.rated_torque, eta: efficiency}, lambda v: v[rated] * gearbox.ratio * v[eta], unit="N*m",
            source=f"rated torque x {gearbox.ratio:g} x efficiency",
        ),
        "unlimited_peak": over_intervals(
            {peak: motor.peak_torque, eta: efficiency}, lambda v: v[peak] * gearbox.ratio * v[eta], unit="N*m",
            source=f"peak torque x {gearbox.ratio:g} x efficiency",
        ),
        "rotor_inertia": _stated(motor.rotor_inertia, 1.0, f"rotor inertia of {name}"),
        "inertia_at_output": _stated(motor.rotor_inertia, gearbox.ratio**2, f"rotor inertia of {name}"),
        "servo": yes_no(motor.servo, f"whether {name} is a servo motor"),
        "a_series_adapter": yes_no(motor.a_series_adapter, f"whether the A series adapter fits {name}"),
        "same_shaft": _same_shaft(motor, present),
    }  # fmt: skip


def _rounded(figure: Figure) -> Figure:
    """Return a figure rounded to 1e-6, so that rounding errors of unit conversion do not fail a limit."""
    ends = (None if one is None else round(one, 6) for one in (figure.value, figure.low, figure.high))
    value, low, high = ends
    return replace(figure, value=value, low=low, high=high)


def _stated(known: Estimate, factor: float, name: str) -> Figure:
    """Return a figure with the stated value and its interval."""
    return over_intervals({name: known, "factor": exact_value(factor)}, lambda v: v[name] * v["factor"], unit="kg*m^2",
                source=f"{known.source} ({known.evidence})")  # fmt: skip


def _same_shaft(motor: Motor, present: Motor) -> Figure:
    if (motor.stands_for or motor.name) == (present.stands_for or present.name):
        return Figure(value=1.0, source="it is the present motor")
    lost = [f"shaft diameter of {one.stands_for or one.name}" for one in (motor, present) if one.shaft_diameter.unknown]
    if lost:
        return Figure(missing=", ".join(lost))
    rests_on = tuple(
        (f"shaft diameter of {one.stands_for or one.name}", one.shaft_diameter) for one in (motor, present)
    )
    (low, high), (least, most) = motor.shaft_diameter.bounds, present.shaft_diameter.bounds
    if high < least or most < low:
        return Figure(value=0.0, source="shaft diameters of the catalog", rests_on=rests_on)
    if low == high == least == most:
        return Figure(value=1.0, source="shaft diameters of the catalog", rests_on=rests_on)
    return Figure(low=0.0, high=1.0, missing=f"shaft diameter of {motor.name}", rests_on=rests_on)
