"""A friction that the scenario states without a peak holds more than it slides: what is added at standstill."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.friction import FALLS, HOLDS, PEAKED, STOOD_IN
from torquerig.diagnosis.motion.moved import Moved
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.terms import Friction

_NONE = 1.02  # times what slides: a static friction up to here is no peak


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield the peak beside the one dry friction that the rig states without; it slides for nothing of its own.

    The friction that slides may have stood in for it, and gives way. Behind a spring a peak is not told from how a
    contact passes through standstill, which no model knows.
    """
    imposed = imposed_part(model.rig)
    stated = model.rig.of_kind("stribeck_friction")
    if len(stated) != 1 or not hasattr(mechanisms, "StribeckFriction"):
        return
    part = stated[0]
    if part.static > _NONE * part.coulomb or (part.static_backward or 0.0) > _NONE * (part.coulomb_backward or 0.0):
        return
    if imposed is None or model.rig.node(part.at) != model.rig.node(imposed.at):
        return
    top = max(float(np.abs(run.speed).max()) for run in runs)
    peak = mechanisms.StribeckFriction(
        name="friction_peak", at=part.at, coulomb=0.0, static=(HOLDS - 1) * part.coulomb, stribeck_speed=FALLS * top,
        smoothing=part.smoothing,
    )  # fmt: skip
    knobs = tuple(Knob(peak.name, field, 1.0) for field in ("static", "stribeck_speed"))
    yield Candidate(mechanism="stribeck_friction", parts=(peak,), knobs=knobs, variant=PEAKED, loosens=STOOD_IN)


def dry_beside(rig: Rig, part: Any) -> tuple[float, float]:
    """Return what slides dry on the shaft of ``part`` beside it, forward and backward [N m] or [N]."""
    node = rig.node(part.at)
    others = [t for t in rig.terms() if isinstance(t, Friction) and t.on == node and t.name != part.name]
    return sum(t.coulomb_forward for t in others), sum(t.coulomb_backward for t in others)
