"""Piecewise linear speed and load over time; two points at one time are a step."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True)
class Breakpoints:
    """Speed, and load where stated, at points in time, with straight lines between them.

    Parameters
    ----------
    time : tuple of float, shape (points,)
        [s] from 0, not decreasing; a time that occurs twice is a step, and the second value holds from there.
    speed : tuple of float, shape (points,)
        [rad/s]
    load : tuple of float, shape (points,), or None
        Torque against the wear part's motion [N m]; None: the rig's load applies.
    held : tuple of bool, shape (points,), or None
        Whether the drive must hold that torque at rest too, such as a weight; None: nowhere, as of a load that only
        resists motion.
    """

    time: tuple[float, ...]
    speed: tuple[float, ...]
    load: tuple[float, ...] | None = None
    held: tuple[bool, ...] | None = None

    @property
    def length(self) -> float:
        """The time of the last point [s]."""
        return self.time[-1]

    @property
    def top(self) -> float:
        """The largest speed in either direction [rad/s]."""
        return max(map(abs, self.speed))

    def times(self, factor: float) -> Breakpoints:
        """Return the same with every speed multiplied by ``factor`` [1], such as from output to motor speed."""
        return replace(self, speed=tuple(factor * one for one in self.speed))

    def speed_at(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the speed [rad/s] at ``time`` [s]; constant before the first and after the last point."""
        return self._at(time, self.speed)

    def load_at(self, time: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Return the load [N m] at ``time`` [s]; None where none is stated."""
        return None if self.load is None else self._at(time, self.load)

    def _at(self, time: NDArray[np.float64], values: tuple[float, ...]) -> NDArray[np.float64]:
        points, known = np.array(self.time), np.array(values)
        right = np.clip(np.searchsorted(points, time, side="right"), 1, points.size - 1)
        span = points[right] - points[right - 1]
        share = np.clip((time - points[right - 1]) / np.where(span > 0, span, 1.0), 0.0, 1.0)
        between = known[right - 1] + share * (known[right] - known[right - 1])
        return np.asarray(np.where(time >= points[-1], known[-1], between))
