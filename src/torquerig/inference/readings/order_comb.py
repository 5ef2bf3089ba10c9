"""How well lines at given orders agree with whole runs: a likelihood that resolves orders more finely than blocks do.

The power of a bin over that of noise is an exponential variate of mean 1; where a line is, of mean ``1 + s``, with s
the expected power of the line over the noise. The logarithm of the likelihood ratio of a line at a bin is therefore
``x s / (1 + s) - ln(1 + s)``.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.noise_ratios import (
    FEWEST_TURNS,
    NEAR,
    Density,
    as_exponential,
    over_floor,
    spectrum,
)
from torquerig.inference.measured_run import MeasuredRun

Floats = NDArray[np.float64]

_CLEAREST = 100.0  # [1] power over noise: a line that is expected to exceed it by more may be ten times weaker
_MOST = 25.0  # [1] times the noise: no line of one run counts for more, so that a single one does not decide
_FEWEST_BINS = 800  # of a spectrum whose noise is estimated from neighbours
_SPEED_ERROR = 0.005  # [1] standard deviation of a speed without an encoder, before the lines of the run
_SIGMAS = 3.0  # [standard deviations] of the speed within which it is estimated
_SPREAD = 0.5  # [bins] a line that the wander of the speed spreads by more has no sharp peak
_LEAST_WANDER = 5e-4  # [1] of a speed without an encoder of which no wander is stated
_FINER = 4  # points per bin: a line between two bins of a Hann window would lose a third of its power
_BANDWIDTH = 1.5  # [bins] of noise under a Hann window


@dataclass(frozen=True, eq=False)
class OrderSpectrum:
    """Power over noise of a whole run along the orders of the motor.

    Parameters
    ----------
    ratio : ndarray, shape (points,)
        As an exponential variate [1], at most ``_MOST`` and smaller next to a stronger bin; NaN where a line is known.
    step : float
        [1/rev]
    factors, log_weights : ndarray, shape (factors,)
        Real speeds over the estimated one [1], and the logarithms of their probabilities by the known lines.
    """

    ratio: Floats
    step: float
    factors: Floats = field(default_factory=lambda: np.ones(1))
    log_weights: Floats = field(default_factory=lambda: np.zeros(1))

    def log_ratio(self, orders: Floats, expected: Floats) -> Floats:
        """Return the log-likelihood ratio of lines at orders [1/rev] to none [nats], averaged over the factors.

        Parameters
        ----------
        orders : ndarray, shape (combs, lines)
        expected : ndarray, shape (lines,)
            Power over noise [1].

        Returns
        -------
        ndarray, shape (combs,)
        """
        each = [log + self._at(orders * factor, expected)
                for factor, log in zip(self.factors.tolist(), self.log_weights.tolist(), strict=True)]  # fmt: skip
        return np.asarray(np.logaddexp.reduce(each, axis=0))

    def _at(self, orders: Floats, expected: Floats) -> Floats:
        inside = orders < (self.ratio.size - 0.5) * self.step  # not those that a comb does not have, NaN
        x = self.ratio[np.rint(np.where(inside, orders, 0.0) / self.step).astype(int)]
        s = np.minimum(expected, _CLEAREST)
        each = x * s / (1 + s) - np.log1p(s)
        return np.asarray(np.where(inside & np.isfinite(x), each, 0.0).sum(axis=-1))


def expected_over_noise(run: MeasuredRun, orders: Floats, square: Floats, density: Density) -> Floats:
    """Return the power over noise [1] in a whole run of lines, from the squares of their amplitudes [(N m)^2]."""
    frequency = orders * float(np.abs(run.speed).mean()) / (2 * pi)
    noise = _BANDWIDTH * density(frequency) * run.rate / run.torque.size
    return np.asarray(0.5 * square / np.maximum(noise, 1e-300))


def order_spectrum(
    run: MeasuredRun, *, fixed: Floats, expected: Floats, highest: float, density: Density
) -> OrderSpectrum | None:
    """Return the spectrum along orders; None where the shaft turns back or too little, or nobody knows how it turned.

    Without an encoder the angle is that of a constant speed. How far it is off is estimated by the known lines, and
    only lines are compared that the wander of the speed does not spread over more than a bin.

    Parameters
    ----------
    fixed, expected : ndarray, shape (fixed,)
        Orders of known lines [1/rev], which are left out, and their power over noise [1].
    highest : float
        Order up to which it is needed [1/rev].
    density : callable
        What a model expects without its lines [(N m)^2/Hz] by frequency [Hz].
    """
    angle = np.sign(float(run.angle[-1] - run.angle[0])) * (run.angle - run.angle[0])
    turned = float(angle[-1])
    known = run.has_encoder or run.is_steady
    if not known or turned < 2 * pi * FEWEST_TURNS or (run.speed.min() < 0 < run.speed.max()):
        return None
    even = np.interp(np.linspace(0.0, turned, angle.size), np.maximum.accumulate(angle), run.torque)
    time = np.linspace(-1.0, 1.0, even.size)
    level = even - even.mean()
    level = level - time * float(level @ time) / float(time @ time)
    ratio = _over_floor(level, run.rate, max(int(highest * turned / (2 * pi)) + 2, _FEWEST_BINS), density)
    if ratio is None:
        return None
    step = 2 * pi / turned / _FINER
    value = _at_peaks(ratio)
    if run.has_encoder:
        return OrderSpectrum(_without(value, fixed / step), step)
    value[int(_FINER * _SPREAD / max(run.wander, _LEAST_WANDER)) :] = np.nan
    factors, weights = _factors(OrderSpectrum(value, step), fixed, expected)
    return OrderSpectrum(_without(value, fixed * factors[int(np.argmax(weights))] / step), step, factors, weights)


def _over_floor(level: Floats, rate: float, bins: int, density: Density) -> Floats | None:
    """Return the power over noise of the first bins at ``_FINER`` points per bin; None where there are too few."""
    power = spectrum(level, rate)[:bins]
    ratio = over_floor(power, density(np.arange(power.size) * rate / level.size))
    if ratio is None:
        return None
    floor = power / np.maximum(ratio, 1e-300)
    fine = spectrum(level, rate, finer=_FINER)[: (power.size - 1) * _FINER + 1]
    return np.asarray(fine / np.maximum(np.interp(np.arange(fine.size) / _FINER, np.arange(power.size), floor), 1e-300))


def _factors(found: OrderSpectrum, fixed: Floats, expected: Floats) -> tuple[Floats, Floats]:
    """Return factors of the speed, shape (factors,), and the logarithms of their probabilities by known lines."""
    bins = int(np.flatnonzero(np.isfinite(found.ratio)).max(initial=0))
    half = max(int(np.ceil(_SIGMAS * _SPEED_ERROR * bins)), 1)
    off = np.linspace(-_SIGMAS * _SPEED_ERROR, _SIGMAS * _SPEED_ERROR, 2 * half + 1)
    score = -0.5 * np.square(off / _SPEED_ERROR) + found.log_ratio((1 + off)[:, None] * fixed, expected)
    return 1 + off, np.asarray(score - np.logaddexp.reduce(score))


def _at_peaks(ratio: Floats) -> Floats:
    """Return the variate of each bin, times its share of the largest power nearby: next to a line there is no other."""
    from scipy.ndimage import maximum_filter1d

    share = ratio / np.maximum(maximum_filter1d(ratio, 2 * _FINER * int(NEAR) + 1), 1e-300)
    value = np.minimum(as_exponential(ratio), _MOST) * share
    value[: _FINER * int(NEAR)] = np.nan
    return np.asarray(value)


def _without(value: Floats, places: Floats) -> Floats:
    """Return the variates without those next to the bins of known lines."""
    kept, reach = value.copy(), _FINER * NEAR
    for at in places.tolist():
        kept[max(int(np.ceil(at - reach)), 0) : max(int(np.floor(at + reach)) + 1, 0)] = np.nan
    return kept
