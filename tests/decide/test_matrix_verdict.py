"""The four words, each with a matrix that earns it."""

import pytest

from torquerig.decide.eliminate import eliminate
from torquerig.decide.kesselring import kesselring
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, Demand, ValueFunction
from torquerig.decide.near_miss import near_misses
from torquerig.decide.robustness import robustness
from torquerig.decide.verdict import Word, verdict_of

LINE = ValueFunction(((1.0, 1.0), (5.0, 5.0)))
CRITERIA = (
    Criterion(name="x", value=LINE, weight=0.5),
    Criterion(name="y", value=LINE, weight=0.5),
    Criterion(name="load", unit="N*m", demand=Demand(high=10.0)),
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
        ({"a": (5, 5), "b": (2, 2)}, Word.ROBUST),
        ({"a": (4, 2), "b": (2, 3.9)}, Word.FRAGILE),
        ({"a": (4, 2), "b": (2, 4)}, Word.TIE),
        ({"a": (4, 4), "b": (4, 4), "c": (1, 1)}, Word.TIE),
        ({"a": (OPEN, OPEN), "b": (OPEN, OPEN)}, Word.UNDECIDABLE),
        ({"a": (4, 3), "b": (OPEN, 3.5)}, Word.UNDECIDABLE),
        ({"a": (5, 5, Cell()), "b": (2, 2)}, Word.UNDECIDABLE),
        ({"a": (5, 5), "b": (2, 2, Cell())}, Word.ROBUST),
        ({"a": (3, 3)}, Word.ROBUST),
    ],
)
def test_the_word(rows, word):
    assert judged(**rows).word is word


def test_the_verdict_is_split_by_what_is_in_doubt():
    found = judged(a=(4, 2), b=(2, 3.5))
    assert found.words["intervals"] is Word.ROBUST
    assert found.words["scores"] is Word.FRAGILE
    assert set(found.chances) == {"intervals", "scores", "weights", "together"}
    assert found.lead == pytest.approx(0.05)
    assert "a is in front, 0.050 in T/T_max before b. The verdict is fragile" in found.sentence()


def test_an_open_demand_of_the_winner_stands_in_the_sentence():
    found = judged(a=(5, 5, Cell(unknown_reason="peak load of a")), b=(2, 2))
    assert found.conditions == ("a: peak load of a",)
    assert "Still open: a: peak load of a." in found.sentence()


def test_where_nobody_is_left_the_word_says_so():
    chart = eliminate(
        DecisionMatrix(alternatives=("a",), criteria=CRITERIA, cells={("a", "load"): Cell(value=10.5, source="p. 3")})
    )
    found = verdict_of(chart, None, {})
    assert (found.word, found.winners) == (Word.NOBODY, ())
    (near,) = near_misses(chart)
    assert near.share == pytest.approx(0.05)
    assert near.sentence().startswith("a misses by 5.0% of the limit only: - load <= 10 N*m: it is 10.5 N*m")
    assert near_misses(chart, within=0.04) == ()
