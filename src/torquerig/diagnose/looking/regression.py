"""What of a stretch of signal are given lines: complex amplitudes by least squares, and what is left."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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

    amplitude: NDArray[np.complex128]
    level: float
    slope: float
    rest: NDArray[np.float64]
    widening: NDArray[np.float64]


HANN_NOISE = 1.5  # spread of an amplitude under a Hann window, as a factor on its variance without one


def regressed(
    values: NDArray[np.float64], waves: NDArray[np.complex128], *, window: NDArray[np.float64] | None = None
) -> Regression:
    """Return the least-squares amplitudes of lines whose waves, ``exp(i phase)``, are the rows of ``waves``.

    ``window`` weighs the samples: a Hann window keeps strong slow noise from leaking into weak fast lines, at the price
    of ``HANN_NOISE`` and of resolution.
    """
    count, lines = values.size, waves.shape[0]
    basis = np.vstack([np.ones(count), np.linspace(-1.0, 1.0, count), waves.real, -waves.imag])
    weighted = basis if window is None else basis * window
    gram = weighted @ basis.T
    gram[np.diag_indices_from(gram)] += _RIDGE * count
    inverse = np.linalg.inv(gram)
    found = inverse @ (weighted @ values)
    widened = (np.diag(inverse) * np.diag(gram))[2:]
    return Regression(
        amplitude=found[2 : 2 + lines] + 1j * found[2 + lines :],
        level=float(found[0]),
        slope=float(found[1]),
        rest=values - found @ basis,
        widening=0.5 * (widened[:lines] + widened[lines:]),
    )
