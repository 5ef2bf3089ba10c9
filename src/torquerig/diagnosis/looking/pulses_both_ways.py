"""In how many pulses a turn a load comes, by a run that turns back: they oppose the motion whichever way it goes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.looking.turning import orthonormal, turning, turns_back, waves_in_blocks
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.inference.places import SAME_ORDER, Place, order

Floats = NDArray[np.float64]

_FEWEST, _MOST = 2, 12  # pulses a turn; one is an unbalanced bed's
_CLEAR, _NEXT = 25.0, 2.0  # F of two columns, 8 at most where a load has none; times that of any other number
_FREE = 100  # blocks at least beside what lines and the slow torque can do
_HARMONICS = (1, 2)  # that such a run shows


def pulses_both_ways(run: Observed, known: Sequence[Place], *, turns: float) -> tuple[int, float]:
    """Return the whole number of pulses a turn with which the torque swings, and its F; (0, 0) where none stands out.

    The F statistic is of a cosine and a sine times the sign of the speed, beside all that lines of any phase, a level
    either way and what grows with the speed can do.

    Parameters
    ----------
    run : Observed
    known : sequence of Place
        Of its lines.
    turns : float
        Of the shaft that is loaded, per turn of the motor.
    """
    if not turns_back(run):
        return 0, 0.0
    run = without_tones(run, known)
    blocks = turning(run, (), held=False)
    lines = waves_in_blocks(run, blocks.start, [place.at for place in known if place.domain == "order"])
    way = np.sign(blocks.speed)
    beside = orthonormal(np.column_stack([lines, np.ones(way.size), way, blocks.speed, np.abs(blocks.speed)]))
    free = way.size - beside.shape[1] - 2
    if free < _FREE:
        return 0, 0.0
    rest, scores = blocks.torque - beside @ (beside.T @ blocks.torque), np.zeros(_MOST + 1)
    for pulses in range(1, _MOST + 1):
        wave = waves_in_blocks(run, blocks.start, [pulses * turns], both_ways=True)
        taken = orthonormal(wave - beside @ (beside.T @ wave)).T @ rest
        scores[pulses] = (taken @ taken) / 2 * free / (rest @ rest - taken @ taken)
    best = int(np.argmax(scores))
    clear = scores[best] > max(_CLEAR, _NEXT * float(np.delete(scores, best).max()))
    return (best, float(scores[best])) if clear and best >= _FEWEST else (0, 0.0)


def lines_of_pulses(runs: Sequence[Observed], known: Sequence[Place], *, turns: float) -> list[Peak]:
    """Return the lines that such pulses have beside the known ones, which steady runs need not show."""
    found: list[Peak] = []
    for run in runs:
        pulses, clear = pulses_both_ways(run, known, turns=turns)
        for place in [order(times * pulses * turns) for times in _HARMONICS] if pulses else []:
            others = [other.at for other in (*known, *(peak.place for peak in found)) if other.domain == "order"]
            if all(abs(place.at - other) > SAME_ORDER for other in others):
                found.append(Peak(place, clear, (run.name,), speeds=1))
    return found
