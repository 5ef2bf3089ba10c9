"""How well lines at given orders agree with whole runs: a likelihood that resolves orders more finely than blocks do.

The power of a bin over that of noise is an exponential variate of mean 1; where a line is, of mean ``1 + s``, with s
the expected power of the line over the noise. The logarithm of the likelihood ratio of a line at a bin is therefore
``x s / (1 + s) - ln(1 + s)``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
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
_BANDWIDTH = 1.5  # [bins] of noise under a Hann window


@dataclass(frozen=True, eq=False)
class OrderSpectrum:
    """Power over noise of a whole run along the orders of the motor.

    Parameters
    ----------
    ratio : ndarray, shape (bins,)
        As an exponential variate [1], at most ``_MOST`` and smaller next to a stronger bin; NaN where a line is known.
    step : float
        [1/rev]
    """

    ratio: Floats
    step: float

    def log_ratio(self, orders: Floats, expected: Floats) -> Floats:
        """Return the log-likelihood ratio of lines at orders [1/rev] to none [nats].

        Parameters
        ----------
        orders : ndarray, shape (combs, lines)
        expected : ndarray, shape (lines,)
            Power over noise [1].

        Returns
        -------
        ndarray, shape (combs,)
        """
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
    run: MeasuredRun, *, fixed: Sequence[float], highest: float, density: Density
) -> OrderSpectrum | None:
    """Return the spectrum along orders; None where no angle was measured, or where the shaft turns back or too little.

    Parameters
    ----------
    fixed : sequence of float
        Orders of known lines [1/rev], which are left out.
    highest : float
        Order up to which it is needed [1/rev].
    density : callable
        What a model expects without its lines [(N m)^2/Hz] by frequency [Hz].
    """
    angle = np.sign(float(run.angle[-1] - run.angle[0])) * (run.angle - run.angle[0])
    turned = float(angle[-1])
    # an angle that was not measured, and one between few pulses of a tacho, spreads lines over more than a bin
    if not run.has_encoder or turned < 2 * pi * FEWEST_TURNS or (run.speed.min() < 0 < run.speed.max()):
        return None
    even = np.interp(np.linspace(0.0, turned, angle.size), np.maximum.accumulate(angle), run.torque)
    time = np.linspace(-1.0, 1.0, even.size)
    level = even - even.mean()
    power = spectrum(level - time * float(level @ time) / float(time @ time), run.rate)
    step = 2 * pi / turned
    power = power[: max(int(highest / step) + 2, _FEWEST_BINS)]
    frequency = np.arange(power.size) * run.rate / even.size
    ratio = over_floor(power, density(frequency))
    if ratio is None:
        return None
    return OrderSpectrum(_at_peaks(ratio, [order / step for order in fixed]), step)


def _at_peaks(ratio: Floats, fixed: Sequence[float]) -> Floats:
    """Return the variate of each bin, times its share of the largest power nearby: next to a line there is no other."""
    from scipy.ndimage import maximum_filter1d

    share = ratio / np.maximum(maximum_filter1d(ratio, 2 * int(NEAR) + 1), 1e-300)
    value = np.minimum(as_exponential(ratio), _MOST) * share
    value[: int(NEAR)] = np.nan
    for at in fixed:
        value[max(int(at - NEAR), 0) : int(at + NEAR) + 2] = np.nan
    return np.asarray(value)
