"""How sure a finding is: from what it gains, what it explains, and how far its rivals stay behind."""

from __future__ import annotations

from math import exp, log

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.convincing import share_of
from torquerig.diagnosis.choosing.explained import gained_at_its_places
from torquerig.diagnosis.choosing.revising import Accepted
from torquerig.diagnosis.choosing.trial import Trial

SEEN_IN_SAMPLES = 0.98  # of a fault that stands in the samples themselves, before any model
LEAST = 0.6  # below it neither of two names was right in 1200 blind trials, from 0.6 to 0.7 three of three
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


def confidence_of(final: Case, accepted: Accepted) -> float:
    """Return the probability that the name of an effect is right, beside the rivals that the final case lacks.

    What they explain elsewhere is no rivalry: another effect may be there as well. A rival that came near it while that
    other one was missing, and does not beside it, is none.
    """
    beside_others = 0.0 if accepted.again is None else _confidence(final, accepted.again)
    return max(_confidence(final, accepted), beside_others)


def _confidence(final: Case, accepted: Accepted) -> float:
    before, named = accepted.before.model.misfits, accepted.trial
    rival = max(
        (
            min(trial.gain, gained_at_its_places(before, named.model.misfits, trial.model.misfits) + _beside(trial))
            for trial in _others(final, accepted)
        ),
        default=0.0,
    )
    return confidence(gain=named.gain, share=share_of(accepted.before, named), rival=rival)


def rivals_of(final: Case, accepted: Accepted) -> dict[str, float]:
    """Return the best gain of every other mechanism that was tried when the effect was taken, best first."""
    others: dict[str, float] = {}
    for trial in _others(final, accepted):
        others.setdefault(trial.candidate.mechanism, trial.gain)
    return others


def _others(final: Case, accepted: Accepted) -> list[Trial]:
    own = accepted.trial.candidate.mechanism
    names = ((trial, trial.candidate.mechanism) for trial in accepted.tried.fitted)
    return [trial for trial, name in names if name != own and not final.has(name)]


def _beside(trial: Trial) -> float:
    """Return what a trial gains of what no feature holds."""
    before, after = trial.beside
    return before - after


def terms(*, gain: float, share: float, rival: float) -> tuple[float, float, float, float]:
    """Return what the coefficients belong to: 1, the gain's logarithm over 40, the share beyond half, the rival's."""
    behind = min(max(rival, 0.0) / max(gain, 1e-9), 2.0)
    return 1.0, log(max(gain, 1.0) / 40.0 + 1), share - 0.5, behind**4
