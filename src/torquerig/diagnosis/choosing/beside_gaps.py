"""A gap and other effects: what is no detail of a gap, and what is more likely than one that chatter alone tells."""

from __future__ import annotations

from collections.abc import Iterable

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.opened_gap import GAP, flanks_fly, flanks_may_part
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.misfit import Misfit, robust_squares


def gained_by_closed_lines(case: Case, trial: Trial) -> float:
    """Return what the lines of runs in which no flanks part are missed by less: a gap changes nothing there.

    0 of what makes no line of its own, with which other numbers of the model may come back.
    """
    if trial.candidate.place is None:
        return 0.0
    runs = zip(case.from_zero, case.model.misfits, trial.model.misfits, strict=True)
    return sum(_missed(before) - _missed(after) for seen, before, after in runs if not flanks_may_part(seen))


def chatter_outdone(case: Case, trial: Trial, fitted: Iterable[Trial]) -> bool:
    """Whether it is a gap that chatter alone tells while another effect gains more, which may be what chatters."""
    if trial.candidate.mechanism != GAP or flanks_fly(case):
        return False
    return any(each.gain > trial.gain for each in fitted if each.candidate.mechanism != GAP)


def _missed(misfit: Misfit) -> float:
    return float(robust_squares(misfit.lines.ravel()).sum())
