"""A run less the lines of fixed frequency that were found in it: a hum hides how quiet a flight of flanks is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import Place

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_WINDOW = 2.0  # [s] a tone keeps its phase so long, and little else lies within 1 Hz of it
_STEP = 0.01  # [s] between two values of a tone's envelope


def without_tones(observed: Observed, places: Sequence[Place]) -> Observed:
    """Return the run, those lines at the places that do not turn taken out of its torque.

    Each line is its own envelope times its carrier; the envelope is the torque mixed down to zero and averaged with a
    Hann window of 2 s, so that a tone whose phase wanders is followed.
    """
    tones = [place.at for place in places if place.domain == "frequency" and place.at < 0.5 * observed.rate]
    return replace(observed, torque=less_tones(observed.torque, observed.rate, tones)) if tones else observed


def less_tones(values: Floats, rate: float, tones: Sequence[float]) -> Floats:
    """Return samples at a rate [Hz] less the lines at ``tones`` [Hz], each with its slow envelope; shape (samples,)."""
    step = max(1, round(_STEP * rate))
    if values.size < 2 * step:
        step = values.size  # one block, one mean
    for tone in tones:
        values = values - _slow_line(values, 2 * pi * tone / rate, step)
    return values


def _slow_line(values: Floats, turn: float, step: int) -> Floats:
    """Return the line that turns by so much from sample to sample [rad], times its slow envelope; shape (samples,).

    The envelope is straight between the middles of blocks of ``step`` samples. There a carrier is one number a block
    times one a sample of it, so that no sample needs a sine of its own.
    """
    blocks = values.size // step
    within = np.exp(1j * turn * np.arange(step))
    mixed = values[: blocks * step].reshape(blocks, step) @ np.column_stack([within.real, within.imag])
    means = (mixed[:, 0] - 1j * mixed[:, 1]) * np.exp(-1j * turn * step * np.arange(blocks)) / step
    slow = _smoothed(means)
    middle = 0.5 * step
    first = ceil(middle)  # the sample from which on the envelope is straight
    last = first + (blocks - 1) * step
    begins = np.exp(1j * turn * (first + step * np.arange(blocks - 1)))
    share = (first - middle + np.arange(step)) / step
    left, right = 2 * slow[:-1] * begins, 2 * slow[1:] * begins
    shapes = np.array([within.real * (1 - share), within.imag * (1 - share), within.real * share, within.imag * share])
    line = np.empty(values.size)
    line[first:last] = (np.column_stack([left.real, -left.imag, right.real, -right.imag]) @ shapes).ravel()
    line[:first] = 2 * np.real(slow[0] * np.exp(1j * turn * np.arange(first)))
    line[last:] = 2 * np.real(slow[-1] * np.exp(1j * turn * np.arange(last, values.size)))
    return line


def _smoothed(means: Complex) -> Complex:
    """Return means of blocks over a Hann window, shape (blocks,)."""
    blocks = means.size
    window = np.hanning(min(round(_WINDOW / _STEP), blocks) + 2)[1:-1]
    return np.asarray(np.convolve(means, window, "same") / np.convolve(np.ones(blocks), window, "same"))
