"""How an estimate reads in a table and an out-of-range value in a message."""

import pytest

from torquerig.parameter import Estimate, Parameter

RPM = 3.141592653589793 / 30


def test_large_numbers_are_shown_without_an_exponent():
    assert Estimate(low=5000 * RPM, high=6000 * RPM, unit="rpm").shown() == "? (5000..6000 rpm)"
    assert Estimate(value=11300.0, evidence="DOC", unit="N*m/rad").shown() == "11300 N*m/rad"


def test_an_interval_of_one_point_is_shown_as_one_number():
    assert Estimate(low=3000 * RPM, high=3000 * RPM, unit="rpm").shown() == "? (3000 rpm)"


def test_an_out_of_range_value_is_named_in_the_unit_of_the_declaration():
    with pytest.raises(ValueError, match=r"-10\.0 rpm is out of range: speed must be more than 0"):
        Parameter("rpm", "speed", above=0).read("-10 rpm")


def test_a_value_outside_its_own_interval_is_refused():
    written = {"value": "3 N*m", "low": "1 N*m", "high": "2 N*m", "evidence": "RT", "source": "x"}
    with pytest.raises(ValueError, match="the value is outside low and high"):
        Parameter("N*m", "torque").read_estimate(written)


@pytest.mark.parametrize(
    ("broken", "sentence"),
    [
        ({"one_of": 4}, "one_of is 4; write a list"),
        ({"value": "1 N*m", "rel_sd": -0.1}, "rel_sd is -0.1; write the relative"),
        ({"value": "1 N*m", "rel_sd": [0.1]}, r"rel_sd is \[0.1\]; write the relative"),
        ({7: 1, "valeu": "1 N*m"}, "unknown key '7'"),
    ],
)
def test_a_broken_mapping_is_refused_in_words(broken, sentence):
    with pytest.raises(ValueError, match=sentence):
        Parameter("N*m", "torque").read_estimate({**broken, "evidence": "DOC", "source": "x"})
