"""Lines of whole orders as a table over one turn that the compiled loop can look up."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from proof.rig_program.true_rig import Line

MOTOR_POINTS = 1 << 14
OUTPUT_POINTS = 1 << 16


def angles(points: int) -> NDArray[np.float64]:
    """Angles over one turn (points,) [rad]."""
    return np.asarray(np.linspace(0.0, 2.0 * np.pi, points, endpoint=False))


def sum_of(lines: Iterable[Line], *, points: int) -> NDArray[np.float64]:
    """Sum cosines of whole orders over one turn (points,).

    Looked up on straight lines between points, an order k is off by (2 pi k / points)^2 / 8 of itself: 1.4e-5 for
    order 28 of the motor, 5e-4 for order 168, 1.3e-4 for order 336 of the output shaft.
    """
    turn = angles(points)
    total = np.zeros(points)
    for line in lines:
        total += line.amplitude * np.cos(line.order * turn + line.phase)
    return total


def slope_of(table: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the derivative of a table over its turn (points,) [per rad], by its Fourier series."""
    spectrum = np.fft.rfft(table)
    return np.asarray(np.fft.irfft(1j * np.arange(spectrum.size) * spectrum, table.size))
