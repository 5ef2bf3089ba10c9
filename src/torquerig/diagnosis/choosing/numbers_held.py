"""What was found, fitted beside the model's numbers as they stood before it: for where they should not have given way.

With all numbers free a fit may trade what two of them do against each other; what no fit has seen then gets worse
although the effect is there.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.trial import LEAST_GAIN
from torquerig.diagnosis.fitting.calibration import calibrated
from torquerig.inference.knobs import turned


def with_numbers_held(before: Case, found: Case) -> Case | None:
    """Return ``found`` with the numbers of ``before``, only those of the effects fitted; None where that gains little.

    The covariance stays that of the fit with all numbers free: none is better known for being held.
    """
    model = found.model
    known = {knob.name: float(at) for knob, at in zip(before.model.knobs, before.model.positions, strict=True)}
    own = np.array([knob.name not in known for knob in model.knobs], dtype=bool)
    rig = turned(found.nominal_with_accepted(), before.model.knobs, before.model.positions)
    knobs = [knob for knob, its in zip(model.knobs, own, strict=True) if its]
    fitted = calibrated(rig, found.seen, knobs, start=model.positions[own], corrections=model.corrections or None)
    positions = np.array([known.get(knob.name, 0.0) for knob in model.knobs])
    positions[own] = fitted.positions
    cost = fitted.cost + float(positions[~own] @ positions[~own])
    if before.model.cost - cost < LEAST_GAIN:
        return None
    return replace(found, model=replace(model, rig=fitted.rig, positions=positions, misfits=fitted.misfits, cost=cost))
