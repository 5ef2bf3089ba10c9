"""Dominance: what must hold for any matrix, and what open facts leave open."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from torquerig.decide.kesselring import kesselring
from torquerig.decide.matrix import Better, Cell, Criterion, DecisionMatrix, ValueFunction
from torquerig.decide.pareto import dominance

CRITERIA = (
    Criterion(name="speed", value=ValueFunction(((0.0, 1.0), (9.0, 5.0))), weight=1.0),
    Criterion(name="price", better=Better.LESS, value=ValueFunction(((0.0, 5.0), (5.0, 1.0))), weight=2.0),
)
cell = st.one_of(
    st.just(Cell()),
    st.integers(0, 5).map(lambda value: Cell(value=float(value))),
    st.tuples(st.integers(0, 4), st.integers(1, 4)).map(lambda ends: Cell(low=ends[0], high=ends[0] + ends[1])),
)
tables = st.lists(st.tuples(cell, cell), min_size=2, max_size=6)


def matrix_of(rows):
    names = tuple(f"m{place}" for place in range(len(rows)))
    cells = {(name, one.name): held for name, row in zip(names, rows, strict=True)
             for one, held in zip(CRITERIA, row, strict=True)}  # fmt: skip
    return DecisionMatrix(alternatives=names, criteria=CRITERIA, cells=cells)


@given(tables)
def test_everybody_is_efficient_open_or_dominated_and_somebody_stays(rows):
    matrix = matrix_of(rows)
    found = dominance(matrix)
    parts = [*found.efficient, *found.open, *found.dominated]
    assert sorted(parts) == sorted(matrix.alternatives)
    assert set(found.dominated) != set(matrix.alternatives)
    assert not (found.surely & found.surely.T).any()
    assert not (found.surely & ~found.possibly).any()


@given(tables)
def test_who_is_surely_dominated_has_never_the_higher_total(rows):
    matrix = matrix_of(rows)
    found, result = dominance(matrix), kesselring(matrix)
    for strong, weak in np.argwhere(found.surely):
        assert result.total_low[strong] >= result.total_high[weak] - 1e-12


@given(tables, st.integers(0, 2**31))
def test_no_draw_of_the_values_contradicts_what_is_sure(rows, seed):
    matrix = matrix_of(rows)
    low, high = matrix.bounds
    rng = np.random.default_rng(seed)
    values = np.where(
        np.isnan(low), rng.uniform(-9, 20, low.shape), rng.uniform(np.nan_to_num(low), np.nan_to_num(high))
    )
    drawn = dominance(matrix_of([tuple(Cell(value=float(one)) for one in row) for row in values]))
    before = dominance(matrix)
    assert not (before.surely & ~drawn.surely).any()
    assert not (drawn.surely & ~before.possibly).any()


def test_an_open_fact_leaves_the_place_open_and_equals_do_not_dominate():
    known = (Cell(value=3.0), Cell(value=2.0))
    found = dominance(matrix_of([known, (Cell(value=2.0), Cell()), known, (Cell(value=1.0), Cell(value=3.0))]))
    assert found.efficient == ("m0", "m2")
    assert found.open == ("m1",)  # with a price below 2 it is efficient, else out
    assert dict(found.dominated) == {"m3": ("m0", "m2")}
