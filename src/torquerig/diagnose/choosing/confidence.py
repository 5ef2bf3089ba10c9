"""How sure a finding is: from what it gains, what it explains, and how far its rivals stay behind."""

from __future__ import annotations

from math import exp, log

# of a logistic curve over `terms`; made by `python -m proof.confidence_fit` on blind trials of the seeds 21 to 23
COEFFICIENTS = (1.23, 0.37, 1.67, -2.18)


def confidence(*, gain: float, share: float, rival: float) -> float:
    """Return the probability that the name is right, at most 0.99.

    Parameters
    ----------
    gain : float
        What the misfit fell by, knobs paid.
    share : float
        Part of the misfit at its places that the effect explains [1].
    rival : float
        Gain of the best other mechanism, or of what describes the mismatch without a name.
    """
    values = terms(gain=gain, share=share, rival=rival)
    score = sum(each * value for each, value in zip(COEFFICIENTS, values, strict=True))
    return min(0.99, 1 / (1 + exp(-score)))


def terms(*, gain: float, share: float, rival: float) -> tuple[float, float, float, float]:
    """Return what the coefficients belong to: 1, the gain's logarithm over 40, the share beyond half, the rival's."""
    behind = min(max(rival, 0.0) / max(gain, 1e-9), 2.0)
    return 1.0, log(max(gain, 1.0) / 40.0 + 1), share - 0.5, behind**4
