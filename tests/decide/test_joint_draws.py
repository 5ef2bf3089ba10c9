"""The compiled draws against the same hash in plain Python, closed forms, and the audit's published figures."""

from math import exp, log, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from torquerig.decide.kesselring import Profile
from torquerig.decide.lost_cells import lost_cell_values
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, ValueFunction
from torquerig.decide.monte_carlo import Uncertainty, sampling_plan
from torquerig.decide.ranks import competition_ranks
from torquerig.decide.robustness import CHUNK, rank_acceptability, robustness
from torquerig.errors import InputError

BENT = ValueFunction(((0.0, 1.0), (2.0, 4.0), (3.0, 4.0), (8.0, 5.0)))
LINE = ValueFunction(((1.0, 1.0), (5.0, 5.0)))
ALL = Uncertainty(scores=0.5, weights=0.25)
GOLDEN, MASK = 0x9E3779B97F4A7C15, (1 << 64) - 1


def matrix_of(table, *, weights=(0.5, 0.3, 0.2), value=BENT):
    criteria = tuple(Criterion(name=f"c{place}", value=value, weight=one) for place, one in enumerate(weights))
    cells = {(name, one.name): cell for name, row in table.items() for one, cell in zip(criteria, row, strict=True)}
    return DecisionMatrix(alternatives=tuple(table), criteria=criteria, cells=cells)


def uniforms(key, draw):
    """SplitMix64 in whole numbers, apart from the compiled one: two uniforms of 32 bits."""
    number = (int(key) + GOLDEN * draw) & MASK
    number = ((number ^ (number >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    number = ((number ^ (number >> 27)) * 0x94D049BB133111EB) & MASK
    number ^= number >> 31
    return (number >> 32) / 2**32, (number & 0xFFFFFFFF) / 2**32


cell = st.one_of(
    st.just(Cell()),
    st.floats(0, 9).map(lambda value: Cell(value=value)),
    st.tuples(st.floats(0, 6), st.floats(0.01, 5)).map(lambda ends: Cell(low=ends[0], high=ends[0] + ends[1])),
    st.floats(0.1, 1).map(lambda low: Cell(low=low, high=9 * low)),
)
tables = st.dictionaries(st.sampled_from("abcd"), st.tuples(cell, cell, cell), min_size=2)


@pytest.mark.long
@settings(max_examples=30, deadline=None)
@given(tables)
def test_every_total_is_the_weighted_points_of_the_drawn_values(table):
    matrix = matrix_of(table)
    ready = sampling_plan(matrix, uncertainty=ALL, seed=3)
    totals, keys, weight_keys = ready.totals(300), ready.cells[0], ready.weights[1]
    for draw in (0, 255, 256, 299):
        for row, cells in enumerate(table.values()):
            total = 0.0
            for column, one in enumerate(cells):
                first, second = uniforms(keys[row, column], draw)
                low, high = one.bounds
                if one.unknown:
                    points = 1 + 4 * first
                elif high > 5 * low > 0:
                    points = BENT.at(exp(log(low) * (1 - first) + log(high) * first))
                else:
                    points = BENT.at(low + (high - low) * first)
                weight = matrix.criteria[column].weight * (1 + 0.25 * (2 * uniforms(weight_keys[column], draw)[0] - 1))
                total += weight * min(max(points + 0.5 * (2 * second - 1), 1), 5)
            assert totals[row, draw] == pytest.approx(total, abs=1e-9)  # rounding over some ten operations


@pytest.mark.long
@settings(max_examples=30, deadline=None)
@given(tables, st.tuples(cell, cell, cell))
def test_another_candidate_changes_no_draw_of_the_others_and_reorders_nobody(table, added):
    before = sampling_plan(matrix_of(table), uncertainty=ALL, seed=1).totals(500)
    after = sampling_plan(matrix_of({"new": added, **table}), uncertainty=ALL, seed=1).totals(500)[1:]
    assert (before == after).all()


@settings(max_examples=20, deadline=None)
@given(tables)
def test_the_counts_are_the_shared_ranks_of_the_totals(table):
    matrix = matrix_of(table)
    totals = sampling_plan(matrix, uncertainty=ALL).totals(400)
    found = rank_acceptability(matrix, uncertainty=ALL, draws=400)
    assert found.shares.sum(axis=1) == pytest.approx(np.ones(len(table)))
    assert found.shares.sum(axis=0) == pytest.approx(np.ones(len(table)))
    ranks = np.array([competition_ranks(column) for column in totals.T])
    if all(len(set(row)) == len(table) for row in ranks.tolist()):  # no tie in any draw
        for place in range(len(table)):
            assert found.shares[:, place] == pytest.approx((ranks == place + 1).mean(axis=0))


@pytest.mark.long
def test_a_tie_shares_the_ranks_that_it_covers():
    table = {"a": (Cell(value=5.0),) * 3, "b": (Cell(value=4.0),) * 3, "c": (Cell(value=4.0),) * 3}
    found = rank_acceptability(matrix_of(table), uncertainty=Uncertainty(scores=0, weights=0.25), draws=100)
    assert found.shares == pytest.approx(np.array([[1, 0, 0], [0, 0.5, 0.5], [0, 0.5, 0.5]]))
    assert found.mean_rank == pytest.approx([1, 2.5, 2.5])


def test_equal_strangers_take_every_rank_equally_often():
    draws, names = 60_000, "abcde"
    found = rank_acceptability(matrix_of({name: (Cell(),) * 3 for name in names}), draws=draws, seed=2)
    share = 1 / len(names)
    assert found.shares == pytest.approx(share, abs=5 * sqrt(share * (1 - share) / draws))  # five sigma
    assert found.mean_share == pytest.approx(0.6, abs=0.005)  # mid-scale 3 of 5; sigma below 0.001


def test_the_streams_of_two_cells_and_of_points_and_value_are_independent():
    ready = sampling_plan(matrix_of({"a": (Cell(),) * 3, "b": (Cell(),) * 3}), uncertainty=ALL, seed=0)
    keys = np.append(ready.cells[0].ravel(), ready.weights[1])
    drawn = np.array([[uniforms(key, draw) for draw in range(4000)] for key in keys])  # (streams, draws, 2)
    streams = drawn.transpose(0, 2, 1).reshape(2 * len(keys), -1)
    correlation = np.corrcoef(streams) - np.eye(len(streams))
    assert np.abs(correlation).max() < 5 / sqrt(4000)  # five sigma


def test_cells_that_rest_on_one_fact_are_drawn_together():
    shared = Cell(low=1.0, high=5.0, fact="the price list")
    together = sampling_plan(matrix_of({"a": (shared,), "b": (shared,)}, weights=(1.0,), value=LINE)).totals(100)
    assert (together[0] == together[1]).all()
    alone = Cell(low=1.0, high=5.0)
    apart = sampling_plan(matrix_of({"a": (alone,), "b": (alone,)}, weights=(1.0,), value=LINE)).totals(100)
    assert abs(np.corrcoef(apart)[0, 1]) < 0.5


@pytest.mark.long
def test_threads_change_nothing():
    matrix = matrix_of({"a": (Cell(low=1.0, high=3.0),) * 3, "b": (Cell(low=1.5, high=2.0),) * 3, "c": (Cell(),) * 3})
    draws = CHUNK + 1000
    ready = sampling_plan(matrix, seed=4)
    totals = ready.totals(draws)
    best = (totals == totals.max(axis=0)).mean(axis=1)
    assert rank_acceptability(
        matrix, uncertainty=Uncertainty(scores=0, weights=0), draws=draws, seed=4
    ).p_best == pytest.approx(best)


@pytest.mark.parametrize(
    ("uncertainty", "low", "high"),
    [
        (Uncertainty(scores=0.0, weights=0.25), 0.985, 1.00),
        (Uncertainty(scores=0.0, weights=0.50), 0.84, 0.90),
        (Uncertainty(scores=0.5, weights=0.0), 0.66, 0.69),
        (Uncertainty(scores=1.0, weights=0.0), 0.51, 0.55),
        (Uncertainty(scores=0.5, weights=0.25), 0.64, 0.67),
    ],
)
def test_table_vi_probability_of_the_first_motor_is_that_of_the_audit(uncertainty, low, high):
    # Table VI, section 4.2.7: ranges over all 18 half-point fillings of the fourth motor, worked out beforehand
    weights = {"rpm": 0.30, "price": 0.10, "inertia": 0.15, "mods": 0.30}
    profile = Profile(name="0-5", p_min=0, p_max=5)
    value = ValueFunction(((0.0, 0.0), (5.0, 5.0)))
    criteria = tuple(Criterion(name=name, value=value, weight=weight) for name, weight in weights.items())
    known = {"A": (3.5, 3, 2, 4), "B": (3.5, 2, 2, 4), "M3": (2, 2, 3, 3)}
    found = []
    for filling in lost_cell_values(
        (None, None, None, 2.0), weights=tuple(weights.values()), total=2.6, profile=profile
    ):
        table = {**known, "M4": filling}
        cells = {(name, key): Cell(value=float(one)) for name, row in table.items()
                 for key, one in zip(weights, row, strict=True)}  # fmt: skip
        matrix = DecisionMatrix(alternatives=tuple(table), criteria=criteria, cells=cells)
        found.append(rank_acceptability(matrix, profile=profile, uncertainty=uncertainty, draws=20_000).best_share("A"))
    assert len(found) == 18
    assert (min(found), max(found)) == pytest.approx((low, high), abs=0.0125)  # rounding 0.005 and two sigma


def test_each_doubt_is_drawn_on_its_own():
    sure = {"a": (Cell(value=3.0),) * 3, "b": (Cell(value=2.0),) * 3}
    split = robustness(matrix_of(sure, value=LINE), uncertainty=Uncertainty(scores=2.0, weights=0.25), draws=2000)
    assert list(split) == ["intervals", "scores", "weights", "together"]
    assert [split[name].best_share("a") == 1 for name in split] == [True, False, True, False]


@pytest.mark.parametrize("wrong", [{"scores": -0.5}, {"scores": float("nan")}, {"weights": 1.5}, {"weights": -0.1}])
def test_a_doubt_that_makes_no_sense_is_refused(wrong):
    with pytest.raises(InputError, match="uncertainty of"):
        Uncertainty(**wrong)


def test_no_draws_are_refused():
    with pytest.raises(InputError, match="too few"):
        rank_acceptability(matrix_of({"a": (Cell(),) * 3}), draws=0)
