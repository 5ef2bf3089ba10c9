"""Check whether motor and drive meet the requirement of a run, before it is simulated."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt

from torquerig.catalog.motor import Motor as Entry
from torquerig.catalog.reading import Catalog
from torquerig.errors import InputError
from torquerig.parameter import Estimate
from torquerig.recordings.profiles.table_checks import refuse_short
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import driven_motor
from torquerig.scenario.drive_requirement import DriveRequirement, drive_requirement
from torquerig.scenario.model import Scenario

RPM = 30 / pi


@dataclass(frozen=True, kw_only=True)
class RequirementFault:
    """A requirement that is not met: ``impossible`` is an error, others are flagged; ``remedy`` is what to do."""

    impossible: bool
    text: str
    remedy: str


def check_requirement(scenario: Scenario, catalog: Catalog, *, duration: float) -> tuple[str, ...]:
    """Return a sentence on each requirement that exceeds a rating; none for a rig without a driven motor.

    Parameters
    ----------
    duration : float
        Length of the recording [s].

    Raises
    ------
    InputError
        On a requirement that cannot be met: with motor, requirement, limit and remedy, and the line of the operating
        point. Also where the profile ends before the recording.
    """
    rig = scenario.rig
    if driven_motor(rig) is None or rig.run.speed is None or not duration > 0:
        return ()
    course, place = rig.run.speed_profile(), scenario.document.place(("operating_point",))
    try:
        refuse_short(course.name, course.length, duration=duration)
    except InputError as error:
        raise InputError(f"{place}: {error}") from None
    faults = requirement_faults(drive_requirement(rig, duration=duration), rig, entry_of(rig, catalog))
    name = rig.run.motor or "the motor"
    for fault in faults:
        if fault.impossible:
            raise InputError(f"{place}: {name} {fault.text}; {fault.remedy}")
    return tuple(f"{name} {fault.text}; {fault.remedy}" for fault in faults)


def entry_of(rig: Rig, catalog: Catalog) -> Entry | None:
    """Return the catalog's entry of the driven motor; None where the scenario states its values."""
    driven = driven_motor(rig)
    return catalog.motors.get(driven.model) if driven is not None else None


def requirement_faults(requirement: DriveRequirement, rig: Rig, entry: Entry | None) -> tuple[RequirementFault, ...]:
    """Return the requirements that cannot be met or exceed a rating, the impossible ones first."""
    faults = [*_torque_faults(requirement, rig)]
    if entry is not None:
        faults += [
            *_speed_faults(requirement, entry),
            *_rating_faults(requirement, entry),
            *_voltage_faults(requirement, entry),
        ]
    faults += [_flag(f"cannot follow {step}", "write a ramp, which requires less torque") for step in requirement.late]
    return tuple(sorted(faults, key=lambda fault: not fault.impossible))


def _speed_faults(requirement: DriveRequirement, entry: Entry) -> list[RequirementFault]:
    needed, remedy = requirement.top_speed, "choose a smaller ratio or output speed"
    low, high = entry.max_speed.bounds
    if needed > high:
        return [_refuse(f"needs {needed * RPM:.0f} rpm, reaches at most {high * RPM:.0f} rpm", remedy)]
    faults = []
    if needed > low:
        faults.append(_flag(f"needs {needed * RPM:.0f} rpm, and its largest speed is known only as "
                            f"{_known(entry.max_speed)}", f"ask the maker, or {remedy}"))  # fmt: skip
    if needed > entry.rated_speed.bounds[1]:
        faults.append(_flag(f"needs {needed * RPM:.0f} rpm, above its rated {_known(entry.rated_speed)}", remedy))
    slowest = float(abs(requirement.speed).max(axis=1).min())
    if not entry.min_speed.unknown and 0 < slowest < entry.min_speed.bounds[0]:
        faults.append(_flag(f"turns with {slowest * RPM:.0f} rpm, below the {_known(entry.min_speed)} of continuous "
                            "duty", "cool it by a separate fan, or choose a larger ratio"))  # fmt: skip
    return faults


def _torque_faults(requirement: DriveRequirement, rig: Rig) -> list[RequirementFault]:
    driven = driven_motor(rig)
    limit = driven.torque_limit if driven is not None else float("inf")
    needed, time = requirement.at_worst()
    if needed <= limit:
        return []
    remedy = "lower the load or the acceleration, choose a larger ratio, or raise torque_limit"
    return [_refuse(f"must give {needed:.3g} N*m at {time:.3g} s, and its drive's limit is {limit:.3g} N*m", remedy)]


def _rating_faults(requirement: DriveRequirement, entry: Entry) -> list[RequirementFault]:
    needed, rms = requirement.at_worst()[0], requirement.rms_torque
    remedy = "check its temperature with torquerig duty"
    if needed > entry.peak_torque.bounds[1]:
        return [_refuse(f"must give {needed:.3g} N*m, more than its peak torque {_known(entry.peak_torque)}",
                        "lower the load or the acceleration, or choose a larger ratio")]  # fmt: skip
    low, high = entry.rated_torque.bounds
    if rms <= low:
        return []
    word = "exceeds" if rms > high else "may exceed"
    return [_flag(f"has an rms torque of {rms:.3g} N*m, which {word} its rated {_known(entry.rated_torque)}", remedy)]


def _voltage_faults(requirement: DriveRequirement, entry: Entry) -> list[RequirementFault]:
    """Compare the voltage between two phases (rms) with the supply's: the limit of an ideal inverter.

    ``E = Kt w / sqrt(3)`` (Kt per rms ampere); with current I also ``sqrt((E + sqrt(3) R I)^2 + (sqrt(3) p w L I)^2)``.
    """
    supply, constant = entry.supply_voltage, entry.torque_constant
    if supply.unknown or constant.unknown:
        return []
    least = requirement.top_speed * constant.bounds[0] / sqrt(3)
    at_speed, remedy = (
        f"at {requirement.top_speed * RPM:.0f} rpm",
        "choose a smaller ratio or output speed, or a higher voltage",
    )
    if least > supply.bounds[1]:
        return [
            _refuse(f"has a back-EMF of {least:.0f} V or more {at_speed}, above its supply of {supply.shown()}", remedy)
        ]
    most = requirement.top_speed * constant.bounds[1] / sqrt(3)
    if not entry.phase_resistance.unknown and not entry.phase_inductance.unknown:
        current = sqrt(3) * requirement.at_worst()[0] / constant.bounds[0]
        poles = entry.pole_pairs.bounds[1]
        along = most + entry.phase_resistance.bounds[1] * current
        across = poles * requirement.top_speed * entry.phase_inductance.bounds[1] * current
        most = sqrt(along**2 + across**2)
    if most <= supply.bounds[0]:
        return []
    return [_flag(f"may need up to {most:.0f} V between phases {at_speed}, above its supply of {supply.shown()}",
                  "ask the maker for the torque at this speed")]  # fmt: skip


def _known(estimate: Estimate) -> str:
    return estimate.shown().removeprefix("? ").strip("()")


def _refuse(text: str, remedy: str) -> RequirementFault:
    return RequirementFault(impossible=True, text=text, remedy=remedy)


def _flag(text: str, remedy: str) -> RequirementFault:
    return RequirementFault(impossible=False, text=text, remedy=remedy)
