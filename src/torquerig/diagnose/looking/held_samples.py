"""Samples that are renewed more seldom than they are written: a telemetry's or a bus's, held in between."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.signals.recording import Recording

_STANDS = 0.4  # share of the steps that are none: every second sample held makes half
_NOISE = 6.0  # medians of the steps: what is less while most stand is the noise of what comes behind the hold
# beside noise a step is what stands out, as the blows of a line do too: they come less often than every fifty samples,
# or more than one to a beat
_OFTEN, _TO_A_BEAT = 0.02, 1.05
_IN_STEP = 0.7  # of the changes, summed with the phase of their rhythm: all of them would make 1, and no scallop 0.9
_PADDED = 2  # times the length: a rhythm between two frequencies of the transform keeps nine tenths


def renewed_every(recording: Recording) -> float | None:
    """Return after how many samples the torque is renewed, where it is held in between in an even rhythm; else None.

    Values that stand still on coarse codes change whenever the signal crosses one: those changes keep no rhythm.
    """
    values = recording.channels[recording.torque_name()].values
    changes = _changes(values)
    number = int(changes.sum())
    noisy = number < np.count_nonzero(np.diff(values))
    if number < max(2, _OFTEN * changes.size if noisy else 0) or number > (1 - _STANDS) * changes.size:
        return None
    spectrum = np.abs(np.fft.rfft(changes, _PADDED * changes.size)) / number
    spectrum[: max(1, number // 2)] = 0.0  # a rhythm has at least as many beats as there are changes, but for a few
    beat = int(np.argmax(spectrum[: 3 * number]))
    in_step = spectrum[beat] > _IN_STEP and (not noisy or number < _TO_A_BEAT * beat / _PADDED)
    return _PADDED * changes.size / beat if in_step else None


def _changes(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which steps are more than noise, where most are none or that; shape (samples - 1,)."""
    steps = np.abs(np.diff(values))
    return np.asarray(steps > _NOISE * np.median(steps))


def on_straight_lines(recording: Recording) -> Recording:
    """Return the recording with straight lines from one renewal to the next, as it is where nothing is held."""
    every = renewed_every(recording)
    if every is None:
        return recording
    name = recording.torque_name()
    values = recording.channels[name].values
    renewed = np.concatenate([[0], _renewals(np.flatnonzero(_changes(values)) + 1, every)])
    held = np.add.reduceat(values, renewed) / np.diff(np.append(renewed, values.size))
    return recording.with_values(name, np.interp(np.arange(values.size), renewed, held))


def _renewals(changed: NDArray[np.int_], every: float) -> NDArray[np.int_]:
    """Return the samples that are renewed: those that change and, evenly between them, those whose turn it is."""
    beats = np.maximum(np.round(np.diff(changed) / every), 1).astype(int)
    between = [
        np.linspace(start, stop, number + 1)[1:-1]
        for start, stop, number in zip(changed[:-1], changed[1:], beats, strict=True)
        if number > 1
    ]
    return np.union1d(changed, np.round(np.concatenate([changed[:0], *between])).astype(int))
