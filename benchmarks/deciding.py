"""Joint draws of a 15 x 6 matrix with full rank acceptability, beside other programs in the same run.

Limits: 10 000 draws in 5 ms, a million in 0.5 s, both readings of 15 x 6. Run: python benchmarks/deciding.py
Beside it, where installed: pymcdm and scikit-criteria (pip install --group benchmark) and pySensMCDA
(pip install --no-deps pysensmcda npy-append-array, because it pins older libraries).
"""

import statistics
import time
import warnings
from collections.abc import Callable

import numpy as np

from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix, ValueFunction
from torquerig.decide.monte_carlo import Uncertainty
from torquerig.decide.robustness import rank_acceptability

FEW, MANY, TURNS = 10_000, 1_000_000, 15
HALF_WIDTH, SPREAD = 0.4, 0.25
warnings.simplefilter("ignore")


def matrix(rows: int, columns: int) -> tuple[np.ndarray, np.ndarray, DecisionMatrix]:
    """Random points with intervals; value functions with two knots inside the scale."""
    points = np.random.default_rng(7).uniform(1.5, 4.5, (rows, columns))
    weights = np.linspace(2, 1, columns) / np.linspace(2, 1, columns).sum()
    value = ValueFunction(((1.0, 1.0), (2.0, 2.0), (3.0, 3.0), (5.0, 5.0)))
    criteria = tuple(Criterion(name=f"c{at}", value=value, weight=float(one)) for at, one in enumerate(weights))
    names = tuple(f"m{place}" for place in range(rows))
    cells = {
        (name, one.name): Cell(low=points[row, at] - HALF_WIDTH, high=points[row, at] + HALF_WIDTH)
        for row, name in enumerate(names)
        for at, one in enumerate(criteria)
    }
    return points, weights, DecisionMatrix(alternatives=names, criteria=criteria, cells=cells)


def samples(points: np.ndarray, weights: np.ndarray, draws: int) -> tuple[np.ndarray, np.ndarray]:
    """Drawn matrices and weights, as a user of the other programs has to make them."""
    rng = np.random.default_rng(1)
    drawn = weights * rng.uniform(1 - SPREAD, 1 + SPREAD, (draws, weights.size))
    return points + rng.uniform(-HALF_WIDTH, HALF_WIDTH, (draws, *points.shape)), drawn / drawn.sum(axis=1)[:, None]


def plain_numpy(points: np.ndarray, weights: np.ndarray, draws: int) -> np.ndarray:
    """Rank acceptability in a dozen lines of numpy."""
    matrices, drawn = samples(points, weights, draws)
    ranks = (-(matrices * drawn[:, None]).sum(axis=2)).argsort(axis=1).argsort(axis=1)
    return np.array([np.bincount(column, minlength=len(points)) for column in ranks.T]) / draws


def by_pymcdm(points: np.ndarray, weights: np.ndarray, draws: int) -> np.ndarray:
    """One call of its weighted sum per draw."""
    from pymcdm.methods import WSM

    method, counts = WSM(normalization_function=lambda column, cost=False: column), np.zeros((len(points),) * 2)
    for one, weight in zip(*samples(points, weights, draws), strict=True):
        ranks = (-method(one, weight, np.ones(weights.size), validation=False)).argsort().argsort()
        counts[np.arange(len(points)), ranks] += 1
    return counts / draws


def by_scikit_criteria(points: np.ndarray, weights: np.ndarray, draws: int) -> np.ndarray:
    """One decision matrix and one evaluation per draw."""
    import skcriteria
    from skcriteria.agg.simple import WeightedSumModel

    method, counts = WeightedSumModel(), np.zeros((len(points),) * 2)
    for one, weight in zip(*samples(points, weights, draws), strict=True):
        result = method.evaluate(skcriteria.mkdm(one, [max] * weights.size, weights=weight))
        counts[np.arange(len(points)), np.asarray(result.rank_, dtype=int) - 1] += 1
    return counts / draws


def by_pysensmcda(points: np.ndarray, weights: np.ndarray, draws: int) -> np.ndarray:
    """Its simulation over given samples, with the weighted sum of pymcdm."""
    from pymcdm.methods import WSM
    from pysensmcda.smaa import simulate

    matrices, drawn = samples(points, weights, draws)
    method = WSM(normalization_function=lambda column, cost=False: column)
    done = simulate(method, points, np.ones(weights.size), weights=drawn, matrix_samples=matrices)
    return np.asarray(done.rank_acceptability())


def seconds(call: Callable[[], object], turns: int) -> tuple[float, float]:
    """Best and median of several turns."""
    taken = []
    for _ in range(turns):
        start = time.perf_counter()
        call()
        taken.append(time.perf_counter() - start)
    return min(taken), statistics.median(taken)


for rows, columns in ((15, 6), (6, 15)):
    points, weights, made = matrix(rows, columns)
    print(f"{rows} alternatives x {columns} criteria, best and median of {TURNS}")
    doubts = {
        "intervals and weights": Uncertainty(scores=0.0, weights=SPREAD),
        "and points too": Uncertainty(weights=SPREAD),
    }
    rank_acceptability(made, draws=100)
    for words, doubt in doubts.items():
        for draws, limit in ((FEW, 5e-3), (MANY, 0.5)):
            best, median = seconds(
                lambda m=made, d=draws, u=doubt: rank_acceptability(m, draws=d, uncertainty=u), TURNS
            )
            print(f"  torquerig, {words}, {draws} draws: {1e3 * best:.2f} ms, {1e3 * median:.2f} ms "
                  f"(limit {1e3 * limit:.0f} ms)")  # fmt: skip
    ours = rank_acceptability(made, draws=MANY, uncertainty=doubts["intervals and weights"]).shares
    peers = {
        "numpy, plain": (plain_numpy, FEW, 5), "pySensMCDA": (by_pysensmcda, FEW, 3), "pymcdm": (by_pymcdm, FEW, 3),
        "scikit-criteria": (by_scikit_criteria, 200, 1),
    }  # fmt: skip
    for name, (run, draws, turns) in peers.items():
        try:
            found = run(points, weights, draws)
            best, median = seconds(lambda r=run, p=points, w=weights, d=draws: r(p, w, d), turns)
        except ImportError as missing:
            print(f"  {name}: not installed ({missing})")
            continue
        error = float(np.abs(found - ours).max() / (0.5 / np.sqrt(draws)))
        print(f"  {name}, {draws} draws: {1e3 * best:.1f} ms, so {1e3 * best * FEW / draws:.0f} ms per {FEW}; "
              f"farthest from ours by {error:.1f} standard errors")  # fmt: skip
