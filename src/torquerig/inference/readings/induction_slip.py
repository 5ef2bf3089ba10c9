"""At which share of the speed of its field an induction motor should turn, and how well that is known."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from typing import Any

import numpy as np

from torquerig.diagnosis.fitting.knobs import Knob, turned
from torquerig.diagnosis.linear.quasi_static import quasi_static
from torquerig.diagnosis.linear.twin import Twin
from torquerig.errors import TorquerigError
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig

_TOLERANCE = 0.2  # of the slip: what a maker may be off by (IEC 60034-1:2022, table of tolerances; 0.3 below 1 kW)
_BALANCED = 6  # steps of the iteration of speed and torque; each reduces the error by the slip


def slipped(rig: Rig, drive: Any, run: Run, knobs: Sequence[Knob]) -> tuple[float, float]:
    """Return the speed of a run over that of the field [1], and its standard deviation.

    The load of the slip follows from the rig; each of its uncertain numbers (``knobs``) moves it by its spread.
    """
    share = _share(rig, drive.name, run)
    moved = list[float]()
    for knob in knobs:
        try:
            moved.append(_share(turned(rig, (knob,), np.ones(1)), drive.name, run) - share)
        except (TorquerigError, ValueError):
            continue
    tolerance = _TOLERANCE / sqrt(3) * (1 - share)
    return share, sqrt(tolerance**2 + sum(one**2 for one in moved))


def _share(rig: Rig, drive: str, run: Run) -> float:
    field, slip = run.speed or 0.0, 0.0
    if not field:
        return 1.0
    twin, part = Twin(rig.at(run)), rig.part(drive)
    for _ in range(_BALANCED):
        speed = np.array([field - slip])
        torque = float(quasi_static(twin, speed=speed, acceleration=np.zeros(1)).motor[0])
        slip = part.slip_speed(torque)  # type: ignore[attr-defined]
    return 1 - slip / field
