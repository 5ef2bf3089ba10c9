"""What is given from outside over time: random torques, replayed signals, motions."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray


class LoadProcess(Protocol):
    """A random torque over time; the simulator asks it for samples."""

    @property
    def mean(self) -> float:
        """What it is on average [N m]."""
        ...

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return ``count`` samples [N m] at ``rate`` [Hz], shape (count,)."""
        ...


class AngleProcess(Protocol):
    """A random (or given) torque over the angle; the simulator asks it once a run."""

    @property
    def mean(self) -> float:
        """What it is on average [N m]."""
        ...

    @property
    def points_per_turn(self) -> int:
        """How many points of the grid lie on a turn, > 0."""
        ...

    def sample(self, rng: np.random.Generator) -> NDArray[np.float64]:
        """Return the torque [N m] on the points of the grid from angle 0 on, shape (points,); then it repeats."""
        ...


@runtime_checkable
class Signal(Protocol):
    """A torque that is known at every time: a profile, or a measured channel that is replayed."""

    def at(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the torque [N m] at equally spaced times [s]; 0 is the first kept sample, before it the rig settles.

        Raises
        ------
        InputError
            Where the times go beyond what is known.
        """
        ...


class Motion(Protocol):
    """Angle and speed of a shaft that are known at every time."""

    def at(self, time: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return angle [rad] and speed [rad/s] at equally spaced times [s]; see ``Signal.at``."""
        ...
