"""The selection chart: Pahl and Beitz's four marks and four decisions."""

import pytest

from torquerig.decide.eliminate import Decision, Mark, chart_from_marks, eliminate
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, Requirement

TORQUE = Criterion(name="torque", unit="N*m", requirement=Requirement(low=0.5, high=6.0))
PRICE = Criterion(name="price", unit="EUR", requirement=Requirement(high=800.0))
COLOUR = Criterion(name="colour")


def chart(torque, price=None, criteria=(TORQUE, PRICE, COLOUR)):
    cells = {("m", "torque"): torque, ("m", "price"): price or Cell(value=500.0)}
    return eliminate(DecisionMatrix(alternatives=("m",), criteria=criteria, cells=cells)).rows[0]


@pytest.mark.parametrize(
    ("cell", "mark"),
    [
        (Cell(value=0.5), Mark.MEETS),
        (Cell(value=6.0), Mark.MEETS),
        (Cell(low=1.0, high=5.0), Mark.MEETS),
        (Cell(low=7.0, high=9.0), Mark.FAILS),
        (Cell(low=0.1, high=0.4), Mark.FAILS),
        (Cell(low=5.0, high=7.0), Mark.UNKNOWN),
        (Cell(), Mark.UNKNOWN),
    ],
)
def test_an_interval_is_judged_whole(cell, mark):
    assert chart(cell).marks["torque"] is mark


def test_a_row_stops_at_its_first_minus():
    row = chart(Cell(value=7.0), Cell(value=900.0))
    assert dict(row.marks) == {"torque": Mark.FAILS}
    assert row.decision is Decision.ELIMINATE


def test_every_minus_carries_rule_limit_value_unit_source_and_near_miss():
    (remark,) = chart(Cell(low=6.5, high=9.0, source="data sheet")).remarks
    assert (remark.limit, remark.unit, remark.source) == (6.0, "N*m", "data sheet")
    assert remark.miss == pytest.approx(0.5)
    assert remark.rule == "0.5 <= torque <= 6 N*m"
    assert remark.sentence() == "- 0.5 <= torque <= 6 N*m: it is 6.5..9 N*m, misses by 0.5 N*m [data sheet]"


def test_unknown_is_open_with_the_missing_fact_and_never_pursue():
    row = chart(Cell(unknown_reason="rated torque of m at 40 degrees"))
    assert row.decision is Decision.OPEN
    assert row.missing == ("rated torque of m at 40 degrees",)


def test_a_wish_never_eliminates():
    row = chart(Cell(value=1.0))
    assert "colour" not in row.marks
    assert row.decision is Decision.PURSUE


def test_a_requirement_in_question_asks_for_revision():
    asked = Criterion(name="torque", requirement=Requirement(high=6.0, in_question="at the motor or at the sensor"))
    row = chart(Cell(value=7.0), criteria=(asked, PRICE))
    assert row.marks["torque"] is Mark.CHECK
    assert row.decision is Decision.REVISE
    assert "at the motor or at the sensor" in row.remarks[0].sentence()


def test_given_marks_follow_the_same_rules():
    drawn = chart_from_marks(
        {"a": [Mark.MEETS, Mark.FAILS, Mark.UNKNOWN], "b": [Mark.MEETS, Mark.UNKNOWN, Mark.MEETS]},
        criteria=["x", "y", "z"],
    )
    assert [row.decision for row in drawn.rows] == [Decision.ELIMINATE, Decision.OPEN]
    assert list(drawn.rows[0].marks) == ["x", "y"]
    assert drawn.with_decision(Decision.OPEN) == ("b",)
