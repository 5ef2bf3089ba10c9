"""Numbers beyond reason are refused with the nearest sensible one; those of every shipped file are far from it."""

from __future__ import annotations

import re

import pytest

from torquerig.parameter import Parameter
from torquerig.sensible import LIMITS, beyond_sense
from torquerig.units import UNITS, parse_quantity


def test_every_kind_of_quantity_has_its_limits() -> None:
    rotary_and_linear = {*UNITS} - {*LIMITS}
    assert rotary_and_linear <= {"acceleration", "pressure"}  # quantities of recordings, of which no part has one
    assert all(0 < smallest < largest for smallest, largest in LIMITS.values())


@pytest.mark.parametrize("kind", LIMITS)
@pytest.mark.parametrize("sign", [1, -1])
def test_the_stated_limit_is_itself_accepted(kind: str, sign: int) -> None:
    unit = next(iter(UNITS[kind]))
    parameter = Parameter(unit, "value")
    for beyond in (10 * LIMITS[kind][1], 0.1 * LIMITS[kind][0]):
        with pytest.raises(ValueError, match="sensible size is") as refused:
            parameter.checked(sign * beyond)
        remedy = str(refused.value).rpartition("sensible size is ")[2]
        assert parameter.checked(sign * (float(remedy) if unit == "1" else parse_quantity(remedy, unit)))
    assert parameter.checked(0.0) == 0.0
    assert beyond_sense(sign * LIMITS[kind][1], kind) is None


@pytest.mark.parametrize(
    ("written", "unit", "said"),
    [
        (
            "1e15 N*m/rad",
            "N*m/rad",
            "1000000000000000.0 N*m/rad is beyond reason for x; the largest sensible size is 10",
        ),
        ("1e-12 kg*m^2", "kg*m^2", "1e-12 kg*m^2 is beyond reason for x; the smallest sensible size is 1e-11 kg*m^2"),
        ("1e300 Hz", "Hz", "the largest sensible size is 1000000000.0 Hz"),
        ("1e12 rpm", "rad/s", "the largest sensible size is 1000000.0 rad/s"),
        ("1e-300 s", "s", "the smallest sensible size is 1e-12 s"),
        ("65 bit", "bit", "the largest sensible size is 64.0 bit"),
    ],
)
def test_the_refusal_names_the_nearest_sensible_size(written: str, unit: str, said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)):
        Parameter(unit, "x").read(written)
