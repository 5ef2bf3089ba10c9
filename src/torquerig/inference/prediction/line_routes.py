"""In which feature a line of a rig shows: at a place of the features, else in a band."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.regression import hann_transform
from torquerig.inference.features.run_features import RunFeatures

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

_SHARP = 2.1  # [bins] half the width of a line that was found by regression; a smeared one is wider

_ALIGNED = 0.25  # [bins] from a place: two lines at half a bin turn against each other by half a turn in a block


@dataclass(frozen=True)
class LineRoutes:
    """Where each of some lines shows in each segment, shape (lines, segments).

    Parameters
    ----------
    place : ndarray
        Index of the place whose power it is part of; -1 where none is.
    share : ndarray
        Share of its power that shows there [1]: a Hann window passes less of a line next to the one looked for.
    band : ndarray
        Index of the band that it is in, where it is in no place; -1 above and below all bands.
    aligned : ndarray of bool
        Whether it is so near to its place that it keeps its phase to a line there over a block.
    """

    place: Indices
    share: Floats
    band: Indices
    aligned: NDArray[np.bool_]


def line_routes(seen: RunFeatures, frequency: Floats) -> LineRoutes:
    """Return the routes of lines at ``frequency`` [Hz], shape (lines, segments)."""
    return seen.kept.get("routes", (frequency.shape, frequency.tobytes()), lambda: _routes(seen, frequency))


def _routes(seen: RunFeatures, frequency: Floats) -> LineRoutes:
    lines, count = frequency.shape
    place, band = (np.full((lines, count), -1, dtype=np.intp) for _ in range(2))
    share = np.ones((lines, count))
    aligned = np.zeros((lines, count), dtype=bool)
    for index, segment in enumerate(seen.segments):
        at, own = frequency[:, index], seen.line_frequency[index]
        shown = np.flatnonzero(segment.line_count > 0)
        if shown.size and lines:
            apart = np.abs(at[:, None] - own[None, shown])
            nearest = np.argmin(apart, axis=1)
            distance, reach = apart[np.arange(lines), nearest], segment.line_half_width[shown[nearest]]
            inside = distance <= reach
            place[inside, index] = shown[nearest[inside]]
            bins = distance * seen.duration_of(segment)
            sharp = reach * seen.duration_of(segment) <= _SHARP
            aligned[:, index] = inside & (bins < _ALIGNED)
            share[inside, index] = np.where(sharp, hann_transform(bins) ** 2, 1.0)[inside]
        edges = np.append(segment.bands.low, segment.bands.high[-1:])
        found = np.searchsorted(edges, at, side="right") - 1
        within = (found >= 0) & (found < edges.size - 1) & (place[:, index] < 0)
        band[within, index] = found[within]
    return LineRoutes(place, share, band, aligned)
