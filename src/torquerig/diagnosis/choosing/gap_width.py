"""How wide a gap is: by how flanks fly across it, or by how long and how often the torque stays near zero.

The latter where an amplifier is too slow for blows, or the shafts ring through the flights.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import exp
from operator import attrgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.opened_gap import ARCMIN, flanks_fly, flanks_may_part, opened
from torquerig.diagnosis.expecting.simulated import simulated_runs
from torquerig.diagnosis.fitting.misfit import robust_squares
from torquerig.diagnosis.looking.as_well_known import as_well_known
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flight_statistics import flight_misfit, flight_statistics, longest_flight
from torquerig.diagnosis.looking.from_zero import without_drift
from torquerig.diagnosis.looking.near_zero import near_zero_misfit, near_zero_stays
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.parallel import parallel_map
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_GAPS = np.geomspace(1.5, 45.0, 6) * ARCMIN  # [rad]
_BEYOND, _SHORT = 0.15, 0.3  # [1] of the logarithm: wider than the longest flight, narrower than where it was measured
_FINE = np.geomspace(_GAPS[0], _GAPS[-1], 121)
_LEAST_GAIN = 20.0  # by which flights or stays near zero torque must speak for a gap
_AGAINST = 10.0  # by which stays must speak against any, where nothing but chatter speaks for one
_AT_A_TIME = 0.75  # turns a run in which the gaps are simulated: sixteen recordings are held, two full batches
_SEEDS = (1, 2)
_ALIKE = 4.0  # of the misfit: 95 % of one number
_CONTACT = 0.55  # of the logarithm: how flanks meet changes how they fly, and no model knows it (29 blind rigs)


@dataclass(frozen=True)
class Width:
    """A gap [rad] with its 95 % interval, and the misfit of what told it, closed and open."""

    gap: float
    within: tuple[float, float]
    closed: float
    opened: float


def width(shown: WithGaps) -> Width | None:
    """Return the gap that comes nearest to the recordings, or None where neither flights nor stays tell any."""
    if not shown.rigs:
        return None
    told = _told_by(shown, flying=True) if flanks_fly(shown.case) else None
    return _told_by(shown, flying=False) if told is None else told


def stays_speak_against(shown: WithGaps) -> bool:
    """Whether the torque stays near zero as it does without a gap, and with one of any width would clearly not."""
    if not shown.rigs:
        return False
    missed = _Missed(shown, flying=False)
    return float(missed.opened.min()) > missed.closed + _AGAINST


class _Statistics(NamedTuple):
    """Of one run, or the mean of its simulations."""

    flights: Floats
    stays: Floats


class WithGaps:
    """What the runs in which flanks may part show of flights and of stays near zero, and their simulations with gaps.

    Each gap is simulated once, whichever of both is asked first.

    Parameters
    ----------
    case : Case
    rigs : sequence of Rig
        The model without a gap as it is simulated for each of the case's runs.
    """

    def __init__(self, case: Case, rigs: Sequence[Rig]) -> None:
        self.case = case
        parting = [row for row, features in enumerate(case.from_zero) if flanks_may_part(features)]
        self.seen = [case.from_zero[row] for row in parting]
        self.rigs = [without_drift(rigs[row]) for row in parting]
        self.told = [self._statistics(features.untoned) for features in self.seen]
        self._turns = max(1, round(_AT_A_TIME * len(parting)))

    @cached_property
    def closed(self) -> list[_Statistics]:
        """Of each run without a gap."""
        return self._simulated([0.0])[0]

    @cached_property
    def opened(self) -> list[list[_Statistics]]:
        """Of each run with each of ``_GAPS``: one list a gap."""
        return [each for some in np.array_split(_GAPS, self._turns) for each in self._simulated(some.tolist())]

    def _simulated(self, gaps: Sequence[float]) -> list[list[_Statistics]]:
        each = [opened(self.case, gap).added_to(rig) if gap else rig for gap in gaps for rig in self.rigs]
        runs = self.seen * len(gaps)
        copies = simulated_runs(each, runs, seeds=_SEEDS)
        means = parallel_map(lambda pair: self._mean_of(*pair), list(zip(runs, copies, strict=True)))
        return [means[at : at + len(self.rigs)] for at in range(0, len(means), len(self.rigs))]

    def _mean_of(self, seen: Features, copies: Sequence[Observed]) -> _Statistics:
        """Return the means over the simulations of a run, their angles known as well as the run's."""
        known = [as_well_known(without_tones(copy, seen.places), seen.observed) for copy in copies]
        each = zip(*map(self._statistics, known), strict=True)
        return _Statistics(*(np.asarray(np.mean(one, axis=0)) for one in each))

    def _statistics(self, run: Observed) -> _Statistics:
        return _Statistics(flights=flight_statistics(run, rig=self.case.nominal), stays=near_zero_stays(run))


class _Missed:
    """By how much flights, or else stays near zero, are missed without a gap and with each of ``_FINE``."""

    def __init__(self, shown: WithGaps, *, flying: bool) -> None:
        self._shown = shown
        self._which, self._apart = (
            (attrgetter("flights"), flight_misfit) if flying else (attrgetter("stays"), near_zero_misfit)
        )
        self._told = [self._which(run) for run in shown.told]

    @property
    def count(self) -> int:
        """How many numbers of all runs are compared."""
        return int(np.concatenate(self._told).size)

    @property
    def closed(self) -> float:
        """Without a gap."""
        return self._cost([self._which(run) for run in self._shown.closed])

    @property
    def opened(self) -> Floats:
        """With a gap, shape (fine,)."""
        each = np.array([[self._which(run) for run in runs] for runs in self._shown.opened])
        return np.array([self._cost(modelled) for modelled in _smoothed(each)])

    def _cost(self, modelled: Sequence[Floats] | Floats) -> float:
        pairs = zip(self._told, modelled, strict=True)
        return float(sum(robust_squares(self._apart(measured, model)).sum() for measured, model in pairs))


def _told_by(shown: WithGaps, *, flying: bool) -> Width | None:
    """Return the width as flights tell it, or else stays near zero."""
    missed = _Missed(shown, flying=flying)
    closed = missed.closed
    if closed < _LEAST_GAIN:
        return None
    costs = missed.opened
    # what no width explains is no chance of the width's: the variance is inflated by it
    inflated = costs / max(1.0, float(costs.min()) / missed.count)
    inflated += _far_from_longest(shown.case, shown.seen) if flanks_fly(shown.case) else 0.0
    at = int(np.argmin(inflated))
    if costs[at] >= closed - _LEAST_GAIN:
        return None
    return Width(float(_FINE[at]), _within(inflated), closed, float(costs[at]))


def _far_from_longest(case: Case, seen: Sequence[Features]) -> Floats:
    """Return what each width costs for being far from the longest flight, shape (fine,).

    Flanks that fly from side to side move by the gap; how far is told well only where the motor's angle was measured.
    """
    apart = np.log(_FINE / longest_flight([features.untoned for features in seen], case.nominal))
    measured = all(features.observed.angle_measured for features in seen)
    return np.asarray(np.where(apart > 0, apart / _BEYOND, apart / _SHORT if measured else 0.0) ** 2)


def _within(costs: Floats) -> tuple[float, float]:
    """Return the 95 % interval of the width [rad], from what each costs."""
    alike, best = _FINE[costs < costs.min() + _ALIKE], float(_FINE[np.argmin(costs)])
    reach = exp(1.96 * _CONTACT)
    return min(best / reach, float(alike[0])), max(best * reach, float(alike[-1]))


def _smoothed(each: Floats) -> Floats:
    """Return statistics at fine steps of the gap, shape (fine, ...), from those at ``_GAPS``, shape (gaps, ...).

    Two simulations with one gap differ by chance more than those of neighbouring gaps should, so each statistic is
    taken as a parabola over the gap's logarithm.
    """
    bent = np.polynomial.polynomial.polyfit(np.log(_GAPS), each.reshape(_GAPS.size, -1), 2)
    at_each = np.polynomial.polynomial.polyval(np.log(_FINE), bent).T
    return np.asarray(at_each.reshape(_FINE.size, *each.shape[1:]))
