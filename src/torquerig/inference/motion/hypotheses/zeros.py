"""The zero of an incremental scale, which differs from run to run."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.hypotheses.shown import stroke
from torquerig.inference.motion.hypothesis import MECHANISM, Hypothesis

_SPREAD = 0.1  # of the stroke: standard deviation of the zero of a run


def propose(fit: Fit) -> Iterator[Hypothesis]:
    """Yield one zero of the position for each run, where the rig needs an effort that depends on the position."""
    if fit.model.zeros:
        return
    yield Hypothesis(
        name="position_zero", kind="position_zero", label="a zero of the position that differs from run to run",
        zeros=_SPREAD * stroke(fit), log_odds=MECHANISM, axis="position",
    )  # fmt: skip
