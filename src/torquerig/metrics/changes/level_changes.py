"""Changes of the mean torque, and of its rms in octave bands without the lines."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.metrics.changes.change import CONFIDENCE, FALSE_ALARMS, Change
from torquerig.metrics.changes.intervals import (
    band_square,
    difference_of_means,
    difference_of_roots,
    sure_difference_of_roots,
)

if TYPE_CHECKING:
    from torquerig.metrics.changes.segments import Segments

Floats = NDArray[np.float64]
_BESIDE = 3.0  # [bins] on each side of a line that belong to it (Hann window)
_LEAST = 0.3  # [1] share of a band's bins that must be left without lines


def mean_change(before: Floats, after: Floats) -> Change:
    """Return the change of the mean, from the means of the segments, shape (segments,)."""
    difference, low, high = difference_of_means(before, after, level=CONFIDENCE)
    _, seen_low, seen_high = difference_of_means(before, after, level=FALSE_ALARMS)
    return Change(
        kind="mean", at=0.0, until=0.0, cause="", before=float(before.mean()), after=float(after.mean()),
        difference=difference, low=low, high=high, seen_low=seen_low, seen_high=seen_high,
    )  # fmt: skip


def band_changes(before: Segments, after: Segments, lines: Sequence[float], *, highest: float) -> tuple[Change, ...]:
    """Return the change of the rms in each octave up to ``highest`` [Hz], without the bins of ``lines`` [Hz].

    Bins that hold a line in either recording are left out of both and the band is scaled to its whole width.
    """
    edges = [4 * max(before.bin, after.bin)]
    while 2 * edges[-1] <= highest:
        edges.append(2 * edges[-1])
    bands = list(pairwise(edges))
    powers = [[_powers(one, low, high, lines) for low, high in bands] for one in (before, after)]
    made = []
    for (low_edge, high_edge), first, second in zip(bands, powers[0], powers[1], strict=True):
        if first is None or second is None:
            continue
        squares = band_square(first), band_square(second)
        difference, low, high = sure_difference_of_roots(*squares, level=CONFIDENCE)
        _, seen_low, seen_high = difference_of_roots(*squares, level=FALSE_ALARMS / len(bands))
        made.append(
            Change(
                kind="band", at=low_edge, until=high_edge, cause="", before=squares[0].root(), after=squares[1].root(),
                difference=difference, low=low, high=high, seen_low=seen_low, seen_high=seen_high,
            )
        )  # fmt: skip
    return tuple(made)


def _powers(segments: Segments, low: float, high: float, lines: Sequence[float]) -> Floats | None:
    """Return the mean square in a band of each segment, shape (segments,); None where lines fill the band."""
    length = segments.values.shape[1]
    window = np.hanning(length)
    density = np.abs(np.fft.rfft(segments.values * window, axis=1)) ** 2 * 2 / (segments.rate * (window @ window))
    places = np.fft.rfftfreq(length, 1 / segments.rate)
    inside = (places >= low) & (places < high)
    reach = _BESIDE * segments.bin
    free = inside.copy()
    for line in lines:
        free &= np.abs(places - line) > reach
    if free.sum() < max(_LEAST * inside.sum(), 3):
        return None
    return np.asarray(density[:, free].mean(axis=1) * (high - low))
