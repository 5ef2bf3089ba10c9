"""Flat tops that noise rides on: an amplifier's rails cut the signal, and what comes behind them is noisy itself."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.runs import runs_of
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.flat_tops import FEWEST_FLAT, FLAT_SHARE, FlatTops
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_LOOKED_AT = 12.0  # spreads of the noise below the highest value, among which the pile is sought
_LEAST_NOISE = 1e-6  # of the range of values: less is the arithmetic's own
_MOST_NOISE = 0.02  # of the signal's span: else noise, or a tone that is taken for it, is most of the signal
_HALF, _BIN = 3.0, 0.5  # its half width, and the width of the bins, in such spreads
_OVER_BESIDE = 4.0  # samples of a pile over those just below, on twice its width: a sine's crest has 1.4 times as many
_BEYOND = 0.01  # of a pile, that may stand above it
_AT_ONCE, _OFTEN = 8, 4  # samples in a row on the pile, and how often it comes there: a level that is held comes once


def flat_under_noise(recordings: Sequence[Recording], *, full_range: float = float("inf")) -> FlatTops | None:
    """Return the level about which the largest values pile up as widely as the noise is; None where none do.

    The noise is told from second differences, which what the shafts do hardly reaches. What stops at ``full_range`` [V]
    stops in the converter, behind all noise.
    """
    found: dict[str, tuple[float, float]] = {}
    for recording in recordings:
        volts = recording.torque_values()
        noise = spread_about_zero(np.diff(volts, 2)) / np.sqrt(6)
        piles = [pile for sign in (1.0, -1.0) if (pile := _pile(sign * volts, noise)) is not None]
        piles = [pile for pile in piles if pile[0] < full_range - _HALF * noise]
        if piles:
            found[recording.name] = max(piles, key=lambda pile: pile[1])
    return FlatTops.of_runs(found) if found else None


def _pile(volts: Floats, noise: float) -> tuple[float, float] | None:
    """Return the level [V] about which the largest values pile up, and their share of all, else None."""
    highest = float(volts.max())
    if not _LEAST_NOISE < noise / max(float(np.ptp(volts)), np.finfo(float).tiny) < _MOST_NOISE or highest <= 0:
        return None
    counts, edges = np.histogram(volts, np.arange(highest - _LOOKED_AT * noise, highest + noise, _BIN * noise))
    level = float(edges[int(np.argmax(counts))]) + 0.5 * _BIN * noise
    near = np.abs(volts - level) < _HALF * noise
    level = float(np.mean(volts[near]))
    near = np.abs(volts - level) < _HALF * noise
    piled = int(near.sum())
    beside = int(((volts <= level - _HALF * noise) & (volts > level - 3 * _HALF * noise)).sum())
    beyond = int((volts > level + (_HALF + 1) * noise).sum())
    marks = near.astype(int) - (volts < level - 3 * _HALF * noise)
    rises = int(np.count_nonzero(np.diff(marks[marks != 0]) == 2))  # from well below up to the pile
    often = min(rises, sum(length >= _AT_ONCE for _, length in runs_of(near)))
    clear = piled > max(FEWEST_FLAT, FLAT_SHARE * volts.size, _OVER_BESIDE * beside)
    clear = clear and level > _LOOKED_AT * noise
    return (level, piled / volts.size) if clear and beyond < _BEYOND * piled and often >= _OFTEN else None
