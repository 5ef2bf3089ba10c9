"""What a scenario states and a run of it does not use."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import isinf

from torquerig.errors import InputError
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.rig.assembly import Rig
from torquerig.scenario.checks.locked_ends import at_locked_ends
from torquerig.scenario.model import Scenario

_POINT = "operating_point"


def unused_by_run(scenario: Scenario) -> tuple[str, ...]:
    """Return each stated key that no run of the rig at its operating point depends on, with the reason."""
    point = (f"{_POINT}.{key}: {reason}" for key, reason in _of_operating_point(scenario))
    return (*point, *at_locked_ends(scenario))


def unused_by_simulation(scenario: Scenario) -> tuple[str, ...]:
    """Return each stated key that a simulated recording does not depend on, with the reason.

    The section of the study is left out, and what is uncertain of a value.
    """
    found = [*unused_by_run(scenario)]
    point, run = scenario.operating_point, scenario.rig.run
    if point.speed_set_point_error_max:
        found.append(f"{_POINT}.speed_set_point_error_max: only a diagnosis uses it; the simulated set-point is exact")
    if point.temperature_change is not None:
        found.append(f"{_POINT}.temperature_change: only the uncertainty budget of a study uses it")
    if not isinstance(run.set_points, Tabulated):
        return tuple(found)
    if _holds(run.set_points.rows):
        text = "its torque at rest, because simulated loads only resist motion; duty and size count it"
        found.append(f"{_POINT}.{run.profile}: {text}")
    if not isinf(run.set_points.length) and "duration" in (scenario.document.data.get("recording") or {}):
        found.append(f"recording.duration: the profile {run.profile} states its own length")
    return tuple(found)


def _of_operating_point(scenario: Scenario) -> Iterator[tuple[str, str]]:
    point, rig = scenario.operating_point, scenario.rig
    stated = scenario.document.data.get(_POINT) or {}
    load = stated.get("load") or {}
    for key in ("duty_cycle", "csv"):
        if key in stated and point.profile != key:
            yield key, f"the profile is {point.profile}; select it with {_POINT}.profile={key}"
    if point.slow_speed_wander and point.profile != "steady":
        yield "slow_speed_wander", f"only a steady run wanders, and the profile is {point.profile}"
    if rig.run.set_points is not None:
        for key in {"output_speed", "motor_speed"} & {*stated}:
            yield key, f"the profile {point.profile} states its own speeds"
    if load.get("occupancy") and not _depends_on_occupancy(rig):
        yield "load.occupancy", "no part of the rig depends on it"
    if "particle_size" in load and not _depends_on_size(rig):
        yield "load.particle_size", "no part of the rig depends on it"


def _holds(rows: Breakpoints) -> bool:
    """Return whether a torque must be held at rest."""
    if rows.load is None or rows.held is None:
        return False
    return any(speed == 0 and load and held for speed, load, held in zip(rows.speed, rows.load, rows.held, strict=True))


def _depends_on_occupancy(rig: Rig) -> bool:
    known = rig.run.occupancy_percent or 0.0
    try:
        return _differs(rig, rig.at(replace(rig.run, occupancy_percent=0.9 * known)))
    except InputError:  # a load that is not known there
        return True


def _depends_on_size(rig: Rig) -> bool:
    known = rig.run.particle_size
    return known is not None and _differs(rig, rig.at(replace(rig.run, particle_size=1.1 * known)))


def _differs(rig: Rig, other: Rig) -> bool:
    return rig.terms() != other.terms() or rig.stages() != other.stages()
