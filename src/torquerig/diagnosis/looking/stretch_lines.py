"""The lines of one stretch of a run: which of them it can show, how large they are, and what is left beside them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.leakage import leaked
from torquerig.diagnosis.looking.observed import Observed, Stretch
from torquerig.diagnosis.looking.smeared import WIDE, gathered
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import RESOLVED, RESOLVED_WELL, Place

Floats = NDArray[np.float64]

_FEWEST_TURNS = 0.9  # periods of a line within a stretch
_HIGHEST = {"order": 0.4, "frequency": 0.48}  # of the sample rate: what turns is smeared, and may fold
_CROSSING_POINTS, _LIKE = 512, 0.5  # correlation of two lines below which a regression tells them apart


@dataclass(frozen=True)
class StretchLines:
    """Lines of one stretch; ``amplitude``, ``widening``, ``reach`` and ``beneath`` as in ``Features``, for each place.

    Parameters
    ----------
    slow : ndarray, shape (samples,)
        Torque without the lines [N m].
    rest : ndarray, shape (samples,)
        What a straight line leaves of it [N m].
    at : list of float
        Where the lines stand that the stretch shows [Hz].
    """

    amplitude: NDArray[np.complex128]
    widening: Floats
    reach: Floats
    beneath: Floats
    slow: Floats
    rest: Floats
    at: list[float]


def stretch_lines(observed: Observed, stretch: Stretch, places: Sequence[Place]) -> StretchLines:
    """Return the lines by one regression; those that an unmeasured angle smears, by the power that they spread over."""
    part = slice(stretch.start, stretch.stop)
    time = np.arange(stretch.start, stretch.stop) / observed.rate
    shown = shown_places(observed, stretch, places)
    window = np.hanning(time.size) if observed.steady else None
    found = regressed(
        observed.torque[part], Waves([places[index] for index in shown], observed.angle[part], time), window=window
    )
    amplitude = np.full(len(places), np.nan, dtype=complex)
    amplitude[shown] = found.amplitude
    widening = np.ones(len(places))
    widening[shown] = found.widening
    reach, beneath = np.full(len(places), resolved_bins(observed)), np.zeros(len(places))
    mean = float(np.abs(observed.speed[part]).mean())
    lines = [places[index].frequency(mean) for index in shown]
    if not observed.steady:
        slowest, fastest = float(np.abs(observed.speed[part]).min()), float(np.abs(observed.speed[part]).max())
        swept = [(places[index].frequency(slowest), places[index].frequency(fastest)) for index in shown]
        beneath[shown] = leaked(found.rest, observed.rate, swept)
    if observed.steady and observed.smearing:
        wide = WIDE / observed.smearing * observed.rate / time.size
        turning = [r for r, index in enumerate(shown) if places[index].domain == "order" and lines[r] > wide]
        fixed = [r for r, index in enumerate(shown) if places[index].domain == "frequency"]
        tones = Waves([places[shown[r]] for r in fixed], observed.angle[part], time)
        others = observed.torque[part] - tones.summed(found.amplitude[fixed])
        found_lines = gathered(others, observed.rate, [lines[r] for r in turning], smeared=observed.smearing)
        for row, each in zip(turning, found_lines, strict=True):
            at = shown[row]
            amplitude[at], widening[at] = each.amplitude, each.widening
            reach[at], beneath[at] = each.reach, each.floor
    hidden = _hidden(observed, stretch, places, shown)
    if hidden:
        beside = Waves([places[index] for index in (*shown, *hidden)], observed.angle[part], time)
        found = regressed(observed.torque[part], beside, window=window)
    slow = found.rest + found.level + found.slope * np.linspace(-1.0, 1.0, time.size)
    return StretchLines(amplitude, widening, reach, beneath, slow, found.rest, lines)


def _hidden(observed: Observed, stretch: Stretch, places: Sequence[Place], shown: Sequence[int]) -> list[int]:
    """Return which fixed frequencies of a steady stretch lie within the reach of an order that it shows.

    No amplitude can be told of them, but they are in the torque: as the speed wanders, the order's line takes up a part
    of such a tone and leaves the rest beside it.
    """
    if not observed.steady:
        return []
    tones = [index for index, place in enumerate(places) if place.domain == "frequency"]
    tones.sort(key=lambda index: index not in shown)  # beside a tone that is shown there is no other
    without_orders = shown_places(observed, stretch, [places[index] for index in tones])
    return [tones[row] for row in without_orders if tones[row] not in shown]


def shown_places(
    observed: Observed, stretch: Stretch, places: Sequence[Place], *, apart: float | None = None
) -> list[int]:
    """Return which places the stretch can show: turning often enough, below half the rate, apart from each other.

    ``apart`` is by how many bins, else by so many as the run resolves.
    """
    apart = resolved_bins(observed) if apart is None else apart
    speeds = np.abs(observed.speed[stretch.start : stretch.stop])
    duration = (stretch.stop - stretch.start) / observed.rate
    mean, top = float(speeds.mean()), float(speeds.max())
    shown: list[int] = []
    for index, place in enumerate(places):
        at = place.frequency(mean)
        turning = at * duration >= _FEWEST_TURNS and place.frequency(top) < _HIGHEST[place.domain] * observed.rate
        near = (places[other] for other in shown if abs(at - places[other].frequency(mean)) * duration < apart)
        if turning and all(_crossing(observed, stretch, place, other) for other in near):
            shown.append(index)
    return shown


def resolved_bins(observed: Observed) -> float:
    """Return the bins of a stretch that two lines must stand apart to be two."""
    return RESOLVED_WELL if observed.steady and not observed.angle_measured else RESOLVED


def _crossing(observed: Observed, stretch: Stretch, place: Place, other: Place) -> bool:
    """Whether an order sweeps across a fixed frequency in the stretch so fast that both can be told apart."""
    if observed.steady or place.domain == other.domain:
        return False
    samples = np.linspace(stretch.start, stretch.stop - 1, _CROSSING_POINTS).astype(int)
    angle, time = observed.angle[samples], samples / observed.rate
    apart = place.phase(angle, time) - other.phase(angle, time)
    return bool(abs(np.exp(1j * apart).mean()) < _LIKE)
