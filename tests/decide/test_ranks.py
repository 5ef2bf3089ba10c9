"""Rank conventions and what intervals leave open."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from torquerig.decide.ranks import competition_ranks, dense_ranks, rank_intervals


def test_ties_share_a_rank_and_the_next_one_is_skipped():
    assert competition_ranks([3, 2, 2, 1]).tolist() == [1, 2, 2, 4]
    assert dense_ranks([3, 2, 2, 1]).tolist() == [1, 2, 2, 3]


def test_sums_that_differ_in_the_last_bit_are_a_tie():
    assert competition_ranks([0.1 + 0.2, 0.3]).tolist() == [1, 1]
    assert dense_ranks([0.1 + 0.2, 0.3]).tolist() == [1, 1]


@given(st.lists(st.integers(-5, 5), min_size=1, max_size=8))
def test_without_intervals_best_and_worst_rank_are_the_shared_rank(scores):
    best, worst = rank_intervals(scores, scores)
    assert best.tolist() == worst.tolist() == competition_ranks(scores).tolist()


@given(
    st.lists(st.tuples(st.integers(-5, 5), st.integers(0, 4)), min_size=1, max_size=6),
    st.integers(0, 2**31),
)
def test_no_draw_from_the_intervals_leaves_the_rank_range(intervals, seed):
    low = np.array([start for start, _ in intervals], float)
    high = low + np.array([width for _, width in intervals])
    best, worst = rank_intervals(low, high)
    drawn = competition_ranks(np.random.default_rng(seed).uniform(low, high))
    assert (best <= drawn).all()
    assert (drawn <= worst).all()
