"""A finding under measured motion and all that was tried in its place, with what each leaves of held-out data."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.told import relative_error
from torquerig.diagnosis.motion.tried import Step


@dataclass(frozen=True, kw_only=True)
class Score:
    """One hypothesis of a step.

    Parameters
    ----------
    mechanism, variant : str
    gain : float
        Twice the growth of the log likelihood, numbers paid for.
    fall : float
        By how much of itself the rms residual fell where fits looked [1].
    held_out : float
        Rms of what it leaves of the held-out effort, over that effort [1].
    named : bool
    """

    mechanism: str
    variant: str
    gain: float
    fall: float
    held_out: float
    named: bool


def scores(step: Step, outcome: MotionOutcome) -> tuple[Score, ...]:
    """Return the hypotheses of a step, the one that was named first, then best first."""
    return tuple(sorted(_scores(step, outcome), key=lambda one: (not one.named, -one.gain)))


def without(step: Step, outcome: MotionOutcome) -> float:
    """Return the held-out error of the model that a step set out from [1]."""
    return relative_error(step.before, outcome.runs)


def _scores(step: Step, outcome: MotionOutcome) -> Iterator[Score]:
    for one in step.tried:
        yield Score(
            mechanism=one.candidate.mechanism, variant=one.candidate.variant, gain=one.gain, fall=one.fall,
            held_out=relative_error(one.model, outcome.runs), named=one is step.kept,
        )  # fmt: skip
