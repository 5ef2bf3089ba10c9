"""Two-node network: a winding heats a housing, which ambient air cools; exact while the loss is constant."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
IDENTITY = np.eye(2)


@dataclass(frozen=True, kw_only=True)
class TwoNode:
    """``Cw xw' = Pw + k xw - (xw - xh) / Rwh`` and ``Ch xh' = Ph + (xw - xh) / Rwh - xh / Rha``.

    xw and xh are the temperature rises above ambient [K]; k [W/K] is the increase of the copper loss with the winding's
    temperature. Not valid where the air flow depends on the speed (a fan on the shaft), where the flange conducts much
    heat into the machine, and for the hottest spot inside a winding.

    Parameters
    ----------
    winding_capacity, housing_capacity : float
        Cw, Ch [J/K], > 0.
    winding_to_housing, housing_to_ambient : float
        Rwh, Rha [K/W], > 0.
    """

    winding_capacity: float
    housing_capacity: float
    winding_to_housing: float
    housing_to_ambient: float

    @property
    def resistance(self) -> float:
        """From winding to ambient [K/W]."""
        return self.winding_to_housing + self.housing_to_ambient

    def matrix(self, growth: float = 0.0) -> Floats:
        """Return A of ``x' = A x + b`` [1/s]; ``growth`` is k [W/K]."""
        across, out = 1 / self.winding_to_housing, 1 / self.housing_to_ambient
        return np.array(
            [
                [(growth - across) / self.winding_capacity, across / self.winding_capacity],
                [across / self.housing_capacity, -(across + out) / self.housing_capacity],
            ]
        )

    def time_constants(self) -> tuple[float, float]:
        """Return the fast and the slow time constant [s] without current."""
        slow, fast = eigenvalues(self.matrix())
        return -1 / fast, -1 / slow

    def stretch(self, heat: Floats, growth: float) -> Stretch:
        """Return the stretch of a constant ``heat`` = (Pw, Ph) [W]."""
        source = heat / np.array([self.winding_capacity, self.housing_capacity])
        return Stretch(self.matrix(growth), source)


@dataclass(frozen=True)
class Stretch:
    """``x' = A x + b`` with constant A (2 x 2, real distinct eigenvalues) and b.

    ``x(t) = exp(A t) x0 + phi(A, t) b`` by Sylvester's formula: each function of A is its value at the one eigenvalue
    times ``(A - other) / (difference)``, summed over both (Golub & Van Loan, Matrix Computations, 9.1).
    """

    matrix: Floats
    source: Floats

    @cached_property
    def _parts(self) -> tuple[float, float, Floats, Floats]:
        """Both eigenvalues, and what each one's functions are multiplied by."""
        upper, lower = eigenvalues(self.matrix)
        first = (self.matrix - lower * IDENTITY) / (upper - lower)
        return upper, lower, first, IDENTITY - first

    @cached_property
    def _known(self) -> dict[float, tuple[Floats, Floats]]:
        """The propagators by their time: a cycle needs those of its stretches again for every start."""
        return {}

    def propagators(self, time: float) -> tuple[Floats, Floats]:
        """Return ``exp(A t)``, shape (2, 2), and the rise from zero, shape (2,)."""
        if time not in self._known:
            upper, lower, first, second = self._parts
            decay = np.exp(upper * time) * first + np.exp(lower * time) * second
            gained = (_gathered(upper, time) * first + _gathered(lower, time) * second) @ self.source
            self._known[time] = decay, gained
        return self._known[time]

    def after(self, time: float, start: Floats) -> Floats:
        """Return the temperature rises after ``time`` [s], from ``start`` [K], shape (2,)."""
        decay, gained = self.propagators(time)
        return decay @ start + gained

    def turning(self, duration: float, start: Floats) -> float | None:
        """Return the time of the extremum of the winding's temperature within the stretch [s], or None.

        Its slope is a sum of two exponentials, which is zero once at most.
        """
        upper, lower, _, _ = self._parts
        slope = self.matrix @ start + self.source
        first = ((self.matrix - lower * IDENTITY) @ slope)[0] / (upper - lower)
        second = slope[0] - first
        if first == 0 or -second / first <= 0:
            return None
        time = float(np.log(-second / first) / (upper - lower))
        return time if 0 < time < duration else None


def eigenvalues(matrix: Floats) -> tuple[float, float]:
    """Return the two real eigenvalues, the larger first."""
    middle = 0.5 * (matrix[0, 0] + matrix[1, 1])
    half = float(np.sqrt((0.5 * (matrix[0, 0] - matrix[1, 1])) ** 2 + matrix[0, 1] * matrix[1, 0]))
    return float(middle + half), float(middle - half)


def _gathered(rate: float, time: float) -> float:
    """Return the integral of ``exp(rate s)`` over s = 0..time [s]."""
    return float(np.expm1(rate * time) / rate) if rate else time
