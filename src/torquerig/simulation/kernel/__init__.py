"""The compiled loop, which integrates any rig given by the arrays of ``simulation/arrays.py``.

================ ================================================================================
``loop``         Runge-Kutta 4 with located contacts; ``side_by_side``: the loop over lanes
``forces``       torques of one evaluation; ``rare``: terms that most rigs do not have
``control``      measured speed and command of the drives
``ladder``       cosines and sines of one evaluation
``contact``      contact in a gap, and the moment at which it changes
``imposed``      imposed motions
``work``         work arrays; ``keep``: outputs at every sample
``direction``    the smoothed sign of a speed
``lanes``        vectors of eight numbers as one type; ``choice``: branches and indices for them
``elementary``   sine, exponential, tanh for numbers and lanes
``fast``         compiler flags; ``sources``: checksum of the sources
================ ================================================================================

The functions are written for one number and compiled twice: for one rig, and for vectors of eight similar rigs.

Numba's cache on disk checks one file and not those that it calls; ``sources`` makes all of these files part of its key.
"""

from torquerig.simulation.kernel.keep import (
    ANGLE,
    DRIVE_TORQUE,
    IMPOSING_TORQUE,
    OPPOSING_TORQUE,
    SPEED,
    SPRING_TORQUE,
)
from torquerig.simulation.kernel.loop import integrate, integrate_part

__all__ = [
    "ANGLE",
    "DRIVE_TORQUE",
    "IMPOSING_TORQUE",
    "OPPOSING_TORQUE",
    "SPEED",
    "SPRING_TORQUE",
    "integrate",
    "integrate_part",
]
