"""Technical and economic rating: the textbook's formulas, their ranges, and their guide values."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from torquerig.decide.kesselring import VDI_2225, kesselring_from_points
from torquerig.decide.matrix import Cell
from torquerig.decide.strength import Rating, Strength, grade, strength, strength_from_cost
from torquerig.errors import InputError

shares = st.floats(0, 1)


def rated(points):
    return kesselring_from_points(points, weights={"x": 0.5, "y": 0.5}, profile=VDI_2225)


@given(shares, shares)
def test_the_hyperbolic_mean_punishes_imbalance_and_the_diagonal_keeps_both(x, y):
    one = Rating(value=np.array([x]), low=np.array([x]), high=np.array([x]))
    other = Rating(value=np.array([y]), low=np.array([y]), high=np.array([y]))
    both = Strength(alternatives=("a",), technical=one, economic=other)
    assert both.hyperbolic[0] <= both.arithmetic[0] + 1e-12
    assert Strength(alternatives=("a",), technical=one, economic=one).hyperbolic[0] == pytest.approx(x, abs=1e-12)


def test_the_technical_rating_is_the_weighted_share_of_the_best_points():
    # x = sum(g p) / (p_max sum(g)), VDI 2225 sheet 3 as textbooks give it
    both = strength(rated({"a": [3.0, 2.0], "b": [4.0, None]}), rated({"a": [4.0, 4.0], "b": [1.0, 1.0]}))
    assert both.technical.value.tolist() == [0.625, 0.75]
    assert (both.technical.low[1], both.technical.high[1]) == (0.5, 1.0)
    assert both.arithmetic[0] == pytest.approx(0.8125)
    assert both.hyperbolic[1] == pytest.approx(np.sqrt(0.75 * 0.25))
    low, high = both.hyperbolic_range
    assert low[1] < both.hyperbolic[1] < high[1]
    assert both.grades() == ("fair", "good")


def test_the_economic_rating_is_the_ideal_cost_over_the_cost():
    # y = H_ideal / H with H_ideal = 0.7 H_permissible
    costs = {"a": Cell(value=1000.0), "b": Cell(low=500.0, high=1400.0)}
    both = strength_from_cost(rated({"a": [3.0, 2.0], "b": [4.0, 4.0], "c": [1.0, 1.0]}), costs, permissible=1000.0)
    assert both.economic.value[0] == pytest.approx(0.7)
    assert (both.economic.low[1], both.economic.high[1]) == pytest.approx((0.5, 1.0))
    assert (both.economic.low[2], both.economic.high[2]) == (0.0, 1.0)


@pytest.mark.parametrize(
    ("value", "word"), [(0.8, "very good"), (0.7, "good"), (0.6, "fair"), (0.59, "unsatisfactory")]
)
def test_the_guide_values_have_words(value, word):
    assert grade(value) == word


def test_costs_that_make_no_sense_are_refused():
    with pytest.raises(InputError, match="must be above 0"):
        strength_from_cost(rated({"a": [3.0, 2.0]}), {}, permissible=0.0)
    with pytest.raises(InputError, match="below 0"):
        strength_from_cost(rated({"a": [3.0, 2.0]}), {"a": Cell(value=-1.0)}, permissible=5.0)
    with pytest.raises(InputError, match="same alternatives"):
        strength(rated({"a": [3.0, 2.0]}), rated({"b": [3.0, 2.0]}))
