"""Shares of the first rank by arrays: those of the compiled kernel, for the whole matrix and each part of it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from torquerig.decide.best_shares import sampled_totals
from torquerig.decide.kesselring import TEACHING
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, ValueFunction
from torquerig.decide.monte_carlo import points_at, points_over
from torquerig.decide.robustness import robustness

BENT = ValueFunction(((0.0, 1.0), (2.0, 4.0), (3.0, 4.0), (8.0, 5.0)))
TABLE = {
    "a": (Cell(value=3.0), Cell(low=0.2, high=7.0), Cell()),
    "b": (Cell(value=3.0), Cell(low=0.2, high=7.0, fact="shared"), Cell(value=1.0)),
    "c": (Cell(low=1.0, high=4.0), Cell(low=0.2, high=7.0, fact="shared"), Cell(value=1.0)),
    "d": (Cell(value=3.0), Cell(value=2.0), Cell(value=2.0)),
    "same as d": (Cell(value=3.0), Cell(value=2.0), Cell(value=2.0)),
}


def matrix_of(table, *, weights=(0.5, 0.3, 0.2)):
    criteria = tuple(Criterion(name=f"c{place}", value=BENT, weight=one) for place, one in enumerate(weights))
    cells = {(name, one.name): cell for name, row in table.items() for one, cell in zip(criteria, row, strict=True)}
    return DecisionMatrix(alternatives=tuple(table), criteria=criteria, cells=cells)


@pytest.mark.parametrize("names", [tuple(TABLE), ("d", "same as d"), ("c", "a"), ("b",)])
def test_shares_are_those_of_the_kernel_for_every_subset(names):
    matrix = matrix_of(TABLE)
    found = sampled_totals(matrix, draws=3000, seed=4).best(names)
    expected = robustness(matrix.only(alternatives=names), draws=3000, seed=4)
    assert list(found) == list(expected)
    for what, one in expected.items():
        assert found[what].alternatives == one.alternatives
        np.testing.assert_array_equal(found[what].p_best, one.p_best)
        np.testing.assert_allclose(found[what].mean_share, one.mean_share, rtol=1e-12)  # sums in another order
        assert found[what].uncertainty == one.uncertainty


@settings(max_examples=50, deadline=None)
@given(
    st.one_of(
        st.just(Cell()),
        st.tuples(st.floats(-2, 6), st.floats(0.01, 5)).map(lambda ends: Cell(low=ends[0], high=ends[0] + ends[1])),
        st.floats(0.1, 1).map(lambda low: Cell(low=low, high=9 * low)),
    )
)
def test_points_over_many_shares_are_those_of_each(cell):
    shares = (np.arange(40) + 0.5) / 40
    criterion = Criterion(name="c", value=BENT, weight=1.0)
    each = [points_at(cell, criterion, TEACHING, share) for share in shares.tolist()]
    assert points_over(cell, criterion, TEACHING, shares).tolist() == each
