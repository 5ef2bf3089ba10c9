"""What the flights of a run tell of the gap: how many, how long, and how far the flanks moved."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flights import SHORTEST, flights
from torquerig.diagnosis.looking.observed import Observed
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_LONGEST = 0.95  # quantile of the distances: single ones are misjudged
_ARCMIN = pi / 180 / 60
_OF_ONE_BLOW = 1.2  # [1] of the logarithm of the energy: blows are unlike
_SPREADS = np.array([0.5, 0.3, 0.3, 0.5, 0.4, 0.4])  # of the logarithms, between two like runs


def flight_statistics(observed: Observed, rig: Rig) -> Floats:
    """Return the logarithms of number per second, length at two quantiles, and distance at three, shape (6,)."""
    found = flights(observed, rig)
    length = [(each.stop - each.start) / observed.rate for each in found]
    distance = [abs(each.distance) / _ARCMIN for each in found]
    number = len(found) / observed.recording.duration
    lengths = np.quantile([*length, SHORTEST], [0.5, 0.9])
    distances = np.quantile([*distance, 0.5], [0.5, 0.75, 0.9])
    return np.asarray(np.log(np.array([number + 0.1, *lengths, *(distances + 0.5)])))


def longest_flight(runs: Sequence[Observed], rig: Rig) -> float:
    """Return how far [rad] flanks were seen to move before they met: at most the gap, less chance in single flights."""
    every = [abs(flight.distance) for observed in runs for flight in flights(observed, rig)]
    return float(np.quantile(every, _LONGEST)) if every else np.inf


def flight_misfit(measured: Floats, model: Floats) -> Floats:
    """Return the residuals in units of how much two like runs differ, shape (6,)."""
    return np.asarray((measured - model) / _SPREADS)


def chance_of_blows(there: int, here: int) -> float:
    """Return what the numbers of blows in a run and in its simulations leave of its density's logarithm to chance."""
    return _OF_ONE_BLOW * float(np.sqrt(1 / (1 + there) + 1 / (1 + here)))


def chance_of_amplitudes(seen: Features) -> Floats | float:
    """Return what the blows of a run whose speed changes leave of the square of any amplitude to chance [(N m)^2].

    Half of the places of each stretch show more, shape (stretches, 1): when flanks meet is another matter in each run,
    and how hard one of the contact. Of a run at one speed, whose lines are told by all stretches together, 0.
    """
    if seen.observed.steady or not seen.amplitude.size:
        return 0.0
    shown = np.isfinite(seen.amplitude)
    squares = np.where(shown, np.abs(seen.amplitude) ** 2, np.nan)
    return np.array([[np.nanmedian(row)] if there.any() else [0.0] for row, there in zip(squares, shown, strict=True)])
