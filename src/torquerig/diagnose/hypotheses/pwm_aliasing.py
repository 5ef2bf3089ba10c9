"""A tone of fixed frequency above what the shafts pass on: switching, folded by the sampling."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.knobs import Knob
from torquerig.diagnose.transfer import GRID
from torquerig.diagnose.twin import Twin

_PASSED = 0.02  # share of a torque on the loaded side that still reaches the reading
_STRONGEST = 3
_START = 2e-3  # [V]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a tone for each of the strongest fixed lines above the mechanical range."""
    top = mechanical_range(case)
    lines = [peak for peak in case.left if peak.place.domain == "frequency" and peak.place.at > top]
    for peak in lines[:_STRONGEST]:
        part = mechanisms.PwmAliasing(name="pwm_aliasing", frequency=peak.place.at, amplitude=_START)
        yield Candidate(
            mechanism="pwm_aliasing",
            parts=(part,),
            knobs=(Knob(part.name, "amplitude", 1.5),),
            place=peak.place,
        )


def mechanical_range(case: Case) -> float:
    """Return the frequency [Hz] above which the shafts pass less than a fiftieth of any torque to the reading."""
    twin = Twin(case.model.rig)
    passed = np.max([np.abs(twin.torque_on(node)(GRID)) for node in twin.turns], axis=0)
    above = np.flatnonzero(passed > _PASSED)
    return float(GRID[above[-1]]) if above.size else 0.0
