"""At which share of the speed of its field an induction motor should turn, and how well that is known."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

import numpy as np

from torquerig.errors import TorquerigError
from torquerig.inference.knobs import Knob, turned
from torquerig.linear_twin.field_speed import share_of_field
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig

_TOLERANCE = 0.2  # of the slip: what a maker may be off by (IEC 60034-1:2022, table of tolerances; 0.3 below 1 kW)


def slipped(rig: Rig, run: Run, knobs: Sequence[Knob]) -> tuple[float, float]:
    """Return the speed of a run over that of the field [1], and its standard deviation.

    The load of the slip follows from the rig; each of its uncertain numbers (``knobs``) moves it by its spread.
    """
    share = share_of_field(rig, run)
    moved = list[float]()
    for knob in knobs:
        try:
            moved.append(share_of_field(turned(rig, (knob,), np.ones(1)), run) - share)
        except (TorquerigError, ValueError):
            continue
    tolerance = _TOLERANCE / sqrt(3) * (1 - share)
    return share, sqrt(tolerance**2 + sum(one**2 for one in moved))
