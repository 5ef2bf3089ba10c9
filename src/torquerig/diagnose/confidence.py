"""How sure a finding is: from what it gains, what it explains, and how far its rivals stay behind."""

from __future__ import annotations

from math import exp, log

# a logistic curve over three numbers; coefficients set by hand on a few dozen rigs, not yet fitted by `torquerig prove`
_OFFSET, _GAIN, _SHARE, _RIVAL = -2.2, 0.9, 4.0, -3.0


def confidence(*, gain: float, share: float, rival: float) -> float:
    """Return the probability that the name is right, at most 0.99.

    Parameters
    ----------
    gain : float
        What the misfit fell by, knobs paid.
    share : float
        Part of the misfit at its places that the effect explains [1].
    rival : float
        Gain of the best other mechanism.
    """
    behind = min(max(rival, 0.0) / max(gain, 1e-9), 2.0)
    score = _OFFSET + _GAIN * log(max(gain, 1.0) / 40.0 + 1) + _SHARE * (share - 0.5) + _RIVAL * behind**4
    return min(0.99, 1 / (1 + exp(-score)))
