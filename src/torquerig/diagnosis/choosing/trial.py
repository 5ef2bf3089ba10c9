"""A hypothesis fitted to what the model leaves, and what it must gain."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.fitting.calibration import Calibrated

PER_KNOB = 5.0  # what a further number must gain, beside the square of its own position
LEAST_GAIN = 40.0  # what an effect must gain to be called missing


@dataclass(frozen=True)
class Trial:
    """A candidate fitted together with all numbers of the model; ``gain`` is what the misfit fell by, knobs paid.

    ``beside`` is the misfit of what no twin expects, before and with it: how flanks fly across a gap. ``gap`` takes the
    place of one that was found earlier, where its width was told again around the candidate. ``alone`` is the share of
    its places that a line's candidate explained while all numbers of the model stood still; 0 where nobody asked.
    """

    candidate: Candidate
    model: Calibrated
    gain: float
    beside: tuple[float, float] = (0.0, 0.0)
    gap: Candidate | None = None
    alone: float = 0.0
