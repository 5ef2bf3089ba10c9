"""The same matrices given to other programs: equal where they compute the same thing, and what one missing cell does.

scikit-criteria and pymcdm come with ``pip install --group benchmark``; pySensMCDA with
``pip install --no-deps pysensmcda npy-append-array``, because it pins older libraries than are needed here.
"""

import subprocess
import sys
import warnings

import numpy as np
import pytest

from torquerig.decide.kesselring import kesselring
from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, ValueFunction
from torquerig.decide.monte_carlo import Uncertainty
from torquerig.decide.pugh import sweep_baselines
from torquerig.decide.robustness import rank_acceptability
from torquerig.decide.value_of_information import missing_facts

IDENTITY = ValueFunction(((1.0, 1.0), (5.0, 5.0)))
POINTS = np.random.default_rng(7).uniform(1.5, 4.5, (15, 6))
WEIGHTS = np.array([0.3, 0.2, 0.2, 0.15, 0.1, 0.05])
MERIT = np.ones(6)
DRAWS = 4000


def matrix_of(points, *, half_width=0.0, missing=()):
    criteria = tuple(Criterion(name=f"c{at}", value=IDENTITY, weight=float(one)) for at, one in enumerate(WEIGHTS))
    names = tuple(f"m{place}" for place in range(len(points)))
    cells = {}
    for row, name in enumerate(names):
        for column, one in enumerate(criteria):
            value = float(points[row, column])
            known = Cell(low=value - half_width, high=value + half_width) if half_width else Cell(value=value)
            cells[name, one.name] = Cell() if (row, column) in missing else known
    return DecisionMatrix(alternatives=names, criteria=criteria, cells=cells)


def imported(name, remedy):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip(name, reason=f"{name} is not installed; {remedy}", exc_type=ImportError)


def as_given(column, cost=False):
    return column


def pymcdm_totals(points):
    methods = imported("pymcdm.methods", "pip install pymcdm")
    return np.asarray(methods.WSM(normalization_function=as_given)(points, WEIGHTS, MERIT))


def skcriteria_result(points):
    skcriteria = imported("skcriteria", "pip install scikit-criteria")
    simple = imported("skcriteria.agg.simple", "pip install scikit-criteria")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return simple.WeightedSumModel().evaluate(skcriteria.mkdm(points, [max] * 6, weights=WEIGHTS))


def test_pymcdm_gives_the_same_weighted_sums():
    assert pymcdm_totals(POINTS) == pytest.approx(kesselring(matrix_of(POINTS)).total)


def test_scikit_criteria_gives_the_same_ranks():
    result = skcriteria_result(POINTS)
    assert np.asarray(result.rank_).tolist() == kesselring(matrix_of(POINTS)).ranks.tolist()


def pysensmcda_acceptability(points, *, half_width, spread):
    smaa = imported("pysensmcda.smaa", "pip install --no-deps pysensmcda npy-append-array")
    methods = imported("pymcdm.methods", "pip install pymcdm")
    rng = np.random.default_rng(5)
    matrices = points + rng.uniform(-half_width, half_width, (DRAWS, *points.shape))
    weights = WEIGHTS * rng.uniform(1 - spread, 1 + spread, (DRAWS, 6))
    weights /= weights.sum(axis=1, keepdims=True)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        done = smaa.simulate(
            methods.WSM(normalization_function=as_given), points, MERIT, weights=weights, matrix_samples=matrices
        )
        return np.asarray(done.rank_acceptability())


def test_pysensmcda_gives_the_same_rank_acceptability():
    theirs = pysensmcda_acceptability(POINTS, half_width=0.4, spread=0.25)
    ours = rank_acceptability(
        matrix_of(POINTS, half_width=0.4), uncertainty=Uncertainty(scores=0.0, weights=0.25), draws=200_000, seed=1
    ).shares
    error = np.sqrt(ours * (1 - ours) * (1 / DRAWS + 1 / 200_000))
    assert np.abs(theirs - ours).max() < 0.05
    assert (np.abs(theirs - ours) <= 5 * error + 2 / DRAWS).all()  # five sigma of both draws, and a count of two


def test_plain_draws_in_numpy_give_the_same_rank_acceptability():
    rng, draws = np.random.default_rng(9), 40_000
    totals = (POINTS + rng.uniform(-0.4, 0.4, (draws, *POINTS.shape))) * (
        WEIGHTS * rng.uniform(0.75, 1.25, (draws, 1, 6))
    )
    ranks = (-totals.sum(axis=2)).argsort(axis=1).argsort(axis=1)
    plain = np.array([np.bincount(column, minlength=15) for column in ranks.T]) / draws
    ours = rank_acceptability(
        matrix_of(POINTS, half_width=0.4), uncertainty=Uncertainty(scores=0.0, weights=0.25), draws=draws, seed=2
    ).shares
    error = np.sqrt(2 * ours * (1 - ours) / draws)
    assert (np.abs(plain - ours) <= 5 * error + 2 / draws).all()


def test_one_missing_cell_opens_one_row_and_changes_no_other():
    whole, holed = kesselring(matrix_of(POINTS)), kesselring(matrix_of(POINTS, missing=[(3, 0)]))
    others = np.delete(np.arange(15), 3)
    assert (holed.total[others] == whole.total[others]).all()
    assert holed.total_high[3] - holed.total_low[3] == pytest.approx(0.3 * 4)
    assert holed.total_low[3] <= whole.total[3] <= holed.total_high[3]
    found = rank_acceptability(matrix_of(POINTS, missing=[(3, 0)]), draws=2000)
    assert found.shares.sum() == pytest.approx(15)
    assert found.mean_share.min() > 0
    assert sweep_baselines(matrix_of(POINTS, missing=[(3, 0)])).beats.any()
    assert [fact.fact for fact in missing_facts(matrix_of(POINTS, missing=[(3, 0)]))] == ["c0 of m3"]


@pytest.mark.parametrize("share", [0.1, 0.5, 1.0])
def test_however_many_cells_are_missing_every_result_is_finite(share):
    rng = np.random.default_rng(3)
    holes = [(row, column) for row in range(15) for column in range(6) if rng.random() < share]
    matrix = matrix_of(POINTS, missing=holes)
    result, found = kesselring(matrix), rank_acceptability(matrix, draws=500)
    for numbers in (result.total, result.total_low, result.total_high, found.shares, found.mean_share):
        assert np.isfinite(numbers).all()
    assert result.total_low.min() > 0


def outcome(program, points, **settings):
    """What a program gives for a matrix; None where it refuses."""
    try:
        return program(points, **settings)
    except (ValueError, TypeError):
        return None


def with_a_hole():
    holed = POINTS.copy()
    holed[3, 0] = np.nan
    return holed


def test_the_same_missing_cell_costs_pymcdm_that_row_and_with_its_own_scaling_all_rows():
    totals = outcome(pymcdm_totals, with_a_hole())
    assert totals is None or np.isnan(totals[3])
    methods = imported("pymcdm.methods", "pip install pymcdm")
    scaled = outcome(methods.WSM(), with_a_hole(), weights=WEIGHTS, types=MERIT)
    assert scaled is None or np.isnan(scaled).any()


def test_the_same_missing_cell_stops_scikit_criteria():
    assert skcriteria_result(POINTS) is not None
    result = outcome(skcriteria_result, with_a_hole())
    assert result is None or np.isnan(np.asarray(result.e_.score, dtype=float)).any()


APART = """
import sys, warnings
warnings.simplefilter("ignore")
import numpy as np
from pymcdm.methods import WSM
from pysensmcda.smaa import simulate
points = np.random.default_rng(7).uniform(1.5, 4.5, (15, 6))
points[3, 0] = float(sys.argv[1])
method = WSM(normalization_function=lambda column, cost=False: column)
matrices = points + np.random.default_rng(5).uniform(-0.4, 0.4, (1000, 15, 6))
done = simulate(method, points, np.ones(6), weights=np.full((1000, 6), 1 / 6), matrix_samples=matrices)
print("in all", done.rank_acceptability().sum(), flush=True)
"""


def test_the_same_missing_cell_zeroes_the_whole_acceptability_of_pysensmcda():
    # in a process of its own: with not-a-number it may write outside of its arrays and bring the program down
    imported("pysensmcda.smaa", "pip install --no-deps pysensmcda npy-append-array")
    imported("pymcdm.methods", "pip install pymcdm")
    told = {
        cell: subprocess.run([sys.executable, "-c", APART, cell], capture_output=True, text=True, check=False).stdout
        for cell in ("3.0", "nan")
    }
    assert told["3.0"].split() == ["in", "all", "15.0"]
    assert told["nan"].split() != ["in", "all", "15.0"]
    ours = rank_acceptability(matrix_of(POINTS, half_width=0.4, missing=[(3, 0)]), draws=DRAWS).shares
    assert ours.sum(axis=1) == pytest.approx(np.ones(15))
