"""The spectrum of what rounding to coarse codes adds: white only where the signal moves by a code between samples."""

from __future__ import annotations

from functools import lru_cache
from math import pi

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_POINTS = 2048  # of the correlation, 80 ms at 25 kHz: codes forget sooner
_HARMONICS = 4
_FEW_CODES = 3.0  # a signal whose spread is so many codes rounds as theory says
_OF_A_CODE = 0.05  # amplitude of the largest lines that rounding makes of four lines of up to a code, undithered


def rounding_density(
    step: float, *, rate: float, frequency: Floats, power: Floats, lines: Floats, sizes: Floats
) -> Floats:
    """Return the one-sided density of the rounding error [(N m)^2/Hz] at ``frequency``.

    Widrow and Kollar, Quantization Noise (2008), ch. 9: over a signal that spans many codes the error has the
    correlation ``sum_k step^2 / (2 pi^2 k^2) exp(-(2 pi k / step)^2 D / 2)`` where D is the mean square change of the
    signal, here as of a normal process. Where the signal spans a code or two the error depends on where it stands
    between them, see ``rounding_tolerance``.

    Parameters
    ----------
    step : float
        [N m].
    rate : float
        Samples per second [Hz].
    frequency, power : ndarray, shape (bands,)
        Density of the signal [(N m)^2/Hz] over frequency [Hz], ascending.
    lines, sizes : ndarray, shape (lines,)
        Frequencies [Hz] and amplitudes [N m] of its lines.
    """
    grid = np.linspace(0.0, 0.5 * rate, _POINTS // 2 + 1)
    density = np.exp(np.interp(np.log(np.maximum(grid, 1e-3)), np.log(frequency), np.log(np.maximum(power, 1e-300))))
    covariance = np.fft.irfft(density) * 0.5 * rate
    change = 2 * (covariance[0] - covariance[: grid.size]) + sizes**2 @ _swings(rate, lines.tobytes())
    order = np.arange(1, _HARMONICS + 1)[:, None]
    kept = np.exp(-0.5 * (2 * pi * order / step) ** 2 * np.maximum(change, 0.0))
    correlation = (step**2 / (2 * pi**2 * order**2) * kept).sum(axis=0)
    correlation[0] = step**2 / 12
    error = np.fft.hfft(correlation)[: grid.size] * 2 / rate
    return np.asarray(np.interp(frequency, grid, np.maximum(error, 0.0)))


@lru_cache(maxsize=16)
def _swings(rate: float, lines: bytes) -> Floats:
    """Return by what lines of size 1 change over each lag, mean square, shape (lines, lags); asked again for each fit.

    ``lines`` are the bytes of their frequencies [Hz].
    """
    lag = np.arange(_POINTS // 2 + 1) / rate
    return np.asarray(1 - np.cos(2 * pi * np.frombuffer(lines)[:, None] * lag))


def rounding_tolerance(step: float, added: Floats, power: Floats, *, spread: float) -> Floats:
    """Return by what the logarithm of ``power``, of which ``added`` comes of rounding, may be off [1].

    ``spread`` is the standard deviation of the signal [N m]: the fewer codes it spans, the less theory holds.
    """
    return np.asarray(np.minimum(step / (_FEW_CODES * max(spread, 1e-12)), 1.0) * added / np.maximum(power, 1e-300))


def rounded_lines(step: float, *, dither: float) -> float:
    """Return the size of the lines that rounding may make, or take from others [N m].

    Of a signal of lines alone the error is a sum of their products, most of them small. What is random dithers it: each
    product falls by ``exp(-2 pi^2 dither^2 / step^2)``, the characteristic function of a normal variate (Widrow and
    Kollar 2008, ch. 19).

    Parameters
    ----------
    step : float
        [N m].
    dither : float
        Standard deviation of what is random in the signal [N m].
    """
    return float(_OF_A_CODE * step * np.exp(-2 * (pi * dither / step) ** 2))
