"""Rows of ``torquerig catalog``: documented values as numbers, others as ``?`` with their interval."""

from __future__ import annotations

from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.motor import Motor
from torquerig.catalog.reading import Catalog
from torquerig.parameter import Estimate

Row = dict[str, str]


def catalog_tables(catalog: Catalog) -> dict[str, list[Row]]:
    """Return the rows of each part of the catalog, under its heading."""
    return {
        "motors": motor_rows(catalog),
        "gearboxes": gearbox_rows(catalog),
        "sensors": sensor_rows(catalog),
        "couplings": coupling_rows(catalog),
        "classes": class_rows(catalog),
    }


def class_rows(catalog: Catalog) -> list[Row]:
    """Return one row per class."""
    return [
        {
            "name": part.name,
            "of": f"{part.of} ({', '.join(part.kinds)})" if part.kinds else part.of,
            "title": part.title,
        }
        for part in catalog.classes.values()
    ]


def motor_rows(catalog: Catalog) -> list[Row]:
    """Return one row per motor, with its aliases in the last column."""
    return [
        {
            "name": motor.name,
            "kind": motor.kind,
            "rated torque": motor.rated_torque.shown(),
            "peak torque": motor.peak_torque.shown(),
            "rated speed": motor.rated_speed.shown(),
            "max speed": motor.max_speed.shown(),
            "inertia": motor.rotor_inertia.shown("kg*cm^2"),
            "pole pairs": motor.pole_pairs.shown(),
            "slots": _slots(motor),
            "price": motor.price.shown(),
            "also listed as": ", ".join(alias.name for alias in motor.aliases),
        }
        for motor in catalog.motors.values()
    ]


def gearbox_rows(catalog: Catalog) -> list[Row]:
    """Return one row per gearbox."""
    return [
        {
            "name": box.name,
            "kind": box.kind,
            "ratio": f"{box.ratio:g}",
            "rated torque": box.nominal_torque.shown(),
            "peak torque": box.peak_torque.shown(),
            "inertia": box.input_inertia.shown("kg*cm^2"),
            "stiffness": box.stiffness.shown("N*m/arcmin"),
            "backlash": box.backlash.shown(),
            "efficiency": box.efficiency.shown("%"),
            "teeth": _teeth(box),
            "price": box.price.shown(),
        }
        for box in catalog.gearboxes.values()
    ]


def sensor_rows(catalog: Catalog) -> list[Row]:
    """Return one row per torque sensor."""
    return [
        {
            "name": sensor.name,
            "range": sensor.range_torque.shown(),
            "sensitivity": sensor.sensitivity.shown(),
            "bandwidth": sensor.bandwidth.shown(),
            "noise": sensor.noise.shown("mV"),
            "nonlinearity": sensor.nonlinearity_hysteresis.shown("%"),
            "stiffness": sensor.stiffness.shown(),
            "inertia": sensor.inertia.shown("kg*cm^2"),
            "overload": sensor.overload.shown("%"),
            "price": sensor.price.shown(),
        }
        for sensor in catalog.sensors.values()
    ]


def coupling_rows(catalog: Catalog) -> list[Row]:
    """Return one row per coupling."""
    return [
        {
            "name": coupling.name,
            "kind": coupling.kind,
            "rated torque": coupling.rated_torque.shown(),
            "stiffness": coupling.stiffness.shown(),
            "inertia": coupling.inertia.shown("kg*cm^2"),
            "jaws": "" if coupling.kind == "bellows" else coupling.jaws.shown(),
            "price": coupling.price.shown(),
        }
        for coupling in catalog.couplings.values()
    ]


def _slots(motor: Motor) -> str:
    if motor.kind == "induction":
        return f"bars {_shown_counts(motor.rotor_bars)}"
    return _shown_counts(motor.slots)


def _shown_counts(counts: Estimate) -> str:
    if len(counts.choices) <= 4:
        return counts.shown()
    return f"? ({min(counts.choices):g}..{max(counts.choices):g})"


def _teeth(box: Gearbox) -> str:
    sets = box.tooth_sets()
    if not sets:
        return "?"
    return sets[0].spoken if len(sets) == 1 else f"? ({len(sets)} possible sets)"
