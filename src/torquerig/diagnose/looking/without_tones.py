"""A run less the lines of fixed frequency that were found in it: a hum hides how quiet a flight of flanks is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.places import Place

_WINDOW = 2.0  # [s] a tone keeps its phase so long, and little else lies within 1 Hz of it
_STEP = 0.01  # [s] between two values of a tone's envelope


def without_tones(observed: Observed, places: Sequence[Place]) -> Observed:
    """Return the run, those lines at the places that do not turn taken out of its torque.

    Each line is its own envelope times its carrier; the envelope is the torque mixed down to zero and averaged with a
    Hann window of 2 s, so that a tone whose phase wanders is followed.
    """
    tones = [place.at for place in places if place.domain == "frequency" and place.at < 0.5 * observed.rate]
    return replace(observed, torque=less_tones(observed.torque, observed.rate, tones)) if tones else observed


def less_tones(values: NDArray[np.float64], rate: float, tones: Sequence[float]) -> NDArray[np.float64]:
    """Return samples at a rate [Hz] less the lines at ``tones`` [Hz], each with its slow envelope; shape (samples,)."""
    for tone in tones:
        carrier = np.exp(2j * pi * tone / rate * np.arange(values.size))
        values = values - 2 * np.real(_envelope(values * carrier.conj(), rate) * carrier)
    return values


def _envelope(mixed: NDArray[np.complex128], rate: float) -> NDArray[np.complex128]:
    """Return the slow part of a signal, by means over blocks of 10 ms, shape (samples,)."""
    step = max(1, round(_STEP * rate))
    blocks = mixed.size // step
    if blocks < 2:
        return np.full(mixed.size, mixed.mean())
    means = mixed[: blocks * step].reshape(blocks, step).mean(axis=1)
    window = np.hanning(min(round(_WINDOW / _STEP), blocks) + 2)[1:-1]
    slow = np.convolve(means, window, "same") / np.convolve(np.ones(blocks), window, "same")
    middles = (np.arange(blocks) + 0.5) * step
    return np.asarray(np.interp(np.arange(mixed.size), middles, slow))
