"""A reading that stops at a limit: the samples propose the level, the likelihood compares what the motion needs there.

With the limit L the effort is read as ``min(max(N, -L), L)``. A drive that gives no more than its limit moves the rig
with just that: N stays within L, and the limit gains nothing. Source: signatures.md 6.9. Not true where noise is as
large as what the limit takes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from torquerig import mechanisms
from torquerig.inference.knobs import Knob
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypothesis import MECHANISM, Hypothesis
from torquerig.recordings.recording import Channel
from torquerig.recordings.repair.flat_tops import flat_tops

_SPREAD = 1e-3  # of the level: its samples show it to a code
_CODE = 1e-6  # of the largest effort: values that differ by less are equal, whatever the digits of the file


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield the limit that the samples of the runs show, where neither rig nor model has one."""
    if not hasattr(mechanisms, "Clipping") or fit.model.rig.of_kind("clipping"):
        return
    read = [
        replace(run.recording, channels={"effort": Channel(values=run.effort, quantity="torque", unit="N*m")})
        for run in fit.runs
    ]
    largest = max(float(np.abs(run.effort).max()) for run in fit.runs)
    found = flat_tops(read, full_range=np.inf, code=_CODE * largest)
    if found is not None:
        yield Hypothesis(
            name="clipping", mechanism="clipping", label=f"a reading that stops at {found.limit:.4g}",
            parts=(mechanisms.Clipping(name="clipping", limit=found.limit),),
            knobs=(Knob("clipping", "limit", _SPREAD),), start=(0.0,), log_odds=MECHANISM,
        )  # fmt: skip
