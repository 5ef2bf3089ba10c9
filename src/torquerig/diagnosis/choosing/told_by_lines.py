"""What lines at known orders tell of how a rig passes them: laws and noise look like a low-pass in a spectrum alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.explained import changes_places, explained_share
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.calibration import misfits_of
from torquerig.diagnosis.fitting.misfit import Misfit, robust_squares
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.looking.features import Features

# robust squares by which the lines of the runs must fall: of 150 blind rigs with nothing hidden, those beside the best
# low-pass fall by 2 at most, though the bands fall by as much as 40, and beside the best of 240 modes by 5
_FALL, _OF_SOUGHT = 8.0, 12.0
_SHARE = 0.6  # of its places, where any line falls clearly: what is missed there is little


def told_by_lines(case: Case, trial: Trial, held: Sequence[Features]) -> bool:
    """Whether the lines tell what noise and the laws of a load resemble in a spectrum: how the rig passes a frequency.

    The same sources pass it at several speeds, whatever shakes the rig beside them. It is asked where nothing stands
    out, and of a first effect: what stands out may be another, whose lines anything nearby takes up a little, as it
    does the rest of what was found before.

    Parameters
    ----------
    case : Case
        Before the trial.
    trial : Trial
    held : sequence of Features
        Of the stretches that no fit has seen.
    """
    fits = case.model.misfits, trial.model.misfits
    if not _tell(case, trial) or (changes_places(*fits) and explained_share(*fits) < _SHARE):
        return False
    again = _of_lines(misfits_of(case.model.rig, held)) - _of_lines(misfits_of(trial.model.rig, held))
    return again > 0


def spared(case: Case, trial: Trial) -> Trial:
    """Return the trial, which need not gain what it is spared where the lines of the fitted runs tell it."""
    return replace(trial, gain=trial.gain + trial.candidate.spared) if _tell(case, trial) else trial


def _tell(case: Case, trial: Trial) -> bool:
    if not trial.candidate.resembled or case.accepted or trial.model.corrections:
        return False
    enough = _fall(case, trial) > (_OF_SOUGHT if trial.candidate.spared else _FALL)
    return enough and not mismatches(case)


def _fall(case: Case, trial: Trial) -> float:
    return _of_lines(case.model.misfits) - _of_lines(trial.model.misfits)


def _of_lines(misfits: Sequence[Misfit]) -> float:
    return float(sum(robust_squares(each.lines.ravel()).sum() for each in misfits))
