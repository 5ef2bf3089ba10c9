"""Hypotheses that were fitted, those that were kept, and those that were refused."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion.fitted import FittedMotion


@dataclass(frozen=True, eq=False)
class Tried:
    """A hypothesis fitted together with all numbers of the model.

    Parameters
    ----------
    gain : float
        See ``evidence.gained``.
    fall : float
        By how much of itself the rms residual fell [1].
    freed : bool
        Whether all numbers of the model were fitted beside its own: only such a fit can be kept.
    beside : str
        The effect that it was weighed beside, where alone it gains too little.
    """

    candidate: Candidate
    model: FittedMotion
    gain: float
    fall: float
    freed: bool = False
    beside: str = ""


@dataclass(frozen=True, eq=False)
class Step:
    """A hypothesis that was kept, and all that were tried in its place."""

    kept: Tried
    before: FittedMotion
    tried: tuple[Tried, ...]


@dataclass(frozen=True, eq=False)
class Refused:
    """A hypothesis that was not kept beside the findings, and why."""

    tried: Tried
    why: str
