"""The interval of a root mean square, and of the difference of two, from values of independent segments."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, stats

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class MeanSquare:
    """A mean square of segments.

    Parameters
    ----------
    value : float
        Without the noise.
    error : float
        Its standard error.
    segments : int
        Values behind it.
    noise : float
        Mean square of the Gaussian noise in which a line is; 0 for a band, whose mean square is noise itself.
    """

    value: float
    error: float
    segments: int
    noise: float = 0.0

    def root(self) -> float:
        """Return the root; 0 where the mean square is negative after the noise was subtracted."""
        return float(np.sqrt(max(self.value, 0.0)))

    def reach(self, level: float, *, freedom: float) -> tuple[float, float]:
        """Return the roots of both ends of the interval that misses the truth with probability ``level``.

        Student's interval; of a line it is widened to that of a constant line in Gaussian noise, whose distribution is
        skew: twice the sum of the squares over the noise is noncentral chi-square.
        """
        times = float(stats.t.isf(level / 2, freedom))
        low, high = self.value - times * self.error, self.value + times * self.error
        if self.noise > 0:
            least, most = self._of_constant_line(level)
            low, high = min(low, least), max(high, most)
        return float(np.sqrt(max(low, 0.0))), float(np.sqrt(max(high, 0.0)))

    def _of_constant_line(self, level: float) -> tuple[float, float]:
        """Return the squared amplitudes at which so small or so large a mean square has the probability level / 2."""
        count = 2 * self.segments
        seen = count * max(self.value + self.noise, 0.0) / self.noise
        top = seen + 20.0 * np.sqrt(2 * (count + 2 * seen)) + 200.0
        found = []
        for tail in (stats.ncx2.sf, stats.ncx2.cdf):

            def excess(strength: float, tail: Any = tail) -> float:
                return float(tail(seen, count, strength)) - level / 2

            ends = excess(1e-9), excess(top)
            crosses = ends[0] * ends[1] < 0
            found.append(float(optimize.brentq(excess, 1e-9, top, rtol=1e-4)) if crosses else 0.0)
        return found[0] * self.noise / count, found[1] * self.noise / count


def line_square(powers: Floats, noise: float) -> MeanSquare:
    """Return the squared amplitude of a line from those of the segments, shape (segments,), without its noise.

    The variance is that of a constant line in complex Gaussian noise, ``2 A^2 s^2 + s^4`` (Rice 1944), or the scatter
    of the segments where that is larger: the line itself changes.
    """
    count = powers.size
    value = float(powers.mean()) - noise
    constant = 2 * max(value, 0.0) * noise + noise**2
    scatter = float(powers.var(ddof=1))
    return MeanSquare(value, float(np.sqrt(max(constant, scatter) / count)), count, noise)


def band_square(powers: Floats) -> MeanSquare:
    """Return the mean square of a band from those of the segments, shape (segments,)."""
    return MeanSquare(float(powers.mean()), float(powers.std(ddof=1) / np.sqrt(powers.size)), powers.size)


def difference_of_roots(before: MeanSquare, after: MeanSquare, *, level: float) -> tuple[float, float, float]:
    """Return the difference of two roots, after minus before, with the ends of its interval.

    The interval recovers the variances of both from their own intervals, which need not be symmetric (Zou and Donner
    2008, Statistics in Medicine 27, eq. 11 and 12). ``level`` is the probability that it misses the true difference;
    where one amplitude is small in its noise, it misses it up to twice as often.
    """
    first, second = before.root(), after.root()
    (low1, high1), (low2, high2) = _reaches(before, after, level)
    change = second - first
    down = float(np.hypot(second - low2, high1 - first))
    up = float(np.hypot(high2 - second, first - low1))
    return change, change - down, change + up


def sure_difference_of_roots(before: MeanSquare, after: MeanSquare, *, level: float) -> tuple[float, float, float]:
    """Return the same with an interval that misses the truth not more often where an amplitude is small.

    An interval that is cut off at 0 recovers no variance: the ends of both are added then.
    """
    (low1, high1), (low2, high2) = _reaches(before, after, level)
    if low1 == 0 or low2 == 0:
        return after.root() - before.root(), low2 - high1, high2 - low1
    return difference_of_roots(before, after, level=level)


def _reaches(before: MeanSquare, after: MeanSquare, level: float) -> list[tuple[float, float]]:
    freedom = before.segments + after.segments - 2
    return [one.reach(level, freedom=freedom) for one in (before, after)]


def difference_of_means(before: Floats, after: Floats, *, level: float) -> tuple[float, float, float]:
    """Return the difference of two means of segments, after minus before, with its interval (Welch 1947)."""
    change = float(after.mean() - before.mean())
    parts = np.array([one.var(ddof=1) / one.size for one in (before, after)])
    total = float(parts.sum())
    if total == 0:
        return change, change, change
    freedom = total**2 / float((parts**2 / (np.array([before.size, after.size]) - 1)).sum())
    reach = float(stats.t.isf(level / 2, freedom)) * np.sqrt(total)
    return change, change - reach, change + reach
