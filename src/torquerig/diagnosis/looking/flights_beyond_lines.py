"""Flights that the run's own lines do not make: where waves meet they may rest near zero too, turn after turn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flights import blows, flights_counted, noise_of
from torquerig.diagnosis.looking.kept import kept
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves

_SAME = 4e-3  # [s] so near to a blow one that the lines make is the same
_AT_ONE_ANGLE = 1e-3  # [s] within which, turn after turn, a wave repeats; how flanks meet hangs on all that was before
_AGAIN, _MOSTLY = 3, 0.75  # blows at one angle, two may meet by chance; share of all blows, where flanks make others


@kept
def flights_beyond_lines(seen: Features) -> int:
    """Return how many flights a run shows, long ones counted twice, less those that its lines make without any gap.

    The lines are those of the whole run by least squares, in noise as the run has it. Real blows ring far above them,
    and come at other angles of the shaft in every turn. Where something slips and grips again none is counted: what it
    strikes without load is no larger than what flanks do.
    """
    if seen.observed.slipping:
        return 0
    shown, counted = blows(seen.untoned), flights_counted(seen.untoned)
    if not shown or not seen.observed.steady:
        return counted
    of_lines = np.array(blows(_lines_alone(seen)))
    near = _SAME * seen.observed.rate
    again = _at_one_angle(seen.untoned, np.array(shown))
    made = [(np.abs(of_lines - at) < near).any() for at in shown]
    real = [at for at, by_lines, often in zip(shown, made, again, strict=True) if not (by_lines or often)]
    return round(counted * len(real) / len(shown))


def _at_one_angle(observed: Observed, blows: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Return which blows come at one angle of the output shaft, in one turn after another; none where few do."""
    ratio = abs(observed.run.gear_ratio or 1.0)
    turns = observed.angle[blows] / (2 * np.pi * ratio)
    apart = turns[:, None] - turns[None, :]
    alike = np.abs(apart - np.round(apart)) < _AT_ONE_ANGLE * np.abs(observed.speed[blows]) / (2 * np.pi * ratio)
    again = np.asarray(alike.sum(axis=1) >= _AGAIN)
    return again if again.mean() >= _MOSTLY else np.zeros(again.size, dtype=bool)


def _lines_alone(seen: Features) -> Observed:
    observed = seen.untoned
    turning = [place for place in seen.places if place.domain == "order"]
    time = np.arange(observed.torque.size) / observed.rate
    fitted = regressed(observed.torque, Waves(turning, observed.angle, time))
    noise = noise_of(observed) * np.random.default_rng(0).standard_normal(observed.torque.size)
    return replace(observed, torque=observed.torque - fitted.rest + noise)
