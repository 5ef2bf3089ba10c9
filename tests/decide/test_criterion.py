"""What is asked: limits, bands, value functions, and which of them are refused."""

import numpy as np
import pytest

from torquerig.decide.criterion import Better, Criterion, Indifference, Requirement, ValueFunction
from torquerig.errors import InputError


def test_points_lie_on_straight_lines_and_are_level_outside():
    value = ValueFunction(((0.0, 5.0), (10.0, 1.0)))
    assert value.points(np.array([-3.0, 0.0, 5.0, 10.0, 40.0])).tolist() == [5, 5, 3, 1, 1]


def test_span_sees_the_peak_inside_an_interval():
    value = ValueFunction(((0.0, 1.0), (1.0, 5.0), (2.0, 1.0)))
    assert value.span(0.5, 1.5) == (3.0, 5.0)


@pytest.mark.parametrize(
    ("better", "points"), [(Better.MORE, (1, 3, 2)), (Better.LESS, (3, 1, 2)), (Better.BAND, (3, 1, 2))]
)
def test_a_value_function_that_is_not_monotone_is_refused(better, points):
    band = (1.0, 2.0) if better is Better.BAND else None
    with pytest.raises(InputError, match="not monotone"):
        Criterion(
            name="x", better=better, band=band, value=ValueFunction(tuple(enumerate(map(float, points)))), weight=1
        )


def test_the_merit_of_a_band_is_minus_the_distance_from_it():
    criterion = Criterion(name="inertia", better=Better.BAND, band=(2.0, 4.0))
    low, high = criterion.merit(np.array([1.0, 3.0, 5.0, 0.0, np.nan]), np.array([1.0, 3.0, 7.0, 9.0, np.nan]))
    assert low[:4].tolist() == [-1, 0, -3, -5]
    assert high[:4].tolist() == [-1, 0, -1, 0]
    assert np.isnan(low[4])
    assert np.isnan(high[4])


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Criterion(name="x", weight=-0.1), "at least 0"),
        (lambda: Criterion(name="x", better=Better.BAND), "belong together"),
        (lambda: Criterion(name="x", better=Better.BAND, band=(2.0, 1.0)), "swap"),
        (Requirement, "needs a limit"),
        (lambda: Requirement(low=2.0, high=1.0), "swap"),
        (lambda: Indifference(relative=1.0), "below 1"),
        (lambda: Indifference(absolute=-1.0), "at least 0"),
        (lambda: ValueFunction(((0.0, 1.0),)), "at least two"),
        (lambda: ValueFunction(((1.0, 1.0), (1.0, 2.0))), "ascend"),
    ],
)
def test_what_makes_no_sense_is_refused_in_words(make, said):
    with pytest.raises(InputError, match=said):
        make()
