"""What of a stretch of signal are given lines: complex amplitudes by least squares, and what is left."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.waves import Waves

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_RIDGE = 1e-9  # of the mean square of a basis function: keeps two lines that coincide from blowing up


@dataclass(frozen=True)
class Regression:
    """``values = Re sum_k amplitude_k exp(i phase_k) + level + slope t + rest``, t from -1 to 1.

    Parameters
    ----------
    amplitude : ndarray, shape (lines,)
        Complex, in the unit of the signal, zero to peak.
    level, slope : float
        The straight line beside the lines.
    rest : ndarray, shape (samples,)
        What neither explains.
    widening : ndarray, shape (lines,)
        By what the others beside it multiply the variance of a line's amplitude [1]: the diagonal of the inverse of the
        normal equations' matrix times its own.
    """

    amplitude: Complex
    level: float
    slope: float
    rest: Floats
    widening: Floats


HANN_NOISE = 1.5  # spread of an amplitude under a Hann window, as a factor on its variance without one


def hann_transform(bins: Floats) -> Floats:
    """Return the amplitude [1] that a Hann window keeps of a line so many bins from the one looked for."""
    return np.asarray(np.sinc(bins) + 0.5 * (np.sinc(bins - 1) + np.sinc(bins + 1)))


def regressed(values: Floats, waves: Waves, *, window: Floats | None = None) -> Regression:
    """Return the least-squares amplitudes of the lines of ``waves``.

    ``window`` weighs the samples: a Hann window keeps strong slow noise from leaking into weak fast lines, at the price
    of ``HANN_NOISE`` and of resolution.
    """
    count, lines = values.size, waves.lines
    ramp = np.linspace(-1.0, 1.0, count)
    weight = np.ones(count) if window is None else np.sqrt(np.maximum(window, 0.0))
    gram, seen = np.zeros((2 + 2 * lines, 2 + 2 * lines)), np.zeros(2 + 2 * lines)
    for part in waves.pieces():
        own = weight[part]
        basis = np.vstack([own, ramp[part] * own, waves.weighted(part, own)])
        gram += basis @ basis.T
        seen += basis @ (own * values[part])
    gram[np.diag_indices_from(gram)] += _RIDGE * count
    inverse = np.linalg.inv(gram)
    found = inverse @ seen
    amplitude = found[2 : 2 + lines] + 1j * found[2 + lines :]
    widened = (np.diag(inverse) * np.diag(gram))[2:]
    return Regression(
        amplitude=amplitude,
        level=float(found[0]),
        slope=float(found[1]),
        rest=values - found[0] - found[1] * ramp - waves.summed(amplitude),
        widening=0.5 * (widened[:lines] + widened[lines:]),
    )
