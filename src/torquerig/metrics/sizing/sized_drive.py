"""A rig with the catalog values of its motor, gearbox and sensor, and its required torque for any open values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor as MotorEntry
from torquerig.catalog.reading import Catalog
from torquerig.catalog.sensor import Sensor
from torquerig.errors import InputError
from torquerig.metrics.sizing.open_data import Values, exact_value
from torquerig.parameter import Estimate
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import driven_motor
from torquerig.rig.parts import Gear, Motor, WormGear
from torquerig.rig.reading_place import reading_place
from torquerig.scenario.checks.recorded_load import refuse_unstated_load
from torquerig.scenario.drive_requirement import DriveRequirement, drive_requirement
from torquerig.scenario.kinematics import gears_to_sensor, torque_gain, turns_to
from torquerig.scenario.model import Scenario

MOTOR_FIELDS = {"inertia": "rotor_inertia", "coulomb": "coulomb_friction", "viscous": "viscous_friction"}
GEAR_FIELDS = {"efficiency": "efficiency", "input_inertia": "input_inertia"}
WORM_FIELDS = {"forward_efficiency": "efficiency", "worm_inertia": "input_inertia"}
STEADY_LENGTH = 10.0  # [s] of a run without a stated length; a steady run does not depend on it


@dataclass(frozen=True, kw_only=True)
class SizedDrive:
    """The drive to be sized.

    Parameters
    ----------
    rig : Rig
        At its operating point.
    motor : Motor
        The catalog's entry of the driven motor.
    gearboxes : mapping of str to Gearbox
        The catalog's entries of the gears between motor and sensor, by the names of the parts, in their order.
    sensor : Sensor or None
    data : mapping of str to Estimate
        Values of motor and gear that the required torque depends on, by name.
    places : mapping of str to (str, str)
        Part and field of each of these.
    duration : float
        Of a run without a stated length [s].
    """

    rig: Rig
    motor: MotorEntry
    gearboxes: Mapping[str, Gearbox]
    sensor: Sensor | None
    data: Mapping[str, Estimate]
    places: Mapping[str, tuple[str, str]]
    duration: float
    _requirements: dict[tuple[float, ...], DriveRequirement] = field(default_factory=dict, repr=False, compare=False)

    @property
    def motor_name(self) -> str:
        """The maker's name of the motor."""
        return self.motor.stands_for or self.motor.name

    @property
    def part(self) -> Motor:
        """The motor as a part of the rig."""
        found = driven_motor(self.rig)
        if found is None:  # a sized drive is not made without one
            raise InputError("no motor of the rig follows a set-point")
        return found

    @property
    def ratio(self) -> float:
        """Motor turns per turn of the sensor's shaft [1]; in a line the motor's angle per travel [rad/m]."""
        return turns_to(self.rig, reading_place(self.rig))

    def with_values(self, values: Values) -> Rig:
        """Return the rig with other values [SI] of its data, by the names of ``data``."""
        rig = self.rig
        for name, (part, target) in self.places.items():
            if name in values:
                changed: dict[str, Any] = {target: values[name]}
                rig = rig.changed(replace(rig.part(part), **changed))
        return rig

    def requirement(self, values: Values | None = None) -> DriveRequirement:
        """Return what the run requires of the motor with these values, other values in the middle."""
        chosen = {name: known.nominal() for name, known in self.data.items()}
        chosen |= {name: one for name, one in (values or {}).items() if name in chosen}
        key = tuple(chosen.values())
        if key not in self._requirements:
            self._requirements[key] = drive_requirement(self.with_values(chosen), duration=self.duration)
        return self._requirements[key]

    def requirements_made(self) -> tuple[DriveRequirement, ...]:
        """Return all requirements that have been calculated, one per set of values."""
        return tuple(self._requirements.values())

    def gain(self, values: Values) -> float:
        """Return the sensor's steady torque per torque of the motor [1]."""
        return torque_gain(self.with_values(values))


def sized_drive(scenario: Scenario, catalog: Catalog, *, duration: float = STEADY_LENGTH) -> SizedDrive:
    """Return the drive of a scenario with its catalog values.

    Values that the scenario states are exact, or open where it states an uncertainty; values drawn from an interval of
    the catalog are open.

    Raises
    ------
    InputError
        When no motor of the catalog follows a set-point, or a load is recorded only.
    """
    rig, path = scenario.rig, scenario.document.path
    part, in_a_line = driven_motor(rig), rig.in_a_line(rig.part(rig.measured))
    if part is None or not rig.run.speed:
        raise InputError(f"{path}: no motor follows a speed, so that nothing can be sized; add a speed_controller and "
                         f"an output_speed, such as {'50 mm/s' if in_a_line else '200 rpm'}")  # fmt: skip
    if part.model not in catalog.motors and not part.model:
        raise InputError(f"{path}: the driven motor is not in the catalog, so that nothing is known of its ratings; "
                         "name one with catalog: or --motor")  # fmt: skip
    refuse_unstated_load(scenario)
    entry = catalog.motor(part.model)
    written = scenario.document.data["rig"]
    bought = [gear.name for gear in gears_to_sensor(rig) if isinstance(gear, Gear | WormGear)]
    named = {name: _named(written, name) for name in bought}
    gearboxes = {part: catalog.gearbox(entry) for part, entry in named.items() if entry in catalog.gearboxes}
    data: dict[str, Estimate] = {}
    places: dict[str, tuple[str, str]] = {}
    owned = [(part, entry, MOTOR_FIELDS), *((rig.part(name), box, _fields_of(box)) for name, box in gearboxes.items())]
    for one, known, fields in owned:
        for target, source in fields.items():
            field = f"{one.name}.{target}"
            name = f"{source.replace('_', ' ')} of {getattr(known, 'stands_for', '') or known.name}"
            name = f"{name} ({one.name})" if name in data else name  # the same gearbox twice in a chain
            stated, taken = getattr(known, source), float(getattr(one, target))
            if field in scenario.uncertainties and field not in scenario.taken:
                data[name] = _as_interval(scenario.uncertainties[field])
            else:
                kept = field in scenario.assumed or (stated.documented and stated.value == taken)
                data[name] = stated if kept else exact_value(taken)
            places[name] = one.name, target
    for gear in gears_to_sensor(rig):
        field = f"{gear.name}.efficiency"
        if gear.name not in gearboxes and field in scenario.uncertainties:
            data[f"efficiency of {gear.name}"] = _as_interval(scenario.uncertainties[field])
            places[f"efficiency of {gear.name}"] = gear.name, "efficiency"
    return SizedDrive(
        rig=rig, motor=entry, gearboxes=gearboxes, sensor=catalog.sensors.get(_named(written, rig.measured)), data=data,
        places=places, duration=duration,
    )  # fmt: skip


def _fields_of(box: Gearbox) -> Mapping[str, str]:
    """Return the fields of a gear by those of its catalog entry."""
    return WORM_FIELDS if box.kind == "worm" else GEAR_FIELDS


def _as_interval(known: Estimate) -> Estimate:
    """Return an uncertain value as an open one; one standard deviation to both sides where no interval is stated."""
    low, high = known.bounds
    return replace(known, low=low, high=high)


def _named(written: Mapping[str, Mapping[str, object]], part: str) -> str:
    return str(written.get(part, {}).get("catalog", ""))
