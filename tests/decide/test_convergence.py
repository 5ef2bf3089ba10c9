"""The baseline changes until it stands: a run by hand, circles, and what unknowns do to it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from torquerig.decide.convergence import converge, cycles
from torquerig.decide.matrix import Better, Cell, Criterion, DecisionMatrix, Indifference
from torquerig.decide.pugh import pugh, sweep_baselines
from torquerig.errors import UnknownNameError

CRITERIA = tuple(Criterion(name=name) for name in ("speed", "torque", "cheapness"))


def matrix_of(table, criteria=CRITERIA):
    cells = {
        (name, one.name): Cell() if value is None else Cell(value=float(value))
        for name, row in table.items()
        for one, value in zip(criteria, row, strict=True)
    }
    return DecisionMatrix(alternatives=tuple(table), criteria=criteria, cells=cells)


values = st.one_of(st.none(), st.integers(0, 4))
tables = st.dictionaries(st.sampled_from("abcdef"), st.tuples(values, values, values), min_size=2)


def test_the_strongest_becomes_the_baseline_until_it_stands():
    found = converge(matrix_of({"old": (1, 1, 3), "mid": (2, 2, 2), "new": (3, 3, 1)}), "old")
    assert [(step.baseline, step.strongest) for step in found.steps] == [("old", "mid"), ("mid", "new"), ("new", "new")]
    assert (found.stable, found.cycle, found.sure) == ("new", (), True)
    assert found.steps[0].negatives == ("cheapness",)
    assert found.steps[0].undiscriminating == CRITERIA_NAMES


CRITERIA_NAMES = tuple(one.name for one in CRITERIA)


@given(tables, st.data())
def test_it_ends_with_a_baseline_that_stands_or_in_a_circle(table, data):
    matrix = matrix_of(table)
    found = converge(matrix, data.draw(st.sampled_from(sorted(table))))
    assert len(found.steps) <= len(table)
    assert bool(found.stable) != bool(found.cycle)
    if found.stable:
        assert (pugh(matrix, found.stable).net_certain <= 0).all()
    if found.sure:
        assert (pugh(matrix, found.stable).net_high <= 0).all()
    for name in found.cycle:
        assert pugh(matrix, name).net_certain.max() > 0


@given(tables)
def test_each_circle_is_a_chain_of_sure_wins(table):
    sweep = sweep_baselines(matrix_of(table))
    places = {name: place for place, name in enumerate(sweep.alternatives)}
    for circle in cycles(sweep):
        assert len(circle) >= 3
        for strong, weak in zip(circle, (*circle[1:], circle[0]), strict=True):
            assert sweep.beats[places[strong], places[weak]]
    if sweep.condorcet_winner:
        assert sweep.condorcet_winner not in {name for circle in cycles(sweep) for name in circle}


def test_condorcets_circle_is_found_and_no_baseline_stands():
    matrix = matrix_of({"a": (3, 2, 1), "b": (2, 1, 3), "c": (1, 3, 2), "last": (0, 0, 0)})
    assert cycles(sweep_baselines(matrix)) == (("a", "b", "c"),)
    found = converge(matrix, "last")
    assert not found.stable
    assert set(found.cycle) == {"a", "b", "c"}


def test_a_baseline_that_stands_only_by_what_is_known_is_not_sure():
    found = converge(matrix_of({"a": (2, 2, 1), "b": (1, 1, None)}), "a")
    assert (found.stable, found.sure) == ("a", True)
    found = converge(matrix_of({"a": (2, 1, 1), "b": (1, None, None)}), "a")
    assert (found.stable, found.sure) == ("a", False)


def test_weak_ones_and_flat_criteria_are_named():
    price = Criterion(name="price", better=Better.LESS, indifference=Indifference(relative=0.1))
    table = {"ref": (10, 2, 2), "bad": (20, 1, 2), "good": (20, 3, 2)}
    step = converge(matrix_of(table, (price, *CRITERIA[:2])), "ref").steps[0]
    assert step.weak == ("bad",)
    assert step.undiscriminating == ("price", "torque")
    with pytest.raises(UnknownNameError, match="did you mean 'ref'"):
        converge(matrix_of(table, (price, *CRITERIA[:2])), "reff")
