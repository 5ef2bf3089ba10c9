"""At which share of the speed of its field an induction motor turns under the load of its rig.

The slip follows from the torque that the rig requires, on Kloss's curve, and the torque from the speed: they are
balanced by iteration. Source: Kloss 1909 (``rig/parts/induction_drive.py``). Not valid beyond the breakdown torque.
"""

from __future__ import annotations

import numpy as np

from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import Twin
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig

_BALANCED = 6  # steps of the iteration of speed and torque; each reduces the error by the slip


def share_of_field(rig: Rig, run: Run) -> float:
    """Return the speed of the motor over that of its field [1] at the set-point of a run; 1 without such a drive."""
    field, slip = run.speed or 0.0, 0.0
    drives = rig.of_kind("induction_drive")
    if not field or not drives:
        return 1.0
    twin = Twin(rig.at(run))
    for _ in range(_BALANCED):
        speed = np.array([field - slip])
        torque = float(quasi_static(twin, speed=speed, acceleration=np.zeros(1)).motor[0])
        slip = drives[0].slip_speed(torque)
    return 1 - slip / field
