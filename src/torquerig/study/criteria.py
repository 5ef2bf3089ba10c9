"""Requirements and criteria of a study for the decision matrices, checked before the simulation."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from torquerig.decide.criterion import Better, Criterion, Indifference, Kind, Requirement, ValueFunction
from torquerig.decide.kesselring import TEACHING
from torquerig.errors import InputError, TorquerigError
from torquerig.study.settings import CriterionRow, RequirementRow

if TYPE_CHECKING:
    from torquerig.study.definition import Study

UNITS: Mapping[str, str] = {
    "truth_error": "N*m",
    "disturbance": "N*m",
    "speed_reserve": "1",
    "speed_use": "1",
    "continuous_output_torque": "N*m",
    "torque_reserve": "1",
    "sensor_peak": "N*m",
    "servo": "1",
    "new_parts": "1",
    "price": "EUR",
    "residual_disturbance": "N*m",
}
"""Unit of each metric on a shaft but those of a sizing; limits, bands and points of a study are in it."""
AT_SENSOR = ("truth_error", "disturbance", "continuous_output_torque", "sensor_peak", "residual_disturbance")
"""Metrics of what is measured, which is a force where it moves in a line."""


def requirements_of(study: Study) -> tuple[Criterion, ...]:
    """Return the study's requirements; InputError with file, line and key for one that cannot be used."""
    if not study.settings.requirements:
        raise InputError(
            f"{study.document.place(('study', 'requirements'))}: the list is empty; write at least one requirement"
        )
    return tuple(_made(study, "requirements", name, row) for name, row in study.settings.requirements.items())


def criteria_of(study: Study) -> tuple[Criterion, ...]:
    """Return the study's criteria; InputError with file, line and key for one that cannot be used."""
    rows = study.settings.criteria.values()
    if not any(row.kind == "technical" and row.weight > 0 for row in rows):
        place = study.document.place(("study", "criteria"))
        raise InputError(f"{place}: no technical criterion has a weight, so no ranking is possible; give one a weight")
    return tuple(_made(study, "criteria", name, row) for name, row in study.settings.criteria.items())


def unit_of(metric: str) -> str:
    """Return the unit of a metric of a study on a shaft."""
    if metric in UNITS:
        return UNITS[metric]
    from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS

    return SIZING_UNITS[metric]


def _made(study: Study, section: str, name: str, row: RequirementRow | CriterionRow) -> Criterion:
    place = study.document.place
    unit = study.effort_unit if row.metric in AT_SENSOR else unit_of(row.metric)
    if row.unit != unit:
        raise InputError(
            f"{place(('study', section, name, 'unit'))}: {row.metric} has the unit {unit!r}, not {row.unit!r}; "
            f"write the limits and points in {unit!r}"
        )
    try:
        return _requirement(name, row) if isinstance(row, RequirementRow) else _criterion(name, row)
    except TorquerigError as error:
        message = str(error).removeprefix(f"{name}: ")
        raise InputError(f"{place(('study', section, name))}: {message}") from None


def _requirement(name: str, row: RequirementRow) -> Criterion:
    return Criterion(name=name, unit=row.unit, requirement=Requirement(low=row.min, high=row.max), purpose=row.purpose)


def _criterion(name: str, row: CriterionRow) -> Criterion:
    outside = [points for points in row.points.values() if not TEACHING.p_min <= points <= TEACHING.p_max]
    if outside:
        raise InputError(
            f"points: {outside[0]:g} points are outside the scale {TEACHING.p_min:g}..{TEACHING.p_max:g}; rescale them"
        )
    return Criterion(
        name=name,
        unit=row.unit,
        better=Better(row.better),
        band=row.band,
        kind=Kind(row.kind),
        weight=row.weight,
        indifference=Indifference(absolute=row.same_within.absolute, relative=row.same_within.relative),
        value=ValueFunction(tuple(sorted(row.points.items()))),
        purpose=row.purpose,
    )
