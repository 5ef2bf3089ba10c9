"""Runs under measured motion beside both models: measured effort and what each foretells for the same motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig import units
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.lines import in_a_line
from torquerig.diagnosis.motion.moved import Moved

Floats = NDArray[np.float64]

_OF_THE_SPEED = ("stribeck_friction", "quadratic_drag")


@dataclass(frozen=True, kw_only=True)
class Scale:
    """In what units a rig is shown: names, and by what SI values are divided to come into them.

    ``called`` says what units are called that parts declare for shafts and sensors in volts.
    """

    effort: str
    place: str
    speed: str
    lines: str
    place_unit: float
    speed_unit: float
    called: Mapping[str, str]


IN_A_LINE = Scale(
    effort="N", place="m", speed="m/s", lines="cycles/m", place_unit=1.0, speed_unit=1.0,
    called={"V": "N", **units.IN_A_LINE},
)  # fmt: skip
TURNING = Scale(
    effort="N m", place="turns", speed="rpm", lines="cycles/turn", place_unit=2 * pi, speed_unit=pi / 30,
    called={"V": "N*m"},
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class MotionCompared:
    """One run of which something was held out; ``after`` is ``before`` itself where nothing was found.

    Parameters
    ----------
    run : Moved
    before, after : ndarray, shape (samples,)
        The effort that the calibrated and the completed model take for the run's motion [N m] or [N].
    """

    run: Moved
    before: Floats
    after: Floats

    @property
    def alone(self) -> bool:
        """Whether there is one model only."""
        return self.after is self.before

    @property
    def effort_rms(self) -> float:
        """Rms of the measured effort, held out [N m] or [N]."""
        return root_mean_square([self.run.effort[self.run.held]])

    def left(self, model: Floats) -> float:
        """Return the rms of what a model leaves of the held-out effort [N m] or [N]."""
        return root_mean_square([(self.run.effort - model)[self.run.held]])

    def error(self, model: Floats) -> float:
        """Return the share of the held-out effort that a model leaves [1]."""
        return self.left(model) / max(self.effort_rms, 1e-300)

    @property
    def gained(self) -> float:
        """By how much the error falls [1]."""
        return self.error(self.before) - self.error(self.after)


def motion_compared(outcome: MotionOutcome) -> tuple[MotionCompared, ...]:
    """Return every run that has held-out samples, beside both models; one model alone where nothing was found."""
    answer = []
    for run, first, second in zip(outcome.runs, outcome.before.residuals, outcome.after.residuals, strict=True):
        before = run.effort - first
        after = run.effort - second if outcome.steps else before
        if run.held.any():
            answer.append(MotionCompared(run, before, after))
    return tuple(answer)


def most_gained(runs: Sequence[MotionCompared]) -> MotionCompared:
    """Return the run that shows most of what was found."""
    return max(runs, key=lambda one: one.gained)


def scale_of(outcome: MotionOutcome) -> Scale:
    """Return the units in which a rig is shown."""
    return IN_A_LINE if in_a_line(outcome.runs) else TURNING


def speed_matters(outcome: MotionOutcome) -> bool:
    """Whether something that was found, or is wrong, goes with the speed."""
    found = any(each.mechanism in _OF_THE_SPEED for each in outcome.diagnosis.findings)
    return found or any(each.domain == "speed" for each in (*outcome.missed, *outcome.left))
