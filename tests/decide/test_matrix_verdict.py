"""The four words, each with a matrix that earns it."""

import pytest

from torquerig.decide.eliminate import eliminate
from torquerig.decide.kesselring import kesselring
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, Requirement, ValueFunction
from torquerig.decide.near_miss import near_misses
from torquerig.decide.robustness import robustness
from torquerig.decide.verdict import Certainty, verdict_of

LINE = ValueFunction(((1.0, 1.0), (5.0, 5.0)))
CRITERIA = (
    Criterion(name="x", value=LINE, weight=0.5),
    Criterion(name="y", value=LINE, weight=0.5),
    Criterion(name="load", unit="N*m", requirement=Requirement(high=10.0)),
)


def judged(**rows):
    table = {name: (*row, 5)[:3] for name, row in rows.items()}
    cells = {
        (name, one.name): value if isinstance(value, Cell) else Cell(value=float(value))
        for name, row in table.items()
        for one, value in zip(CRITERIA, row, strict=True)
    }
    matrix = DecisionMatrix(alternatives=tuple(table), criteria=CRITERIA, cells=cells)
    return verdict_of(eliminate(matrix), kesselring(matrix), robustness(matrix, draws=4000))


OPEN = Cell(low=1.0, high=5.0)


@pytest.mark.parametrize(
    ("rows", "word"),
    [
        ({"a": (5, 5), "b": (2, 2)}, Certainty.ROBUST),
        ({"a": (4, 2), "b": (2, 3.9)}, Certainty.FRAGILE),
        ({"a": (4, 2), "b": (2, 4)}, Certainty.TIE),
        ({"a": (4, 4), "b": (4, 4), "c": (1, 1)}, Certainty.TIE),
        ({"a": (OPEN, OPEN), "b": (OPEN, OPEN)}, Certainty.OPEN),
        ({"a": (4, 3), "b": (OPEN, 3.5)}, Certainty.OPEN),
        ({"a": (5, 5, Cell()), "b": (2, 2)}, Certainty.OPEN),
        ({"a": (5, 5), "b": (2, 2, Cell())}, Certainty.ROBUST),
        ({"a": (3, 3)}, Certainty.ROBUST),
    ],
)
def test_the_word(rows, word):
    assert judged(**rows).certainty is word


def test_the_verdict_is_split_by_what_is_in_uncertainty():
    found = judged(a=(4, 2), b=(2, 3.5))
    assert found.certainty_of["intervals"] is Certainty.ROBUST
    assert found.certainty_of["scores"] is Certainty.FRAGILE
    assert set(found.best_shares) == {"intervals", "scores", "weights", "together"}
    assert found.lead == pytest.approx(0.05)
    assert "a ranks first, 0.050 in T/T_max ahead of b. The verdict is fragile." in found.sentence()


def test_an_open_requirement_of_the_winner_stands_in_the_sentence():
    found = judged(a=(5, 5, Cell(unknown_reason="peak load of a")), b=(2, 2))
    assert found.conditions == ("a: peak load of a",)
    assert "The verdict is open: answer depends on a: peak load of a." in found.sentence()


def test_where_nobody_is_left_the_word_says_so():
    chart = eliminate(
        DecisionMatrix(alternatives=("a",), criteria=CRITERIA, cells={("a", "load"): Cell(value=10.5, source="p. 3")})
    )
    found = verdict_of(chart, None, {})
    assert (found.certainty, found.winners) == (Certainty.NOBODY, ())
    (near,) = near_misses(chart)
    assert near.share == pytest.approx(0.05)
    assert near.sentence().startswith("a misses by 5.0% of the limit only: - load <= 10 N*m: it is 10.5 N*m")
    assert near_misses(chart, within=0.04) == ()
