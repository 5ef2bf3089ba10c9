"""A case written as YAML and read again is the same case."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from torquerig.decide.case import Cost, MatrixCase
from torquerig.decide.cell import Cell, Origin, Override
from torquerig.decide.criterion import YES_NO, Better, Criterion, Indifference, Kind, Requirement, ValueFunction
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.matrix_file import matrix_from, read_matrix
from torquerig.decide.matrix_io.matrix_table import Alias
from torquerig.decide.matrix_io.matrix_writing import matrix_yaml
from torquerig.decide.monte_carlo import Uncertainty
from torquerig.document import parse_document

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "matrix_example.yaml"
CRITERIA = (
    Criterion(name="servo", unit=YES_NO, requirement=Requirement(low=1.0, in_question="who says so")),
    Criterion(
        name="band", unit="kg*cm^2", better=Better.BAND, band=(1.0, 2.0), indifference=Indifference(relative=0.1)
    ),
    Criterion(
        name="price: net", unit="EUR", better=Better.LESS, weight=0.3, kind=Kind.ECONOMIC, purpose="no, yes & 1e3",
        value=ValueFunction(((1.0, 5.0), (3.0, 1.0))),
    ),
)  # fmt: skip
numbers = st.floats(-1e6, 1e6, allow_nan=False).map(lambda value: value + 0.0)
texts = st.sampled_from(["", "Table VII", "no", "a: b # c", "12"])
numeric = st.builds(
    lambda low, width, source, reason, hand: Cell(
        low=low, high=low + width, source=source, unknown_reason=reason, fact=reason,
        by_hand=Override(points=2.0, reason="known from use") if hand else None,
        origins=(Origin(name="x", shown="? (1..2 N*m)", evidence="RT", source=source),) if hand else (),
    ),
    st.floats(0, 100), st.floats(0, 10), texts, texts, st.booleans(),
)  # fmt: skip
cells = st.one_of(st.just(Cell()), numbers.map(lambda value: Cell(value=value)), numeric)
answers = st.one_of(st.just(Cell()), st.booleans().map(lambda yes: Cell(value=float(yes), text="yes" if yes else "no")))


def read_again(case):
    return matrix_from(parse_document(matrix_yaml(case), FILE))


@settings(max_examples=40, deadline=None)
@given(answers, cells, cells)
def test_any_cell_survives(servo, band, price):
    matrix = DecisionMatrix(
        name="a: b",
        alternatives=("1e3", "no"),
        criteria=CRITERIA,
        cells={("1e3", "servo"): servo, ("1e3", "band"): band, ("no", "price: net"): price},
    )
    case = MatrixCase(
        matrix=matrix, baseline="no", goal="ripple", goal_words=("rip",),
        uncertainty=Uncertainty(scores=1.0, weights=0.0),
        seed=3, draws=7, cost=Cost(criterion="price: net", permissible=2.0), history=("first", "then"),
        aliases=(Alias(names=("no", "yes"), reason="by suffix"),),
    )  # fmt: skip
    again = read_again(case)
    for alternative in matrix.alternatives:
        for one in CRITERIA:
            mine, other = matrix.cell(alternative, one.name), again.matrix.cell(alternative, one.name)
            assert mine == other
    assert again.matrix.criteria == matrix.criteria
    assert (again.baseline, again.goal, again.goal_words, again.uncertainty) == (
        case.baseline,
        case.goal,
        case.goal_words,
        case.uncertainty,
    )
    assert (again.seed, again.draws, again.cost, again.history) == (3, 7, case.cost, case.history)
    assert again.aliases[0].names == ("no", "yes")


@pytest.mark.parametrize("path", [FILE])
def test_the_shipped_example_survives(path):
    case = read_matrix(path)
    again = read_again(case)
    assert (again.matrix.criteria, again.profile, again.seed) == (case.matrix.criteria, case.profile, case.seed)
    for name in case.matrix.alternatives:
        for one in case.matrix.criteria:
            assert again.matrix.cell(name, one.name) == case.matrix.cell(name, one.name)
