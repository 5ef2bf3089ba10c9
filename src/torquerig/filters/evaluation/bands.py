"""The rms of a signal in frequency bands."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.load_scale import WEAR_PART

if TYPE_CHECKING:
    from numpy.typing import NDArray


def bands_below(rate: float, edges: Sequence[float] = WEAR_PART.edges) -> tuple[tuple[float, float], ...]:
    """Return the bands (low, high) [Hz] between ``edges`` that a sample rate [Hz] can hold, the last one up to half."""
    ends = [edge for edge in edges if edge < rate / 2]
    return tuple(pairwise([*ends, rate / 2]))


def band_rms(values: NDArray[np.float64], rate: float, bands: Sequence[tuple[float, float]]) -> NDArray[np.float64]:
    """Return the rms of the part of ``values`` in each band, shape (bands,), in the unit of ``values``.

    A band includes its low end and excludes its high end, except at half the sample rate. The mean belongs to the band
    that starts at 0. Over adjoining bands the squares add up to the mean square of the signal (Parseval).

    Parameters
    ----------
    values : ndarray, shape (samples,)
    rate : float
        [Hz].
    bands : sequence of (low, high)
        [Hz].

    Raises
    ------
    RecordingError
        For no samples.
    """
    if values.size == 0:
        raise RecordingError("no samples have no bands; take a longer recording")
    power = np.abs(np.fft.rfft(values) / values.size) ** 2
    power[1:] *= 2
    if values.size % 2 == 0 and values.size > 1:
        power[-1] /= 2  # half the sample rate has no mirror image
    frequencies = np.arange(power.size) * (rate / values.size)
    inside = [(frequencies >= low) & ((frequencies < high) | (high >= rate / 2)) for low, high in bands]
    return np.sqrt([float(power[one].sum()) for one in inside])
