"""Tones of runs at one speed that pass for a comb of the shaft, until the shaft's own lines say how fast it turns.

Where nobody measured the angle it is followed by all lines that the kinematics know. Strong tones of fixed frequency
near such orders lead it astray: it turns so that they stand on whole orders, and lines of the shaft are smeared. Taken
off, they leave the shaft to its own lines, which then stand out further.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.order_or_fixed import ONE_SPEED
from torquerig.diagnosis.looking.peaks import LEADING, over_floor
from torquerig.diagnosis.looking.steady_tone import spectrum_of_seen
from torquerig.inference.places import Place, frequency
from torquerig.orders.angle.comb_score import comb_score, noise_floor_at, order_power
from torquerig.recordings.spectrum import between_bins

_LOWEST = 20.0  # [Hz] slower tones are the shaft's own business
_SAME = 0.35  # bins: so far a tone may seem to move from run to run
_OWN = 0.01  # [1/rev of the motor]: a tone so near to an order that the shaft has anyway tells nothing
_BESIDE = 0.015  # of its order, within which a tone spoils a line and its floor
# sum of logs: of 89 rigs at one speed, tones or not, none that has no such comb gained more than 7
_DECIDED = 30.0
_WIDTH = 2.0  # bins


def common_tones(runs: Sequence[Observed]) -> tuple[float, ...]:
    """Return the strong lines that stand at the same frequency [Hz] in all steady runs, where these have one speed.

    None where an angle was measured, or where there are fewer than two such runs: loads differ, and move a shaft's
    lines by more than a fraction of a bin.
    """
    steady = [run for run in runs if run.steady]
    speeds = [abs(run.mean_speed) for run in steady]
    if len(steady) < 2 or max(speeds) > (1 + ONE_SPEED) * min(speeds) or any(run.angle_measured for run in steady):
        return ()
    first, *others = [_strong(run) for run in steady]
    apart = _SAME * max(_bin(run) for run in steady)
    return tuple(tone for tone in first if all(any(abs(one - tone) < apart for one in other) for other in others))


def lead_astray(
    runs: Sequence[Observed], without: Sequence[Observed], tones: Sequence[float], orders: Sequence[float]
) -> bool:
    """Whether the shaft's own lines stand out clearly further along the angles that are followed ``without`` the tones.

    ``orders`` are those of the model's own lines [1/rev]. Lines near a tone are not asked; a tone that stands on one of
    them leaves it open.
    """
    gained = 0.0
    for run, other in zip(runs, without, strict=True):
        if not run.steady:
            continue
        at = np.array(tones) * 2 * pi / abs(other.mean_speed)
        away = np.abs(np.array(orders)[:, None] - at)
        if np.any(away < _OWN):
            return False
        asked = np.array(orders)[np.all(away > _BESIDE * at, axis=1)]
        part = slice(other.stretches[0].start, next((each.start for each in other.stretches if each.held), None))
        torque, (along, otherwise) = other.torque[part], (each.angle[part] for each in (run, other))
        power, per_bin = order_power(torque, otherwise - otherwise[0])
        floor = noise_floor_at(power, asked / per_bin, within=_BESIDE)
        gained += comb_score(torque, otherwise, asked, floor) - comb_score(torque, along, asked, floor)
    return gained > _DECIDED


def tone_of(runs: Sequence[Observed], place: Place) -> Place | None:
    """Return the tone that ``runs`` are known to have at a place, or a multiple of it; None where there is none."""
    for run in runs:
        at = place.frequency(run.mean_speed)
        for tone in sorted(run.tones, reverse=True):  # the lowest multiple is known best
            multiple = round(at / tone)
            if multiple and abs(at - multiple * tone) < _WIDTH * _bin(run):
                return frequency(multiple * tone)
    return None


def _strong(run: Observed) -> list[float]:
    """Return the frequencies [Hz] of the strong lines of what fits may see of a run."""
    power, step = spectrum_of_seen(run)
    over = over_floor(power, below=1.0)
    at = np.flatnonzero(over > LEADING)
    tops = at[[over[one] == over[max(one - 2, 0) : one + 3].max() and one + 1 < power.size for one in at]]
    return [step * between_bins(power, int(one)) for one in tops if one * step > _LOWEST]


def _bin(run: Observed) -> float:
    """Width of a bin of what fits may see [Hz]."""
    return run.rate / sum(each.stop - each.start for each in run.stretches if not each.held)
