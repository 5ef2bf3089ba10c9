"""The table of units against pint, where pint reads a spelling right, and against the traps, where it does not."""

from __future__ import annotations

from math import pi

import pytest

from torquerig.errors import UnitError
from torquerig.units import UNITS, in_unit, kind_of, parse_quantity, si_unit, written_quantity

# pint reads these as something else or not at all (newton-metre as textile count, rpm as a frequency)
NOT_FOR_PINT = {"torque", "speed", "share", "rms current", "torque constant (per rms ampere)", "price", "data", "order"}
RENAMED = {
    "ohm": "ohm",
    "Ohm": "ohm",
    "mohm": "milliohm",
    "kohm": "kiloohm",
    "kip": "kip",
    "in": "inch",
    "min": "minute",
    "rev": "turn",
    "rev/s^2": "turn/s^2",
    "g0": "standard_gravity",
    "lbm*ft^2": "pound*foot**2",
    "lbm*in^2": "pound*inch**2",
    "lbf*in*s^2": "pound_force*inch*second**2",
    "ozf*in*s^2": "force_ounce*inch*second**2",
    "ozm*in^2": "ounce*inch**2",
    "lbf*ft*s^2": "pound_force*foot*second**2",
    "kgf*m*s^2": "kilogram_force*meter*second**2",
    "kgf*cm*s^2": "kilogram_force*centimeter*second**2",
    "gf*cm*s^2": "force_gram*centimeter*second**2",
    "N*m/krpm": "newton*meter/kilorpm",
    "mN*m/krpm": "millinewton*meter/kilorpm",
    "ozf*in/krpm": "force_ounce*inch/kilorpm",
    "lbf*in/krpm": "pound_force*inch/kilorpm",
    "lbf*in/rad": "pound_force*inch/radian",
    "lbf*in/deg": "pound_force*inch/degree",
    "lbf*in/arcmin": "pound_force*inch/arcminute",
    "lbf*ft/rad": "pound_force*foot/radian",
    "PS": "metric_horsepower",
    "degC/W": "kelvin/watt",
    "ozf*in/A": "force_ounce*inch/ampere",
    "lbf*in/A": "pound_force*inch/ampere",
}


def test_units_agree_with_pint() -> None:
    pint = pytest.importorskip("pint")
    registry = pint.UnitRegistry()
    tried = 0
    for kind, spellings in UNITS.items():
        first = si_unit(next(iter(spellings)))
        for spelling, factor in spellings.items():
            compact = any(part in spelling for part in ("Nm", "kgm", "kgcm", "gcm", "Ncm", "Ns/", "per ", "Vs"))
            if kind in NOT_FOR_PINT or compact or kind == "rate":
                continue
            read = registry.Quantity(1, RENAMED.get(spelling, spelling)).to(RENAMED.get(first, first))
            assert read.magnitude == pytest.approx(factor, rel=1e-9), spelling
            tried += 1
    assert tried > 50


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("3 Nm", "N*m", 3.0),
        ("3 mNm", "N*m", 0.003),
        ("600 rpm", "rad/s", 600 * 2 * pi / 60),
        ("10 Hz", "Hz", 10.0),
        ("135 gcm²", "kg*m^2", 135e-7),
        ("3 Ncm", "N*m", 0.03),
        ("4000 min-1", "rad/s", 4000 * 2 * pi / 60),
        ("1.2 Ohm", "ohm", 1.2),
        ("100 EUR", "EUR", 100.0),
        ("0.277 x10^-4 kg m2", "kg*m^2", 0.277e-4),
        ("0.277×10⁻⁴ kg·m²", "kg*m^2", 0.277e-4),
        ("1 lb in^2", "kg*m^2", 2.926396534292e-4),
        ("1 oz-in-sec²", "kg*m^2", 7.061551814226044e-3),
        ("2 HP", "W", 2 * 745.6998715822702),
        ("3.3 Nm/arcmin", "N*m/rad", 3.3 * 10800 / pi),
        ("5 %", "1", 0.05),
        ("0.5 N m", "N*m", 0.5),
        ("2 kN/m", "N/m", 2e3),
        ("2 MN/m", "N/m", 2e6),
    ],
)
def test_data_sheet_spellings_are_read(text: str, unit: str, value: float) -> None:
    assert parse_quantity(text, unit) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "unit", "words"),
    [
        ("5,2 N*m", "N*m", "decimal comma; write '5.2 N*m'"),
        ("3 N", "N*m", "is a force; a torque is wanted, write '3 N*m'"),
        ("0.5", "N*m", "has no unit; write '0.5 N*m'"),
        ("3 ozz*in", "N*m", "unknown unit; did you mean 'ozf*in'"),
        ("600 rpm", "Hz", "is a speed; a frequency is wanted"),
        ("3 J", "kg*m^2", "is an energy; an inertia is wanted"),
        ("about 3", "1", "does not start with a number; write for example '1.5'"),
    ],
)
def test_wrong_units_are_refused_with_the_remedy(text: str, unit: str, words: str) -> None:
    with pytest.raises(UnitError) as caught:
        parse_quantity(text, unit)
    assert words in str(caught.value)


def test_written_quantities_read_back_to_the_same_float() -> None:
    for unit in ("N*m", "kg*m^2", "1"):
        for value in (0.1 + 0.2, 1e-10 / 3, 12345.678901234567):
            assert parse_quantity(written_quantity(value, unit), unit) == value
    assert in_unit(2 * pi * 1000 / 60, "rpm") == pytest.approx(1000)
    assert kind_of("Nms/rad") == "rotary damping"
