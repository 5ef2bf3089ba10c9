"""Signs against a baseline: what must hold for any matrix."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from torquerig.decide.matrix import Better, Cell, Criterion, DecisionMatrix, Indifference
from torquerig.decide.pugh import Sign, pugh, pugh_from_signs, sweep_baselines
from torquerig.errors import InputError, UnknownNameError

CRITERIA = (
    Criterion(name="speed"),
    Criterion(name="price", better=Better.LESS, indifference=Indifference(relative=0.1)),
    Criterion(name="inertia", better=Better.BAND, band=(2.0, 4.0), indifference=Indifference(absolute=0.5)),
)

cells = st.one_of(
    st.just(Cell()),
    st.integers(0, 9).map(lambda value: Cell(value=float(value))),
    st.tuples(st.integers(0, 9), st.integers(0, 4)).map(lambda ends: Cell(low=ends[0], high=ends[0] + ends[1])),
)


@st.composite
def matrices(draw):
    names = tuple("abcd"[: draw(st.integers(2, 4))])
    pairs = [(name, criterion.name) for name in names for criterion in CRITERIA]
    return DecisionMatrix(alternatives=names, criteria=CRITERIA, cells={pair: draw(cells) for pair in pairs})


def signs_of(criterion, ours, baseline):
    pair = {("a", criterion.name): ours, ("d", criterion.name): baseline}
    matrix = DecisionMatrix(alternatives=("a", "d"), criteria=(criterion,), cells=pair)
    return pugh(matrix, "d").signs("a")[0]


@pytest.mark.parametrize(
    ("column", "ours", "baseline", "sign"),
    [
        (0, Cell(value=2.0), Cell(value=1.0), Sign.BETTER),
        (1, Cell(value=2.0), Cell(value=1.0), Sign.WORSE),
        (1, Cell(value=95.0), Cell(value=100.0), Sign.SAME),
        (1, Cell(value=89.0), Cell(value=100.0), Sign.BETTER),
        (2, Cell(value=3.0), Cell(value=9.0), Sign.BETTER),
        (2, Cell(value=1.6), Cell(value=4.4), Sign.SAME),
        (0, Cell(low=2.0, high=3.0), Cell(low=0.0, high=1.0), Sign.BETTER),
        (0, Cell(low=1.0, high=3.0), Cell(value=2.0), Sign.UNKNOWN),
        (2, Cell(low=2.0, high=4.0), Cell(value=3.0), Sign.SAME),
        (0, Cell(), Cell(value=2.0), Sign.UNKNOWN),
    ],
)
def test_a_sign_is_given_only_where_it_is_certain(column, ours, baseline, sign):
    assert signs_of(CRITERIA[column], ours, baseline) is sign


@given(matrices())
def test_the_baseline_column_is_all_same_even_where_its_cells_are_unknown(matrix):
    for baseline in matrix.alternatives:
        result = pugh(matrix, baseline)
        assert set(result.signs(baseline)) == {Sign.SAME}
        assert result.counts(baseline)[Sign.SAME] == len(CRITERIA)


@given(matrices())
def test_to_beat_is_to_make_the_other_lose(matrix):
    sweep = sweep_baselines(matrix)
    assert (sweep.low == -sweep.high.transpose(1, 0, 2)).all()
    assert not (sweep.beats & sweep.beats.T).any()


@given(matrices(), st.integers(0, 2**31))
def test_no_draw_from_the_cells_leaves_the_net_interval(matrix, seed):
    rng = np.random.default_rng(seed)
    low, high = matrix.bounds
    values = np.where(
        np.isnan(low), rng.uniform(0, 20, low.shape), rng.uniform(np.nan_to_num(low), np.nan_to_num(high))
    )
    drawn = {
        (name, criterion.name): Cell(value=float(values[row, column]))
        for row, name in enumerate(matrix.alternatives)
        for column, criterion in enumerate(CRITERIA)
    }
    before = pugh(matrix, "a")
    after = pugh(DecisionMatrix(alternatives=matrix.alternatives, criteria=CRITERIA, cells=drawn), "a")
    assert (before.net_low <= after.net_low).all()
    assert (after.net_low <= before.net_high).all()


@given(matrices())
def test_the_sweep_holds_every_single_run(matrix):
    sweep = sweep_baselines(matrix)
    for baseline in matrix.alternatives:
        single, swept = pugh(matrix, baseline), sweep.against(baseline)
        assert (single.low == swept.low).all()
        assert (single.high == swept.high).all()


def test_a_big_sweep_counts_what_a_loop_counts():
    rng = np.random.default_rng(3)
    values = rng.integers(0, 5, (150, 8)).astype(float)
    criteria = tuple(Criterion(name=str(column)) for column in range(8))
    names = tuple(f"m{row}" for row in range(150))
    filled = {(names[row], str(column)): Cell(value=values[row, column]) for row in range(150) for column in range(8)}
    sweep = sweep_baselines(DecisionMatrix(alternatives=names, criteria=criteria, cells=filled))
    for ours, baseline in rng.integers(0, 150, (50, 2)).tolist():
        assert sweep.wins[ours, baseline] == sum(values[ours] > values[baseline])


def test_the_condorcet_winner_beats_all_and_a_cycle_has_none():
    criteria = tuple(Criterion(name=name) for name in "xyz")
    rows = {"a": (3, 2, 1), "b": (2, 1, 3), "c": (1, 3, 2)}

    def winner(table):
        filled = {
            (name, criterion.name): Cell(value=float(value))
            for name, given in table.items()
            for criterion, value in zip(criteria, given, strict=True)
        }
        return sweep_baselines(
            DecisionMatrix(alternatives=tuple(table), criteria=criteria, cells=filled)
        ).condorcet_winner

    assert winner(rows) is None
    assert winner({**rows, "d": (4, 4, 4)}) == "d"


def test_given_signs_are_added_up_with_the_unknown_as_an_interval():
    result = pugh_from_signs({"a": [Sign.BETTER, Sign.UNKNOWN, Sign.SAME]}, baseline="ref", criteria=["x", "y", "z"])
    assert result.alternatives == ("ref", "a")
    assert (result.net_low[1], result.net_certain[1], result.net_high[1]) == (0, 1, 2)


def test_a_baseline_that_is_not_there_and_a_short_row_are_refused():
    matrix = DecisionMatrix(alternatives=("motor",), criteria=CRITERIA)
    with pytest.raises(UnknownNameError, match="did you mean 'motor'"):
        pugh(matrix, "motr")
    with pytest.raises(InputError, match="2 signs for 1"):
        pugh_from_signs({"a": [Sign.SAME, Sign.SAME]}, baseline="ref", criteria=["x"])
    with pytest.raises(InputError, match="S against itself"):
        pugh_from_signs({"ref": [Sign.BETTER]}, baseline="ref", criteria=["x"])
