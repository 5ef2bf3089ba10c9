"""A remedy that is followed gives the right number; where two are possible, both are named."""

from __future__ import annotations

import re
from math import pi, sqrt
from pathlib import Path

import pytest
from pydantic import BaseModel, ConfigDict, TypeAdapter

from torquerig.document import parse_document, validated
from torquerig.errors import InputError, UnitError
from torquerig.parameter import Parameter
from torquerig.units import parse_quantity


def _refused(text: str, unit: str) -> str:
    with pytest.raises(UnitError) as refused:
        parse_quantity(text, unit)
    return str(refused.value)


@pytest.mark.parametrize(
    ("text", "unit", "readings"),
    [
        ("5,000 rpm", "rpm", (5000 * pi / 30, 5 * pi / 30)),
        ("1,200 EUR", "EUR", (1200, 1.2)),
        ("-10,500 N*m", "N*m", (-10500, -10.5)),
        ("100,000 N*m/rad", "N*m/rad", (1e5, 100)),
    ],
)
def test_one_comma_before_three_digits_has_two_readings(text: str, unit: str, readings: tuple[float, ...]) -> None:
    said = _refused(text, unit)
    assert "write the one that is meant, without a comma" in said
    proposed = re.findall(r"'([^']*)'", said)[1:]
    assert [parse_quantity(one, unit) for one in proposed] == pytest.approx(list(readings))


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("5,2 N*m", "N*m", 5.2),
        ("0,500 N*m", "N*m", 0.5),
        ("1,2345 N*m", "N*m", 1.2345),
        ("1,234,567 Hz", "Hz", 1234567),
        ("1,234.5 Hz", "Hz", 1234.5),
        ("1.234,5 Hz", "Hz", 1234.5),
        ("1.234.567 Hz", "Hz", 1234567),
        ("12 000 Hz", "Hz", 12000),
        ("1\u202f200,50 EUR", "EUR", 1200.5),
    ],
)
def test_other_separators_have_one_reading(text: str, unit: str, value: float) -> None:
    proposed = re.findall(r"write '([^']*)'", _refused(text, unit))
    assert [parse_quantity(one, unit) for one in proposed] == pytest.approx([value])


def test_an_apostrophe_between_thousands_is_named() -> None:
    assert "has thousands separators; write '5000 EUR'" in _refused("5'000 EUR", "EUR")
    assert "has thousands separators; write '5000 EUR'" in _refused("5’000 EUR", "EUR")


@pytest.mark.parametrize("text", ["5.000 rpm", "0.125 rpm", "1000 rpm", "1e3 rpm", "12.5 rpm", "100 200"])
def test_plain_numbers_are_read_and_no_separator_is_seen_in_them(text: str) -> None:
    assert text == "100 200" or parse_quantity(text, "rpm") > 0


@pytest.mark.parametrize(
    ("text", "unit", "question", "readings"),
    [
        ("0.5 N*m/A", "N*m/Arms", "per peak or per rms ampere?", (0.5, 0.5 * sqrt(2))),
        ("80 mN*m/A", "N*m/Arms", "per peak or per rms ampere?", (0.08, 0.08 * sqrt(2))),
        ("3 A", "Arms", "peak or rms ampere?", (3, 3 / sqrt(2))),
        ("10 Hz", "rad/s", "turns a second", (20 * pi,)),
        ("600 rpm", "Hz", "once a turn", (10,)),
    ],
)
def test_related_kinds_are_converted(text: str, unit: str, question: str, readings: tuple[float, ...]) -> None:
    said = _refused(text, unit)
    assert question in said
    proposed = re.findall(r"'([^']*)'", said)[1:]
    assert [parse_quantity(one, unit) for one in proposed] == pytest.approx(list(readings), rel=1e-5)


@pytest.mark.parametrize(
    ("number", "unit", "said"),
    [
        ("1000", "rad/s", "write '1000 rpm' or '1000 rad/s'"),
        ("4", "rad", "write '4 deg' or '4 rad'"),
        ("3", "N*m", "write '3 N*m'"),
        ("1000", "rpm", "write '1000 rpm' or '1000 rad/s'"),
    ],
)
def test_a_bare_number_gets_the_usual_unit_first(number: str, unit: str, said: str) -> None:
    assert said in _refused(number, unit)
    with pytest.raises(UnitError, match=re.escape(said)):
        Parameter(unit, "x").read(float(number) if unit == "N" else int(number))


class _Motor(BaseModel):
    model_config = ConfigDict(extra="forbid")
    phase_resistance: object
    phase_inductance: object = None
    thermal_resistance: object = None


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("line_to_line_resistance: 1.2 ohm", "two phases in star; write phase_resistance: '0.6 ohm'"),
        ("terminal_resistance: {value: 3 ohm, evidence: DOC}", "write phase_resistance: '1.5 ohm'"),
        ("line_inductance: 5 mH", "write phase_inductance: '2.5 mH'"),
        ("resistance_ll: '?'", "write phase_resistance: half of it"),
        ("resistance: 2 ohm", "of one phase or between two terminals? write phase_resistance: '2 ohm' or '1 ohm'"),
        ("phase_resistence: 2 ohm", "did you mean 'phase_resistance'"),
        ("thermal_resistence: 2 K/W", "did you mean"),
    ],
)
def test_a_resistance_between_terminals_is_halved(written: str, said: str) -> None:
    document = parse_document(f"{written}\n", Path("motor.yaml"))
    with pytest.raises(InputError, match=re.escape(said)):
        validated(document, TypeAdapter(_Motor))
