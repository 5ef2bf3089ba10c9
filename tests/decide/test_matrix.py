"""What is known: cells, and pairs without one."""

import numpy as np
import pytest

from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix
from torquerig.errors import InputError, UnknownNameError
from torquerig.parameter import Estimate

CRITERIA = (Criterion(name="price", unit="EUR"), Criterion(name="torque", unit="N*m"))


def test_a_missing_cell_is_unknown_and_not_zero():
    matrix = DecisionMatrix(alternatives=("a",), criteria=CRITERIA, cells={("a", "price"): Cell(value=0.0)})
    assert matrix.cell("a", "torque").unknown
    low, high = matrix.bounds
    assert low[0, 0] == high[0, 0] == 0.0
    assert np.isnan(low[0, 1])
    assert np.isnan(high[0, 1])


def test_a_documented_estimate_is_a_number_and_a_guess_an_interval():
    documented = Estimate(value=0.32, evidence="DOC", source="Table VII", unit="N*m")
    guess = Estimate(low=2e-5, high=4e-5, evidence="RT", source="rule", unit="kg*m^2")
    assert Cell.from_estimate(documented, "N*cm").bounds == pytest.approx((32, 32))
    assert Cell.from_estimate(documented, "N*m").source == "Table VII"
    cell = Cell.from_estimate(guess, "kg*cm^2")
    assert cell.value is None
    assert cell.bounds == pytest.approx((0.2, 0.4))
    assert Cell.from_estimate(Estimate(note="ask the maker"), "N*m").unknown_reason == "ask the maker"


def test_shown_keeps_the_unknown_unknown():
    shown = [Cell(), Cell(value=1.27), Cell(low=0.3, high=0.5), Cell(value=0.4, low=0.3, high=0.5), Cell(text="yes")]
    assert [cell.shown() for cell in shown] == ["?", "1.27", "0.3..0.5", "0.4 (0.3..0.5)", "yes"]


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Cell(value=float("nan")), r"write \?"),
        (lambda: Cell(low=1.0), "both low and high"),
        (lambda: Cell(low=2.0, high=1.0), "upwards"),
        (lambda: Cell(value=3.0, low=1.0, high=2.0), "contain"),
        (lambda: DecisionMatrix(alternatives=("a", "a"), criteria=CRITERIA), "occurs twice"),
        (lambda: DecisionMatrix(alternatives=("a",), criteria=CRITERIA * 2), "occurs twice"),
        (lambda: DecisionMatrix(alternatives=(), criteria=CRITERIA), "at least one"),
    ],
)
def test_what_cannot_be_is_refused_in_words(make, said):
    with pytest.raises(InputError, match=said):
        make()


@pytest.mark.parametrize("pair", [("motr", "price"), ("motor", "prise")])
def test_a_cell_for_an_unknown_name_offers_the_close_one(pair):
    with pytest.raises(UnknownNameError, match=r"did you mean '(motor|price)'"):
        DecisionMatrix(alternatives=("motor",), criteria=CRITERIA, cells={pair: Cell(value=1.0)})
