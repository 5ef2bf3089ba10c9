"""Flights that the run's own lines do not make: where waves meet they may rest near zero too, turn after turn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.looking.flights import blows, flights_counted, noise_of
from torquerig.diagnose.looking.kept import kept
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.regression import regressed
from torquerig.diagnose.looking.waves import Waves

_SAME = 4e-3  # [s] so near to a blow one that the lines make is the same


@kept
def flights_beyond_lines(seen: Features) -> int:
    """Return how many flights a run shows, long ones counted twice, less those that its lines make without any gap.

    The lines are those of the whole run by least squares, in noise as the run has it. Real blows ring far above them.
    """
    shown, counted = blows(seen.untoned), flights_counted(seen.untoned)
    if not shown or not seen.observed.steady:
        return counted
    of_lines = np.array(blows(_lines_alone(seen)))
    near = _SAME * seen.observed.rate
    real = [at for at in shown if not (np.abs(of_lines - at) < near).any()]
    return round(counted * len(real) / len(shown))


def _lines_alone(seen: Features) -> Observed:
    observed = seen.untoned
    turning = [place for place in seen.places if place.domain == "order"]
    time = np.arange(observed.torque.size) / observed.rate
    fitted = regressed(observed.torque, Waves(turning, observed.angle, time))
    noise = noise_of(observed) * np.random.default_rng(0).standard_normal(observed.torque.size)
    return replace(observed, torque=observed.torque - fitted.rest + noise)
