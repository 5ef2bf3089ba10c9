"""The probability of each speed, given the peaks of the spectrum: each is a known order, hum, another tone or noise."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.angle.order_peaks import OrderPeaks

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

TOLERANCE = 0.01  # [1] relative tolerance of a set-point (CONTRACTS.md)
REACH = 0.015  # [1] largest relative deviation that is considered
_BEYOND = 0.002  # [1] standard deviation of a deviation beyond the tolerance
_PRESENT = 0.3  # [1] prior probability that a known order is seen in the spectrum
_TONES = 1.1  # unknown tones per factor e of frequency: about ten from 1 Hz to 10 kHz
_HEIGHTS = 17.0  # natural logarithm of the range of a line's power over the floor: 1e7
_DISPLACED, _FURTHER = 0.01, 5.0  # share of the lines whose peak is displaced, and by how many times its uncertainty
_WANDERS = (
    (0.0, 0.98),
    (3e-5, 0.01),
    (3e-4, 0.01),
)  # relative wander of a line, its prior probability
_HUM = 0.5  # prior probability of hum
_OTHER_COMB = 0.01  # prior probability of a comb of another fixed fundamental
_FUNDAMENTALS = 1 / 9  # per factor e: its fundamental is anywhere from 1 Hz to 10 kHz
_HARMONIC = 0.5  # probability that the first harmonic of a comb is seen; less by the root of the harmonic's number
_CLEAR = 30.0  # power over the noise of a peak that is no noise
HUM_OFF = 0.003  # [1] largest relative deviation of the mains' frequency, and of the clock of the recorder
_FAR = 9.0  # standard deviations beyond which a density is 0
_UNRESOLVED = 2.5  # [bins] a line nearer to hum may be one peak with it
_MERGED = 0.7  # [bins] standard deviation of the position of such a peak
_CENTRAL = (0.025, 0.5, 0.975)


@dataclass(frozen=True)
class SpeedPosterior:
    """The relative deviation of the speed from the set-point [1]: its median and the ends of its 95 % interval."""

    middle: float
    low: float
    high: float

    @property
    def half_width(self) -> float:
        """The larger distance of an end of the interval from the median [1]."""
        return max(self.high - self.middle, self.middle - self.low)


def speed_posterior(peaks: OrderPeaks, orders: Floats, *, mains: tuple[float, ...] = ()) -> SpeedPosterior:
    """Return the posterior of the relative deviation of the speed from the set-point.

    Parameters
    ----------
    peaks : OrderPeaks
        Over the angle of the set-point.
    orders : ndarray, shape (orders,)
        Known orders of the motor [1/rev].
    mains : tuple of float
        Where the frequencies of possible mains are at the set-point [1/rev].

    Notes
    -----
    Each peak is one of: a line at a known order times the speed, a harmonic of the mains or of another fixed comb, a
    tone of another frequency, or noise. The likelihood of a speed is the product over the peaks of the sum of these
    densities. It is averaged over the unknown fundamental of one comb, and over a wander that displaces the lines.
    The prior is even within 1 % of the set-point. A peak that fits no order lowers no speed, so one strong unknown
    tone does not attract the speed.
    """
    lines = _Pairs.of(peaks, orders)
    grid = _grid(lines)
    log = _averaged(grid, peaks, lines, mains)
    best = float(grid[int(np.argmax(log))])
    finest = min(lines.sd.min(initial=REACH), REACH)
    grid = np.union1d(grid, best + finest * np.linspace(-6, 6, 801))
    log = _averaged(grid, peaks, lines, mains)
    weight = np.exp(log - log.max())
    steps = 0.5 * (weight[1:] + weight[:-1]) * np.diff(grid)
    share = np.concatenate([[0.0], np.cumsum(steps)]) / steps.sum()
    low, middle, high = np.interp(_CENTRAL, share, grid)
    return SpeedPosterior(float(middle), float(low), float(high))


@dataclass(frozen=True)
class _Pairs:
    """Peaks and orders within reach of each other: peak and order, the deviation they mean, its uncertainty [1]."""

    peak: NDArray[np.int64]
    order: Floats
    at: Floats
    sd: Floats

    @staticmethod
    def of(peaks: OrderPeaks, orders: Floats) -> _Pairs:
        relative = peaks.at[:, None] / orders - 1
        peak, order = np.nonzero(np.abs(relative) < 1.1 * REACH)
        return _Pairs(peak, orders[order], relative[peak, order], peaks.sd[peak] / orders[order])


def _grid(lines: _Pairs) -> Floats:
    """Return the deviations at which the posterior is computed, ascending: even, and close near each pair."""
    offsets = np.linspace(-6, 6, 33)
    near = (lines.at[:, None] + lines.sd[:, None] * offsets).ravel()
    even = np.linspace(-REACH, REACH, 2001)
    return np.unique(np.concatenate([even, near[np.abs(near) < REACH]]))


def _averaged(grid: Floats, peaks: OrderPeaks, lines: _Pairs, mains: tuple[float, ...]) -> Floats:
    """Return the log of the posterior on the grid, averaged over wander and mains."""
    beyond = np.maximum(np.abs(grid) - TOLERANCE, 0.0)
    prior = -0.5 * (beyond / _BEYOND) ** 2
    merged = _near_hum(peaks, mains)
    logs = []
    for wander, share in _WANDERS:
        densities = _line_densities(grid, peaks, lines, wander=wander, merged=merged)
        for weight, others in _other_densities(peaks, mains):
            logs.append(np.log(share * weight) + np.log(densities + others[:, None]).sum(axis=0))
    return np.asarray(prior + np.logaddexp.reduce(np.stack(logs), axis=0))


def _line_densities(
    grid: Floats, peaks: OrderPeaks, lines: _Pairs, *, wander: float, merged: NDArray[np.bool_]
) -> Floats:
    """Return the density of each peak as a line of any known order [rev], shape (peaks, grid)."""
    total = np.zeros((peaks.at.size, grid.size))
    for peak, order, at, sd in zip(lines.peak, lines.order, lines.at, lines.sd, strict=True):
        narrow = float(np.hypot(sd, wander))
        wide, share = _FURTHER * narrow, _DISPLACED
        if merged[peak]:
            wide, share = float(np.hypot(narrow, _MERGED * peaks.width / order)), 0.5
        reached = slice(*np.searchsorted(grid, (at - _FAR * wide, at + _FAR * wide)))
        away = grid[reached] - at
        density = (1 - share) * _normal(away, narrow) + share * _normal(away, wide)
        total[peak, reached] += _PRESENT / order * density
    return total


def _other_densities(peaks: OrderPeaks, mains: tuple[float, ...]) -> Iterator[tuple[float, Floats]]:
    """Yield the prior probability of each hypothesis about fixed combs, and the density of each peak without a line.

    There is none, hum of the mains, or a comb of another fundamental, such as an electronic clock or an alias.
    """
    noise = _HEIGHTS * peaks.over_floor * np.exp(-0.85 * peaks.over_floor) / peaks.width
    alone = _TONES / peaks.at + noise
    yield 1 - _HUM - _OTHER_COMB, alone
    for fundamental in mains:
        harmonic = np.maximum(np.round(peaks.at / fundamental), 1.0)
        for first in np.flatnonzero(np.abs(peaks.at / (harmonic * fundamental) - 1) < HUM_OFF):
            comb = _comb_density(peaks, int(first), peaks.at[first] / harmonic[first])
            # the first peak determines the frequency of the mains, which may be anywhere in its range
            comb[first] = _HARMONIC / (2 * HUM_OFF * peaks.at[first])
            yield _HUM / len(mains), alone + comb
    for first in np.flatnonzero(peaks.over_floor > _CLEAR):
        comb = _comb_density(peaks, int(first), float(peaks.at[first]))
        if np.delete(comb > alone, first).any():
            comb[first] = _FUNDAMENTALS / peaks.at[first]
            yield _OTHER_COMB, alone + comb


def _comb_density(peaks: OrderPeaks, first: int, fundamental: float) -> Floats:
    """Return the density of each peak as a harmonic of a ``fundamental`` that the peak ``first`` determines."""
    harmonic = np.maximum(np.round(peaks.at / fundamental), 1.0)
    away = peaks.at / (harmonic * fundamental) - 1
    spread = np.hypot(peaks.sd / (harmonic * fundamental), peaks.sd[first] / peaks.at[first])
    density = (1 - _DISPLACED) * _normal(away, spread) + _DISPLACED * _normal(away, _FURTHER * spread)
    return np.asarray(_HARMONIC / np.sqrt(harmonic) * density / (harmonic * fundamental))


def _near_hum(peaks: OrderPeaks, mains: tuple[float, ...]) -> NDArray[np.bool_]:
    """Return whether each peak may be merged with a harmonic of the mains, shape (peaks,)."""
    near = np.zeros(peaks.at.size, dtype=bool)
    for fundamental in mains:
        harmonic = np.maximum(np.round(peaks.at / fundamental), 1.0)
        near |= np.abs(peaks.at - harmonic * fundamental) < _UNRESOLVED * peaks.width + 0.001 * peaks.at
    return near


def _normal(away: Floats, sd: Floats | float) -> Floats:
    return np.asarray(np.exp(-0.5 * (away / sd) ** 2) / (np.sqrt(2 * np.pi) * sd))
