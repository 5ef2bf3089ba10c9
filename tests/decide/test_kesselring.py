"""Weighted points: unknowns are intervals, and nobody's score depends on the others."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from torquerig.decide.kesselring import TEACHING, VDI_2225, Profile, kesselring, kesselring_from_points
from torquerig.decide.matrix import Better, Cell, Criterion, DecisionMatrix, Kind, ValueFunction
from torquerig.errors import InputError

CRITERIA = (
    Criterion(name="ripple", better=Better.LESS, value=ValueFunction(((0.0, 5.0), (10.0, 1.0))), weight=3.0),
    Criterion(name="speed", value=ValueFunction(((0.0, 1.0), (5.0, 4.0), (10.0, 5.0))), weight=1.0),
    Criterion(name="remark only"),
)
numbers = st.floats(0, 10)
rows = st.lists(st.tuples(st.one_of(st.none(), numbers), numbers), min_size=2, max_size=6)


def matrix_of(table):
    cells = {}
    for name, (ripple, speed) in table.items():
        cells[name, "ripple"] = Cell() if ripple is None else Cell(value=ripple)
        cells[name, "speed"] = Cell(value=speed)
    return DecisionMatrix(alternatives=tuple(table), criteria=CRITERIA, cells=cells)


@given(rows, st.data())
def test_adding_or_removing_an_alternative_never_reorders_the_others(given_rows, data):
    table = {f"m{place}": row for place, row in enumerate(given_rows)}
    gone = data.draw(st.sampled_from(sorted(table)))
    whole = kesselring(matrix_of(table))
    fewer = kesselring(matrix_of({name: row for name, row in table.items() if name != gone}))
    kept = [place for place, name in enumerate(whole.alternatives) if name != gone]
    assert whole.total_low[kept].tolist() == fewer.total_low.tolist()
    assert whole.total_high[kept].tolist() == fewer.total_high.tolist()
    assert np.argsort(whole.total[kept], kind="stable").tolist() == np.argsort(fewer.total, kind="stable").tolist()


def test_an_unknown_cell_gives_the_whole_scale_and_not_zero():
    result = kesselring(matrix_of({"a": (None, 10.0), "b": (0.0, 0.0)}))
    assert (result.low[0, 0], result.high[0, 0]) == (1, 5)
    assert (result.total_low[0], result.total_high[0]) == (3 * 1 + 5, 3 * 5 + 5)
    best, worst = result.rank_range
    assert (best.tolist(), worst.tolist()) == ([1, 1], [2, 2])


def test_an_interval_gives_an_interval_of_points():
    cells = {("a", "ripple"): Cell(low=0.0, high=5.0), ("a", "speed"): Cell(value=5.0, low=0.0, high=10.0)}
    result = kesselring(DecisionMatrix(alternatives=("a",), criteria=CRITERIA, cells=cells))
    assert result.low.tolist() == [[3, 1]]
    assert result.high.tolist() == [[5, 5]]
    assert result.middle.tolist() == [[4, 4]]


def test_weights_are_shown_raw_and_normalised_with_a_warning():
    result = kesselring(matrix_of({"a": (0.0, 10.0)}))
    assert result.normalised.tolist() == [0.75, 0.25]
    assert "sum to 4" in result.warning
    assert (result.ideal, float(result.total[0]), float(result.share[0])) == (20, 20, 1)


@given(st.lists(st.floats(0.1, 5), min_size=2, max_size=2), st.floats(0.01, 100))
def test_the_share_does_not_depend_on_the_sum_of_the_weights(weights, factor):
    points = {"a": [3.0, 2.0], "b": [None, 4.0]}

    def share(scale):
        return kesselring_from_points(points, weights=dict(zip("xy", [scale * w for w in weights], strict=True))).share

    assert share(factor) == pytest.approx(share(1.0), rel=1e-12)  # rounding only


def test_a_low_cell_in_a_high_total_is_a_weak_spot():
    points = {"a": [4.0, 4.0, 1.0], "b": [1.0, 1.0, 1.0], "c": [4.0, 4.0, None]}
    result = kesselring_from_points(points, weights={"x": 0.4, "y": 0.4, "z": 0.2}, profile=VDI_2225)
    assert [(spot.alternative, spot.criterion) for spot in result.weak_spots] == [("a", "z")]


def test_technical_and_economic_criteria_can_be_rated_apart():
    price = Criterion(
        name="price", better=Better.LESS, value=ValueFunction(((0.0, 5.0), (9.0, 1.0))), weight=1.0, kind=Kind.ECONOMIC
    )
    matrix = DecisionMatrix(alternatives=("a",), criteria=(*CRITERIA, price))
    assert kesselring(matrix.only(kind=Kind.ECONOMIC)).criteria == ("price",)
    assert kesselring(matrix.only(kind=Kind.TECHNICAL)).criteria == ("ripple", "speed")


@pytest.mark.parametrize(
    ("points", "weights", "said"),
    [
        ({"a": [6.0]}, {"x": 1.0}, "outside the scale 1..5"),
        ({"a": [0.5]}, {"x": 1.0}, "outside the scale 1..5"),
        ({"a": [3.0]}, {"x": -1.0}, "at least 0"),
        ({"a": [3.0]}, {"x": 0.0}, "not all 0"),
        ({"a": [3.0]}, {"x": 1.0, "y": 1.0}, "1 of 2 criteria"),
    ],
)
def test_given_points_and_weights_are_checked(points, weights, said):
    with pytest.raises(InputError, match=said):
        kesselring_from_points(points, weights=weights)


def test_a_weighted_criterion_needs_points_inside_the_scale():
    matrix = matrix_of({"a": (0.0, 0.0)})
    with pytest.raises(InputError, match=r"5 points are outside the scale 0..4"):
        kesselring(matrix, profile=VDI_2225)
    with pytest.raises(InputError, match="no value function"):
        kesselring(DecisionMatrix(alternatives=("a",), criteria=(Criterion(name="x", weight=1.0),)))
    with pytest.raises(InputError, match="all weights are 0"):
        kesselring(DecisionMatrix(alternatives=("a",), criteria=(Criterion(name="x"),)))
    with pytest.raises(InputError, match="run upwards"):
        Profile(name="odd", p_min=5, p_max=1)


def test_the_profiles_have_the_published_scales():
    assert (TEACHING.p_min, TEACHING.p_max, VDI_2225.p_min, VDI_2225.p_max) == (1, 5, 0, 4)
