"""Share of Monte Carlo samples in which each alternative is best, for many subsets of the alternatives of one matrix.

The samples are those of :mod:`torquerig.decide.robustness`, from the same random streams, but their totals stay. So
another subset costs no further samples. Only the first rank is counted, by arrays: no compiled kernel is loaded.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.monte_carlo import SamplingPlan, Uncertainty, sampling_plan, separate_uncertainties
from torquerig.decide.ranks import TIE
from torquerig.decide.robustness import RankAcceptability

if TYPE_CHECKING:
    from torquerig.decide.matrix import DecisionMatrix

Array = NDArray[np.float64]
DRAWS = 10_000
_GOLDEN = np.uint64(0x9E3779B97F4A7C15)  # of SplitMix64, as in the kernel
_ROUNDS = (
    (np.uint64(30), np.uint64(0xBF58476D1CE4E5B9)),
    (np.uint64(27), np.uint64(0x94D049BB133111EB)),
)
_ONE, _LOW = np.uint64(0x3FF0000000000000), np.uint64(0xFFFFFFFF)


@dataclass(frozen=True)
class SampledTotals:
    """T of each alternative in each sample, by what is sampled.

    Parameters
    ----------
    alternatives : tuple of str
    uncertainties : mapping of str to Uncertainty
        ``intervals``, ``scores``, ``weights``, ``together``.
    totals : mapping of str to ndarray, shape (alternatives, samples)
    whole : mapping of str to ndarray, shape (samples,)
        Sums of the weights.
    seed : int
    largest : float
        Most points of the scale.
    """

    alternatives: tuple[str, ...]
    uncertainties: Mapping[str, Uncertainty]
    totals: Mapping[str, Array]
    whole: Mapping[str, Array]
    seed: int
    largest: float

    def best(self, names: Sequence[str]) -> dict[str, RankAcceptability]:
        """Return the acceptability of these alternatives among each other, of the first rank alone."""
        places = {name: row for row, name in enumerate(self.alternatives)}
        rows = [places[name] for name in names]
        whole, found = rows == list(range(len(places))), {}
        for what, totals in self.totals.items():
            chosen = totals if whole else totals[rows]
            found[what] = RankAcceptability(
                alternatives=tuple(names), shares=_first(chosen)[:, None], mean_share=self._mean_shares[what][rows],
                uncertainty=self.uncertainties[what], draws=totals.shape[1], seed=self.seed,
            )  # fmt: skip
        return found

    @cached_property
    def _mean_shares(self) -> dict[str, Array]:
        """Mean T/T_max of each alternative, by what is sampled."""
        return {what: (totals / self.whole[what]).mean(axis=1) / self.largest for what, totals in self.totals.items()}


def sampled_totals(
    matrix: DecisionMatrix, *, profile: Profile = TEACHING, uncertainty: Uncertainty | None = None, draws: int = DRAWS,
    seed: int = 0,
) -> SampledTotals:  # fmt: skip
    """Return samples of the totals of a matrix for ``intervals``, ``scores``, ``weights`` alone, and ``together``."""
    separate = separate_uncertainties(Uncertainty() if uncertainty is None else uncertainty)
    whole_plans = {
        one: sampling_plan(matrix, profile=profile, uncertainty=Uncertainty(values=one), seed=seed)
        for one in dict.fromkeys(each.values for each in separate.values())
    }
    plans = {name: whole_plans[one.values].with_errors(one) for name, one in separate.items()}
    steps = _GOLDEN * np.arange(draws, dtype=np.uint64)
    weights = {name: _weights(plan, steps) for name, plan in plans.items()}
    totals = {name: np.zeros((len(matrix.alternatives), draws)) for name in plans}
    first = next(iter(plans.values()))
    for column in range(len(first.weights[0])):
        for row in range(len(matrix.alternatives)):
            for name, points in _points(plans, row, column, steps).items():
                totals[name][row] += weights[name][column] * points
    whole = {name: np.sum(np.broadcast_arrays(*each, np.zeros(draws)), axis=0) for name, each in weights.items()}
    return SampledTotals(matrix.alternatives, separate, totals, whole, seed, float(first.scale[1]))


def _weights(plan: SamplingPlan, steps: NDArray[np.uint64]) -> list[Array | float]:
    """Return the weight of each criterion: one number, or one for each sample."""
    given, keys, half_widths = plan.weights
    return [
        weight * (1.0 + half * (2.0 * _uniforms(key, steps)[0] - 3.0)) if half > 0 else float(weight)
        for weight, key, half in zip(given, keys, half_widths, strict=True)
    ]


def _points(
    plans: Mapping[str, SamplingPlan], row: int, column: int, steps: NDArray[np.uint64]
) -> dict[str, Array | float]:
    """Return the points of one cell: one number, or one for each sample."""
    found: dict[str, Array | float] = {}
    drawn: tuple[Array, Array] | None = None
    for name, plan in plans.items():
        keys, start, width, logarithmic, base, slope, knots, turns, bends, half_widths = (
            part[row, column] for part in plan.cells
        )
        points: Array | float = float(base)
        if width > 0 or half_widths > 0:
            drawn = drawn or _uniforms(keys, steps)
            if width > 0:
                value = start + width * (drawn[0] - 1.0)
                value = np.exp(value) if logarithmic else value
                points = slope * value
                points += base
                for bend in range(bends):
                    points = points + turns[bend] * np.maximum(value - knots[bend], 0.0)
            if half_widths > 0:
                error = 2.0 * drawn[1]
                error -= 3.0
                error *= half_widths
                error += points
                points = np.minimum(np.maximum(error, plan.scale[0], out=error), plan.scale[1], out=error)
        found[name] = points
    return found


def _uniforms(key: np.uint64, steps: NDArray[np.uint64]) -> tuple[Array, Array]:
    """Return two uniforms in 1..2 for each sample, from 32 bits of the hash each."""
    number = steps + key
    for shift, factor in _ROUNDS:
        number ^= number >> shift
        number *= factor
    number ^= number >> np.uint64(31)
    upper = number >> np.uint64(32)
    number &= _LOW
    return _as_doubles(upper), _as_doubles(number)


def _as_doubles(bits: NDArray[np.uint64]) -> Array:
    """Return 32 bits each as the first of the fraction of a number in 1..2; ``bits`` is used up."""
    bits <<= np.uint64(20)
    bits |= _ONE
    return bits.view(np.float64)


def _first(totals: Array) -> Array:
    """Return the share of samples in which each row is first; rows that tie share it equally."""
    leads = totals >= totals.max(axis=0) - TIE
    if np.count_nonzero(leads) == totals.shape[1]:  # one in each sample
        return np.array([np.count_nonzero(row) / totals.shape[1] for row in leads])
    several = leads.sum(axis=0) > 1
    counts = leads[:, ~several].sum(axis=1).astype(float)
    if several.any():
        tied, values = leads[:, several], totals[:, several]
        for row in np.flatnonzero(tied.any(axis=1)):
            at = tied[row]
            same = (np.abs(values[:, at] - values[row, at]) <= TIE).sum(axis=0)
            counts[row] += (1.0 / same).sum()
    return np.asarray(counts / totals.shape[1])
