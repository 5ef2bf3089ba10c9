"""Moments without signal, filled with what the lines of the shaft would have read there.

A straight line across them breaks every line twice, and the corners ring through the bands of a quiet run.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.stretch_lines import shown_places
from torquerig.diagnosis.looking.turning import turns_back
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import Place
from torquerig.recordings.repair.moments import Moments


def refilled(observed: Observed, lost: Moments, places: Sequence[Place]) -> Observed:
    """Return the run with its lost moments filled: lines as in the rest of each stretch, a straight line beside them.

    Parameters
    ----------
    observed : Observed
        Whose torque stands still, or is bridged, in the lost moments.
    lost : sequence of (int, int)
        First sample and one past the last of each.
    places : sequence of Place
        The lines that the run may have.
    """
    if not lost or turns_back(observed):
        return observed
    there = np.ones(observed.torque.size)
    for start, stop in lost:
        there[start:stop] = 0.0
    torque = observed.torque.copy()
    for stretch in observed.stretches:
        part = slice(stretch.start, stretch.stop)
        if there[part].all() or not there[part].any():
            continue
        shown = [places[index] for index in shown_places(observed, stretch, places)]
        own = Waves(shown, observed.angle[part], np.arange(stretch.start, stretch.stop) / observed.rate)
        found = regressed(torque[part], own, window=there[part])
        rest, known = found.rest, there[part] > 0
        at = np.arange(rest.size)
        bridged = np.interp(at, at[known], rest[known])
        torque[part] = np.where(known, torque[part], torque[part] - rest + bridged)
    return replace(observed, torque=torque)
