"""Samples that are renewed more seldom than they are written: a telemetry's or a bus's, held in between."""

from __future__ import annotations

import numpy as np

from torquerig.signals.recording import Recording

_STANDS = 0.4  # share of the steps that are none: every second sample held makes half
_IN_STEP = 0.7  # of the changes, summed with the phase of their rhythm: all of them would make 1, and no scallop 0.9
_PADDED = 2  # times the length: a rhythm between two frequencies of the transform keeps nine tenths


def renewed_every(recording: Recording) -> float | None:
    """Return after how many samples the torque is renewed, where it is held in between in an even rhythm; else None.

    Values that stand still on coarse codes change whenever the signal crosses one: those changes keep no rhythm.
    """
    changes = np.diff(recording.channels[recording.torque_name()].values) != 0
    number = int(changes.sum())
    if number < 2 or changes.mean() > 1 - _STANDS:
        return None
    spectrum = np.abs(np.fft.rfft(changes, _PADDED * changes.size)) / number
    spectrum[: max(1, number // 2)] = 0.0  # a rhythm has at least as many beats as there are changes, but for a few
    beat = int(np.argmax(spectrum[: 3 * number]))
    return _PADDED * changes.size / beat if spectrum[beat] > _IN_STEP else None


def on_straight_lines(recording: Recording) -> Recording:
    """Return the recording with straight lines from one renewal to the next, as it is where nothing is held."""
    if renewed_every(recording) is None:
        return recording
    name = recording.torque_name()
    values = recording.channels[name].values
    renewed = np.concatenate([[0], np.flatnonzero(np.diff(values)) + 1])
    return recording.with_values(name, np.interp(np.arange(values.size), renewed, values[renewed]))
