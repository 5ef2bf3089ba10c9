"""What a model leaves that is too large for random errors."""

from __future__ import annotations

from torquerig.inference.adequacy import LEVEL_OF_TEST, Excess, excesses
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Fit, all_residuals


def significant(outcome: Outcome, fit: Fit) -> tuple[Excess, ...]:
    """Return the statistics of the fitted data that fail the test of adequacy under a model, the least likely first."""
    found = excesses(all_residuals(outcome.data, fit.expected, fit.gains, fit.off))
    return tuple(each for each in found if each.p_value < LEVEL_OF_TEST)
