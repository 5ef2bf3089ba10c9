"""Curves of a comparison: slow torque over time, the lines of a short window, the spectrum over shaft orders."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.turning import block_size
from torquerig.diagnosis.showing.comparison import Side

Floats = NDArray[np.float64]


def slow_course(run: Observed) -> tuple[Floats, Floats]:
    """Return the middle of each block of 20 ms [s], and the mean torque there [N m]."""
    size = block_size(run)
    count = run.torque.size // size
    means = run.torque[: count * size].reshape(count, size).mean(axis=1)
    return np.asarray((np.arange(count) + 0.5) * (size / run.rate)), means


def held_spans(held: Features) -> list[tuple[float, float]]:
    """Return from when to when no fit has looked [s]."""
    return [
        (one.start / held.observed.rate, one.stop / held.observed.rate) for one in held.observed.stretches if one.held
    ]


def window_of(held: Features, *, row: int, duration: float) -> slice:
    """Return the samples of a window in the middle of a stretch, at most the stretch itself."""
    stretch, size = held.stretches[row], round(duration * held.observed.rate)
    middle = (stretch.start + stretch.stop) // 2
    return slice(max(stretch.start, middle - size // 2), min(stretch.stop, middle + (size + 1) // 2))


def line_wave(held: Features, side: Side, *, row: int, window: slice) -> Floats:
    """Return the level and the lines that a model expects in a window [N m], shape (samples,).

    The lines have the sizes of the model and the phases of the recording: a phase is where a rig happened to start.
    What is random is left out, since no model can know it sample by sample.
    """
    angle = held.observed.angle[window]
    time = np.arange(window.start, window.stop) / held.observed.rate
    own = len(held.parts) // len(held.stretches)
    wave = np.full(angle.size, float(side.expected.level[row * own : (row + 1) * own].mean()))
    for column, place in enumerate(held.places):
        measured = held.amplitude[row, column]
        if np.isfinite(measured):
            phase = place.phase(angle, time) + np.angle(measured)
            wave += side.expected.amplitude[row, column] * np.cos(phase)
    return wave


def order_spectrum(run: Observed, held: Features, *, ratio: float) -> tuple[Floats, Floats]:
    """Return orders of the output shaft [1/rev] and amplitudes [N m] of the held-out stretches, taken evenly in angle.

    Neighbouring stretches are one; of several the spectra are averaged in power, on the orders of the longest.
    """
    pieces = [_piece(run, start, stop, ratio) for start, stop in _joined(held)]
    longest = max(pieces, key=lambda piece: piece[0].size)
    power = np.mean([np.interp(longest[0], *piece) ** 2 for piece in pieces], axis=0)
    return longest[0], np.sqrt(power)


def _joined(held: Features) -> list[tuple[int, int]]:
    spans: list[tuple[int, int]] = []
    for stretch in held.stretches:
        if spans and spans[-1][1] == stretch.start:
            spans[-1] = (spans[-1][0], stretch.stop)
        else:
            spans.append((stretch.start, stretch.stop))
    return spans


def _piece(run: Observed, start: int, stop: int, ratio: float) -> tuple[Floats, Floats]:
    angle, torque = np.abs(run.angle[start:stop] - run.angle[start]), run.torque[start:stop]
    even = np.linspace(0.0, angle[-1], torque.size)
    window = np.hanning(torque.size)
    resampled = np.interp(even, angle, torque - torque.mean()) if angle[-1] > 0 else torque - torque.mean()
    amplitude = np.abs(np.fft.rfft(resampled * window)) * 2 / window.sum()
    turns = angle[-1] / (2 * pi * ratio) * torque.size / (torque.size - 1)
    return np.arange(amplitude.size) / turns, amplitude
