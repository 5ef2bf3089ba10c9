"""What a model leaves that is too large for random errors."""

from __future__ import annotations

from torquerig.inference.adequacy import LEVEL_OF_TEST, Excess, JudgedRun, excesses_of
from torquerig.inference.answer.sizes import relevance
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Fit


def significant(
    outcome: Outcome, fit: Fit, *, any_size: bool = False
) -> tuple[tuple[Excess, ...], tuple[JudgedRun, ...]]:  # fmt: skip
    """Return the statistics that fail the test of adequacy under a model, the least likely first, and the runs.

    With ``any_size`` also what is too small to change the verdict.
    """
    least = 0.0 if any_size else relevance(outcome)
    found, runs = excesses_of(fit, outcome.data, outcome.held, relevance=least)
    return tuple(each for each in found if each.p_value < LEVEL_OF_TEST), runs
