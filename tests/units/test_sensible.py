"""Numbers beyond reason are refused with the nearest sensible one; those of every shipped file are far from it."""

from __future__ import annotations

import re

import pytest

from torquerig.errors import UnitError
from torquerig.parameter import Parameter
from torquerig.units import UNITS, parse_quantity
from torquerig.units.sensible import LIMITS, beyond_sense


def test_every_kind_of_quantity_has_its_limits() -> None:
    rotary_and_linear = {*UNITS} - {*LIMITS}
    assert rotary_and_linear <= {"acceleration", "pressure"}  # quantities of recordings, of which no part has one
    assert all(0 <= smallest < largest for smallest, largest in LIMITS.values())


@pytest.mark.parametrize("kind", LIMITS)
@pytest.mark.parametrize("sign", [1, -1])
def test_the_stated_limit_is_itself_accepted(kind: str, sign: int) -> None:
    unit = next(iter(UNITS[kind]))
    parameter = Parameter(unit, "value")
    for beyond in (10 * LIMITS[kind][1], *([0.1 * LIMITS[kind][0]] if LIMITS[kind][0] else [])):
        with pytest.raises(ValueError, match="sensible size is") as refused:
            parameter.checked(sign * beyond)
        remedy = re.search(r"sensible size is '([^']*)'", str(refused.value))
        assert remedy is not None
        assert parameter.checked(sign * parse_quantity(remedy[1], unit))
    assert parameter.checked(0.0) == 0.0
    assert beyond_sense(sign * LIMITS[kind][1], kind) is None


@pytest.mark.parametrize(
    ("written", "unit", "said"),
    [
        ("1e15 N*m/rad", "N*m/rad", "'1e15 N*m/rad' is beyond reason; the largest sensible size is '1e+12 N*m/rad'"),
        ("1e-12 kg*m^2", "kg*m^2", "'1e-12 kg*m^2' is beyond reason; the smallest sensible size is '1e-11 kg*m^2'"),
        ("1e300 Hz", "Hz", "the largest sensible size is '1e+09 Hz'"),
        ("1e12 rpm", "rad/s", "the largest sensible size is '9.5e+06 rpm'"),
        ("1e-300 s", "s", "the smallest sensible size is '1e-12 s'"),
        ("65 bit", "bit", "the largest sensible size is '64 bit'"),
    ],
)
def test_the_refusal_names_the_nearest_sensible_size(written: str, unit: str, said: str) -> None:
    with pytest.raises(UnitError, match=re.escape(said)):
        Parameter(unit, "x").read(written)
