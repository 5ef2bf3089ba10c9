"""A signal in segments of equal length, and its amplitudes at given orders or frequencies in each of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
FEWEST, MOST = 8, 24
"""Segments of a recording: fewer give no scatter, more leave too few turns in each."""
UNITS_EACH = 5.0
"""Turns of the output shaft in a segment, where the recording has enough for the fewest segments."""
_NEIGHBOURS = (-6.0, -5.0, -4.0, -3.0, 3.0, 4.0, 5.0, 6.0)  # [bins] a Hann window has no leakage from 2 bins on
_CLEAR = 2.5  # [bins] nearer than this to a line, a neighbour holds some of it
_STEPS = 21  # of a tenth of a bin: off by a twentieth, a Hann window loses 0.1 %
_AT_ONCE = 64  # places, so that the table of phases stays below 100 MB


@dataclass(frozen=True)
class Segments:
    """Segments of a signal at even steps.

    Parameters
    ----------
    values : ndarray, shape (segments, samples)
        Without the mean and the slope of each segment.
    rate : float
        Samples per unit of the axis: per turn of the output shaft, or per second.
    """

    values: Floats
    rate: float

    @property
    def bin(self) -> float:
        """The resolution of a segment, in the unit of places [1/rev] or [Hz]."""
        return float(self.rate / self.values.shape[1])


def count_for(units: float) -> int:
    """Return the number of segments of a recording with so many turns (or seconds times its lowest frequency)."""
    return int(np.clip(units / UNITS_EACH, FEWEST, MOST))


def cut(values: Floats, rate: float, count: int) -> Segments:
    """Return ``count`` segments of a signal, shape (samples,), each without its mean and slope."""
    length = values.size // count
    pieces = values[: count * length].reshape(count, length)
    line = np.linspace(-1.0, 1.0, length)
    slope = (pieces @ line) / (line @ line)
    return Segments(pieces - pieces.mean(axis=1, keepdims=True) - slope[:, None] * line, rate)


def amplitudes(segments: Segments, places: Floats) -> NDArray[np.complex128]:
    """Return the complex amplitude (zero to peak) at each place in each segment, shape (segments, places)."""
    length = segments.values.shape[1]
    window = np.hanning(length)
    weighted = segments.values * (2 * window / window.sum())
    steps = np.arange(length) / segments.rate
    found = np.empty((weighted.shape[0], places.size), dtype=np.complex128)
    for first in range(0, places.size, _AT_ONCE):
        some = places[first : first + _AT_ONCE]
        found[:, first : first + some.size] = weighted @ np.exp(-2j * np.pi * np.outer(steps, some))
    return found


def powers_and_noise(segments: Segments, places: Floats) -> tuple[Floats, Floats]:
    """Return the squared amplitude at each place in each segment, and the mean square of the noise next to it.

    Parameters
    ----------
    places : ndarray, shape (places,)
        Rising.

    Returns
    -------
    powers : ndarray, shape (segments, places)
        Squared amplitude, noise included.
    noise : ndarray, shape (places,)
        Expected squared amplitude of the noise alone, from places next to the line that hold no other one.
    """
    offsets = np.array(_NEIGHBOURS) * segments.bin
    around = places[:, None] + offsets
    distance = np.abs(around[:, :, None] - places[None, None, :]).min(axis=2)
    valid = (distance >= _CLEAR * segments.bin) & (around > segments.bin)
    valid[~valid.any(axis=1)] = True  # among lines everywhere: the noise is then taken too large
    near = np.abs(amplitudes(segments, around.ravel())).reshape(-1, places.size, offsets.size) ** 2
    noise = np.where(valid, near.mean(axis=0), 0.0).sum(axis=1) / valid.sum(axis=1)
    return np.abs(amplitudes(segments, places)) ** 2, noise


def finest_place(sides: tuple[Segments, Segments], place: float) -> float:
    """Return the place within one bin of ``place`` at which both signals together have the largest power.

    A line that was found by its order has a frequency that is off by the error of the speed. Searched in both signals
    at once, noise favours neither.
    """
    width = min(one.bin for one in sides)
    grid = place + width * np.linspace(-1.0, 1.0, _STEPS)
    power = sum((np.abs(amplitudes(one, grid)) ** 2).mean(axis=0) for one in sides)
    return float(grid[int(np.argmax(power))])
