"""At which frequency a tone stands, by all runs that show it apart from the shaft's lines.

The frequency that maximises the sum of the runs' periodograms is the most likely one in white noise (Rife and Boorstyn
1974, IEEE Trans. Inf. Theory 20); a bin's width is 1 / T, and a clear tone is told to a small part of that.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

_WITHIN = 0.5  # bins to either side of where it was seen
_APART = 4.0  # bins from the next line of the shaft: under a Hann window nothing of it is left there
_BLOCKS = 64
_STEPS = 401


def told_frequency(at: float, runs: Sequence[Observed], known: Sequence[Place]) -> float:
    """Return the frequency [Hz] of a tone near ``at``; ``at`` itself where a line of the shaft is near in all runs.

    Parameters
    ----------
    at : float
        Where a peak was seen [Hz].
    runs : sequence of Observed
        Steady runs that show it.
    known : sequence of Place
        Of other lines.
    """
    shown = [run for run in runs if _alone(at, run, known)]
    if not shown:
        return at
    reach = _WITHIN / max(_seconds(run) for run in shown)
    offsets = np.linspace(-reach, reach, _STEPS)
    total = np.sum([_periodogram(at, run, offsets) for run in shown], axis=0)
    top = int(np.argmax(total))
    if not 0 < top < offsets.size - 1:
        return at
    before, middle, after = total[top - 1 : top + 2]
    curve = before - 2 * middle + after
    return at + float(offsets[top] + (0.5 * (before - after) / curve if curve < 0 else 0.0) * (offsets[1] - offsets[0]))


def _seconds(run: Observed) -> float:
    return float((run.seen.stop - run.seen.start) / run.rate)


def _alone(at: float, run: Observed, known: Sequence[Place]) -> bool:
    speed, least = abs(run.mean_speed), _APART / _seconds(run) + run.smearing * at
    return all(abs(place.frequency(speed) - at) > least for place in known if place.domain == "order")


def _periodogram(at: float, run: Observed, offsets: Floats) -> Floats:
    """Return the power at each offset [Hz], by the signal turned back by ``at`` and summed over blocks."""
    torque = run.torque[run.seen]
    size = torque.size // _BLOCKS * _BLOCKS
    torque = torque[:size]
    turned = (torque - torque.mean()) * np.hanning(size) * np.exp(-2j * pi * at / run.rate * np.arange(size))
    blocks = turned.reshape(_BLOCKS, -1).sum(axis=1)
    middle = (np.arange(_BLOCKS) + 0.5) * (size / _BLOCKS / run.rate)
    return np.asarray(np.abs(np.exp(-2j * pi * np.outer(offsets, middle)) @ blocks) ** 2)
