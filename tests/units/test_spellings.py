"""Units as loggers and data sheets spell them; what has two meanings keeps both."""

from __future__ import annotations

import pytest

from torquerig.units import UNITS, meanings, parse_quantity

FOOT_POUND = 4.4482216152605 * 0.3048


@pytest.mark.parametrize(
    ("written", "kind", "factor"),
    [
        *((each, "torque", 1.0) for each in ("Nm", "N-m", "N m", "N·m", "N.m", "N*m", "Newton-meters", "newton metre")),
        *((each, "torque", FOOT_POUND) for each in ("lb-ft", "ft-lb", "FTLB", "ft lbf", "lbf·ft", "ft.lbs")),
        *((each, "torque", FOOT_POUND / 12) for each in ("lb.in", "in-lb", "lbf in", "INLB")),
        *((each, "torque", FOOT_POUND / 192) for each in ("oz-in", "ozf*in", "oz in", "in.oz")),
        *((each, "torque", 0.0980665) for each in ("kgf*cm", "kgf-cm", "kg-cm", "kp cm")),
        *(
            (each, "speed", 0.10471975511965977)
            for each in ("rpm", "RPM", "U/min", "1/min", "min-1", "min⁻¹", "rev/min")
        ),
        *((each, "torque constant", 1e-3) for each in ("mN*m/A", "mNm/A", "mN·m/A")),
        *((each, "acceleration", 1.0) for each in ("m/s^2", "m/s²", "m/s2")),
        *((each, "inertia", 1e-4) for each in ("kg cm^2", "kg·cm²", "kgcm2")),
        ("lb in s^2", "inertia", FOOT_POUND / 12),
        ("Volts", "voltage", 1.0),
        ("µV", "voltage", 1e-6),
        ("°/s", "speed", 0.017453292519943295),
        ("bar", "pressure", 1e5),
        ("KW", "power", 1e3),
        ("MW", "power", 1e6),
        ("msec", "time", 1e-3),
    ],
)
def test_a_spelling_means_one_thing(written: str, kind: str, factor: float) -> None:
    (only,) = (one for one in meanings(written) if one.kind == kind)
    assert only.factor == pytest.approx(factor, rel=1e-12)
    assert parse_quantity(f"2.5 {written}", next(iter(UNITS[kind]))) == pytest.approx(2.5 * factor, rel=1e-12)


@pytest.mark.parametrize(
    "written", ["", "x", "S1", "N/A", "E", "Nm/m/q", "abc-def", "NM", "Sample", "*", "/", "^2", "a" * 99]
)
def test_what_is_no_unit_has_no_meaning(written: str) -> None:
    assert meanings(written) == ()


def test_two_meanings_are_both_kept() -> None:
    assert {one.kind for one in meanings("g")} == {"mass", "acceleration"}
    assert {one.kind for one in meanings("kg")} == {"mass", "force"}


def test_case_counts_for_symbols() -> None:
    assert [one.factor for one in meanings("mW")] == [1e-3]
    assert meanings("mn*m") == ()


def test_every_unit_of_the_table_means_itself() -> None:
    for kind, spellings in UNITS.items():
        for spelling, factor in spellings.items():
            (only,) = (one for one in meanings(spelling) if one.kind == kind)
            assert only.factor == pytest.approx(factor, rel=1e-15), spelling
