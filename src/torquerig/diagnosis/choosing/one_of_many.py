"""A line of the shaft beside other lines of it that stay wrong, and by more: it may be one of theirs."""

from __future__ import annotations

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.misfit import robust_squares
from torquerig.diagnosis.judging.leftover import at_whole_order, mismatches, stands_at

_MANY = 3  # lines


def one_of_many(final: Case, trial: Trial) -> bool:
    """Whether several lines at whole orders of the motor stay, and miss more than the trial's line took away.

    What changes all lines of the rig at once (a shaft that hardens, a sensitivity that goes with the torque) is in no
    library, and each line alone looks like an effect that makes it. Counted is each line's largest residual alone.
    """
    place = trial.candidate.place
    if place is None or place.domain != "order":
        return False
    ratio = abs(final.nominal.run.gear_ratio or 1.0)
    others = [each for each in mismatches(final) if at_whole_order(each) and not stands_at(each, place, ratio)]
    missed = robust_squares(np.array([10 ** (each.excess_dB / 20) for each in others]))
    return len(others) >= _MANY and float(missed.sum()) > trial.gain
