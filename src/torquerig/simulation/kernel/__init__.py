"""The compiled loop: any rig, lowered to the arrays of ``simulation/arrays.py``, through time.

loop        Runge-Kutta 4, contacts located       forces     torques of one evaluation
control     what drives see and command           ladder     cosines and sines of one evaluation
contact     flanks of a gap, and when they meet   imposed    motions that are given
rare        terms that most rigs lack             work       the arrays that the loop works in
keep        what a run keeps                      sources    what the cache on disk stands on
direction   the smoothed sign of a speed

The functions are written for one number and compiled twice: for one rig, and for eight like rigs side by side.

lanes       eight numbers as one                  choice     what branches and indices become there
elementary  sine, exponential, tanh for both      side_by_side   the loop over lanes
fast        what the compiler may rearrange

Numba's cache on disk looks at one file and not at those it calls; ``sources`` makes all of these files part of its key.
"""

from torquerig.simulation.kernel.keep import (
    ANGLE,
    DRIVE_TORQUE,
    IMPOSING_TORQUE,
    OPPOSING_TORQUE,
    SPEED,
    SPRING_TORQUE,
)
from torquerig.simulation.kernel.loop import integrate

__all__ = [
    "ANGLE",
    "DRIVE_TORQUE",
    "IMPOSING_TORQUE",
    "OPPOSING_TORQUE",
    "SPEED",
    "SPRING_TORQUE",
    "integrate",
]
