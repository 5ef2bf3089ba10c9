"""Flip weights against brute force and published numbers; shares of being best against closed forms."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from torquerig.decide.flips import flip_weights
from torquerig.decide.kesselring import kesselring_from_points
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, ValueFunction
from torquerig.decide.monte_carlo import VALUES_ONLY
from torquerig.decide.robustness import rank_acceptability
from torquerig.errors import InputError, UnknownNameError

IDENTITY = ValueFunction(((1.0, 1.0), (5.0, 5.0)))
scores = st.lists(st.integers(1, 5).map(float), min_size=3, max_size=3)


@given(scores, scores, st.lists(st.integers(1, 9).map(float), min_size=3, max_size=3))
def test_at_the_flip_weight_winner_and_rival_tie_and_beyond_it_they_swap(ours, other, weights):
    names = dict(zip("xyz", weights, strict=True))
    result = kesselring_from_points({"a": ours, "b": other}, weights=names)
    assume(abs(result.total[0] - result.total[1]) > 1e-9)
    for flip in flip_weights(result):

        def lead(weight, flip=flip):
            again = kesselring_from_points({"a": ours, "b": other}, weights={**names, flip.criterion: weight})
            totals = dict(zip(again.alternatives, again.total.tolist(), strict=True))
            return totals[flip.winner] - totals[flip.other]

        if flip.flip is None:
            assert all(lead(weight) > 0 for weight in np.linspace(0, 200, 401))
        else:
            assert lead(flip.flip) == pytest.approx(0, abs=1e-9)
            assert lead(flip.flip + 0.1) * lead(max(flip.flip - 0.1, 0)) <= 1e-9


@pytest.mark.parametrize(
    ("filling", "criterion", "flip"),
    [
        ((4, 2, 4, 2), "mods", 0.175),
        ((5, 2, 2, 2), "mods", 0.175),
        ((4, 2, 4, 2), "inertia", 0.275),
        ((5, 2, 2, 2), "rpm", 0.467),
    ],
)
def test_table_vi_flip_weights_of_the_fourth_motor_are_those_of_the_audit(filling, criterion, flip):
    # Table VI, section 4.2.7, with the fourth motor filled in either way; figures worked out beforehand by hand
    weights = {"rpm": 0.30, "price": 0.10, "inertia": 0.15, "mods": 0.30}
    result = kesselring_from_points({"A": (3.5, 3, 2, 4), "M4": filling}, weights=weights)
    found = {one.criterion: one.flip for one in flip_weights(result, other="M4")}
    assert found[criterion] == pytest.approx(flip, abs=5e-4)  # printed to three decimals


def matrix_of(table):
    criteria = (Criterion(name="x", value=IDENTITY, weight=1.0),)
    return DecisionMatrix(
        alternatives=tuple(table), criteria=criteria, cells={(name, "x"): cell for name, cell in table.items()}
    )


def shares_of(matrix, **drawn):
    return rank_acceptability(matrix, uncertainty=VALUES_ONLY, **drawn)


def test_overlapping_uniform_intervals_give_the_closed_form_share():
    # a uniform on 2..4, b on 3..5: a wins with probability 1/8
    matrix = matrix_of({"a": Cell(low=2.0, high=4.0), "b": Cell(low=3.0, high=5.0)})
    shares = shares_of(matrix, draws=40_000, seed=5)
    assert shares.p_best[0] == pytest.approx(1 / 8, abs=5 * np.sqrt(1 / 8 * 7 / 8 / 40_000))  # five sigma
    assert shares.p_best.sum() == pytest.approx(1)


def test_a_tie_is_shared_and_an_unknown_is_drawn_over_the_scale():
    tied = shares_of(matrix_of({"a": Cell(value=3.0), "b": Cell(value=3.0)}), draws=10)
    assert tied.p_best.tolist() == [0.5, 0.5]
    unknown = shares_of(matrix_of({"a": Cell(value=2.0), "b": Cell()}), draws=40_000)
    assert unknown.p_best[0] == pytest.approx(1 / 4, abs=5 * np.sqrt(1 / 4 * 3 / 4 / 40_000))  # five sigma


def test_the_same_seed_gives_the_same_shares_and_a_hopeless_addition_changes_nothing():
    table = {"a": Cell(low=2.0, high=4.0), "b": Cell(low=2.5, high=3.8)}
    once, again = (shares_of(matrix_of(table), draws=500, seed=9).p_best.tolist() for _ in range(2))
    with_third = shares_of(matrix_of({**table, "c": Cell(low=1.0, high=1.5)}), draws=500, seed=9)
    assert once == again
    assert with_third.p_best.tolist() == [*once, 0.0]


def test_a_flip_needs_two_and_knows_its_rivals():
    with pytest.raises(InputError, match="only one alternative"):
        flip_weights(kesselring_from_points({"a": [3.0]}, weights={"x": 1.0}))
    with pytest.raises(UnknownNameError, match="known are a, b"):
        flip_weights(kesselring_from_points({"a": [3.0], "b": [2.0]}, weights={"x": 1.0}), other="zzz")
