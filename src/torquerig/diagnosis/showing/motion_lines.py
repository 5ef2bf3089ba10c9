"""Lines in what both models leave of the held-out effort, over the place and in frequency."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.lines import Line, amplitudes, lines_and_rest

Floats = NDArray[np.float64]

DOMAINS = ("order", "frequency")


@dataclass(frozen=True, eq=False)
class LinesLeft:
    """What one model leaves in one domain: its significant lines, and the spectrum beside them.

    Parameters
    ----------
    lines : tuple of Line
        Strongest first.
    places : ndarray, shape (places,)
        [1/rev] or [cycles/m]; [Hz].
    rest : ndarray, shape (places,)
        Amplitudes, zero to peak, with the lines taken out [N m] or [N].
    """

    lines: tuple[Line, ...]
    places: Floats
    rest: Floats


@dataclass(frozen=True, eq=False)
class LinesCompared:
    """Both models in one domain; ``after`` is ``before`` itself where nothing was found."""

    domain: str
    before: LinesLeft
    after: LinesLeft


def lines_compared(outcome: MotionOutcome) -> tuple[LinesCompared, ...]:
    """Return the domains in which enough places are resolved; none where hardly anything moves evenly.

    Lines are taken out one by one, for the gaps between held-out stretches copy each to its sides.
    """
    before = _left(outcome.before.residuals, outcome)
    after = _left(outcome.after.residuals, outcome) if outcome.steps else before
    return tuple(
        LinesCompared(domain, first, second)
        for domain, first, second in zip(DOMAINS, before, after, strict=True)
        if first.rest.any()
    )


def _left(residuals: tuple[Floats, ...], outcome: MotionOutcome) -> tuple[LinesLeft, ...]:
    lines, rest = lines_and_rest(residuals, outcome.runs, held=True)
    return tuple(
        LinesLeft(tuple(line for line in lines if line.domain == domain), *amplitudes(rest, domain))
        for domain in DOMAINS
    )
