"""Play between what is moved and what it moves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.moved import Moved
from torquerig.inference.knobs import Knob
from torquerig.rig.parts import Gear, Link

_GAPS = (0.01, 0.04, 0.12)  # of the stroke


def propose(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    """Yield gaps of three sizes in each gear and link that has none."""
    if not hasattr(mechanisms, "Backlash") or model.rig.of_kind("backlash"):
        return
    stroke = max(float(np.ptp(run.position)) for run in runs)
    for joint in model.rig.parts:
        if not isinstance(joint, Gear | Link):
            continue
        ratio = abs(joint.ratio) if isinstance(joint, Gear) else 1.0
        for share in _GAPS:
            part = mechanisms.Backlash(name="backlash", gear=joint.name, gap=share * stroke / ratio)
            yield Candidate(mechanism="backlash", parts=(part,), knobs=(Knob(part.name, "gap", 0.5),))
