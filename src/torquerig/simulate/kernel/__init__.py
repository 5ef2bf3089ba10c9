"""The compiled loop: any rig, lowered to the arrays of ``simulate/arrays.py``, through time.

loop      Runge-Kutta 4, contacts located    forces     torques of one evaluation    ladder    cosines and sines
imposed   motions that are given
control   what drives see and command        rare       terms that most rigs lack    keep      what a run keeps
sources   what the cache on disk stands on   direction  the smoothed sign of a speed

Numba's cache on disk looks at one file and not at those it calls; ``sources`` makes all of these files part of its key.
"""

from torquerig.simulate.kernel.keep import (
    ANGLE,
    DRIVE_TORQUE,
    IMPOSING_TORQUE,
    OPPOSING_TORQUE,
    SPEED,
    SPRING_TORQUE,
)
from torquerig.simulate.kernel.loop import integrate

__all__ = [
    "ANGLE",
    "DRIVE_TORQUE",
    "IMPOSING_TORQUE",
    "OPPOSING_TORQUE",
    "SPEED",
    "SPRING_TORQUE",
    "integrate",
]
