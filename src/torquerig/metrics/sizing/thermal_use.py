"""Winding temperature of the cycle, over all thermal models that the catalog allows and all open requirements."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import over_intervals
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.scenario.drive_requirement import DriveRequirement
from torquerig.thermal.duty_temperatures import DutyTemperatures, temperatures_of_duty
from torquerig.thermal.motor_duty import duty_of_requirement
from torquerig.thermal.motor_variants import thermal_variants

MOST = 10.0  # [1] upper end of the use; also for a thermal runaway
FIELDS = (
    "rated_torque", "stall_torque", "phase_resistance", "torque_constant", "thermal_resistance",
    "thermal_time_constant",
)  # fmt: skip
LEAST = -500.0  # [K] lower end of the margin


def thermal_use(drive: SizedDrive, *, ambient: float = 40.0) -> Mapping[str, Figure]:
    """Return ``thermal_use`` [1], the winding's temperature rise over the allowed rise, and ``thermal_margin`` [K].

    Two-node model of ``thermal/``; the extremes are those of the least and the largest rms torque. A use of 10 means
    10 or more, a margin of -500 K means less than that; both also stand for a thermal runaway.
    """
    variants = thermal_variants(drive.motor)
    results = [temperatures_of_duty(duty_of_requirement(one), variants, ambient=ambient) for one in _extremes(drive)]
    missing = ", ".join(f"{name} of {drive.motor_name}" for name in variants.assumed)
    source = f"two-node model, ambient {ambient:g} C"
    found = {
        "thermal_use": _joined(results, "use", unit="1", source=source, missing=missing),
        "thermal_margin": _joined(results, "margin", unit="K", source=source, missing=missing),
    }
    known = [(field, getattr(drive.motor, field)) for field in FIELDS]
    rests_on = (*((f"{field.replace('_', ' ')} of {drive.motor_name}", one) for field, one in known if one.source),
                *((name, one) for name, one in drive.data.items() if one.source))  # fmt: skip
    return {name: replace(figure, rests_on=rests_on) for name, figure in found.items()}


def _extremes(drive: SizedDrive) -> tuple[DriveRequirement, DriveRequirement, DriveRequirement]:
    """Return the requirement at the middle values, and those of the least and the largest rms torque."""
    rms = over_intervals(drive.data, lambda v: drive.requirement(v).rms_torque)
    middle = drive.requirement()
    if rms.low is None:
        return middle, middle, middle
    ordered = sorted(drive.requirements_made(), key=lambda one: one.rms_torque)  # all corners of the figure
    return middle, ordered[0], ordered[-1]


def _joined(results: list[DutyTemperatures], name: str, *, unit: str, source: str, missing: str) -> Figure:
    spans = [getattr(one, name) for one in results]
    low, high = min(span.low for span in spans), max(span.high for span in spans)
    kept = [min(MOST, max(LEAST, end)) if unit == "1" else max(LEAST, end) for end in (spans[0].value, low, high)]
    if low == high:
        return Figure(value=kept[0], unit=unit, source=source)
    return Figure(value=kept[0], low=kept[1], high=kept[2], unit=unit, source=source, missing=missing)
