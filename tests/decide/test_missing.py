"""What to ask for first: closed forms of the gain, thresholds, requirements, and facts that several cells share."""

import pytest

from torquerig.decide.matrix import Better, Cell, Criterion, DecisionMatrix, Requirement, ValueFunction
from torquerig.decide.value_of_information import missing_facts

LINE = ValueFunction(((1.0, 1.0), (5.0, 5.0)))
STEP = 1e-3  # the interval is walked in a thousand steps


def matrix_of(table, criteria=None):
    criteria = (Criterion(name="x", value=LINE, weight=1.0, unit="N*m"),) if criteria is None else criteria
    cells = {(name, one.name): cell for name, row in table.items() for one, cell in zip(criteria, row, strict=True)}
    return DecisionMatrix(alternatives=tuple(table), criteria=criteria, cells=cells)


def test_the_gain_of_one_fact_is_the_closed_form():
    # a 3.5 is known, b lies in 2..4 (middle 3): it wins above 3.5, by 0.25 on average there, in a quarter of cases
    (fact,) = missing_facts(matrix_of({"a": (Cell(value=3.5),), "b": (Cell(low=2.0, high=4.0),)}))
    assert fact.fact == "x of b"
    assert fact.p_change == pytest.approx(0.25, abs=STEP)
    assert fact.gain == pytest.approx(0.25 * 0.25 / 5, abs=STEP / 5)
    (turn,) = fact.ranges
    assert (turn.winner, turn.low, turn.high) == ("b", pytest.approx(3.5, abs=0.005), 4.0)
    assert fact.sentence() == "ask the maker for the x of b: b wins from 3.5 to 4 N*m (25% of its range)"


def test_the_most_useful_fact_stands_first_and_a_harmless_one_says_so():
    facts = missing_facts(
        matrix_of({"a": (Cell(value=3.5),), "b": (Cell(low=2.0, high=4.0),), "c": (Cell(low=1.0, high=4.5),),
                   "d": (Cell(low=1.0, high=2.0, unknown_reason="torque constant of d"),)})
    )  # fmt: skip
    assert [fact.fact for fact in facts] == ["x of c", "x of b", "torque constant of d"]
    assert not facts[-1].decisive
    assert facts[-1].sentence() == "ask the maker for the torque constant of d: alone it cannot change the winner"


def test_the_winners_own_fact_counts_too_and_an_unknown_is_told_in_points():
    (fact,) = missing_facts(matrix_of({"a": (Cell(value=2.0),), "b": (Cell(),)}))
    assert fact.unit == "points"
    assert fact.ranges[0].winner == "a"
    assert (fact.ranges[0].low, fact.ranges[0].high) == (1.0, pytest.approx(2.0, abs=0.005))
    assert fact.p_change == pytest.approx(0.25, abs=STEP)


def test_a_fact_behind_several_cells_is_asked_once_and_moves_them_together():
    shared = Cell(low=2.0, high=5.0, fact="the price of the gearbox")
    (fact,) = missing_facts(matrix_of({"a": (shared,), "b": (shared,), "c": (Cell(value=3.0),)}))
    assert fact.cells == (("a", "x"), ("b", "x"))
    assert fact.ranges[0].winner == "c"  # together they fall below it
    assert {turn.winner for turn in fact.ranges} == {"c"}
    assert fact.sentence().startswith("ask the maker for the price of the gearbox: c wins from 2 to 3 N*m")


def test_an_open_requirement_is_worth_asking_for_without_any_weight():
    criteria = (
        Criterion(name="peak", unit="N*m", better=Better.LESS, requirement=Requirement(high=10.0)),
        Criterion(name="x", value=LINE, weight=1.0),
    )
    table = {"a": (Cell(low=8.0, high=12.0), Cell(value=4.0)), "b": (Cell(value=9.0), Cell(value=3.0))}
    (fact,) = missing_facts(matrix_of(table, criteria))
    assert fact.p_change == pytest.approx(0.5, abs=STEP)
    assert fact.ranges[0].winner == "b"
    assert fact.gain == pytest.approx(0.5 * 3.0 / 5, abs=STEP)  # without knowing, half the time nothing is got
    alone = missing_facts(matrix_of({"a": table["a"]}, criteria))[0]
    assert "no alternative wins from 10 to 12 N*m" in alone.sentence()


def test_an_unknown_requirement_without_weight_is_a_question_with_yes_or_no():
    criteria = (
        Criterion(name="servo", unit="yes/no", requirement=Requirement(low=1.0)),
        Criterion(name="peak", unit="N*m", better=Better.LESS, requirement=Requirement(high=10.0)),
        Criterion(name="x", value=LINE, weight=1.0),
    )
    known = (Cell(value=1.0), Cell(value=9.0), Cell(value=3.0))
    asked = Cell(fact="whether a is a servo motor")
    told = [
        missing_facts(matrix_of({"a": row, "b": known}, criteria))[0].sentence()
        for row in ((asked, Cell(value=9.0), Cell(value=4.0)), (Cell(value=1.0), Cell(), Cell(value=4.0)))
    ]
    assert told == [
        "ask the maker whether a is a servo motor: if not, b wins",
        "ask the maker for the peak of a: if it breaks the requirement (peak <= 10 N*m), b wins",
    ]


def test_where_demands_leave_nobody_there_is_nothing_to_ask():
    criteria = (Criterion(name="x", value=LINE, weight=1.0, requirement=Requirement(low=9.0)),)
    assert missing_facts(matrix_of({"a": (Cell(value=3.0),)}, criteria)) == ()
