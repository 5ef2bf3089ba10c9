"""Samples that are renewed more seldom than they are written: a telemetry's or a bus's, held in between."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import pi
from statistics import median

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination

_STANDS = 0.4  # share of the steps that are none: every second sample held makes half
_NOISE = 6.0  # medians of the steps: what is less while most stand is the noise of what comes behind the hold
# beside noise a step is what stands out, as the blows of a line do too: they come less often than every fifty samples,
# or more than one to a beat
_OFTEN, _TO_A_BEAT = 0.02, 1.05
_IN_STEP = 0.7  # of the changes, summed with the phase of their rhythm: all of them would make 1, and no scallop 0.9
_ONE_LEVEL = 0.5  # share of the samples: a reading that stands at its limit leaves it in the rhythm of the shaft
_LARGEST = 6.0  # medians of the steps, that one of them may count
_AROUND, _NO_CHANCE = 4.0, 8.0  # beats of a run by which another's rhythm may be off, and spreads of chance
_PADDED = 2  # times the length: a rhythm between two frequencies of the transform keeps nine tenths


def renewed(seen: Examination) -> Examination:
    """Put straight lines between renewals of samples that are held; ``time_base`` describes them."""
    every = tuple(renewed_every(seen.recordings))
    return replace(seen, renewed=every, recordings=tuple(map(on_straight_lines, seen.recordings, every)))


def renewed_every(recordings: Sequence[Recording]) -> list[float | None]:
    """Return after how many samples each torque is renewed, where it is held in between in an even rhythm; else None.

    Where the rhythm is told in one run, it is looked for in those whose steps hardly pass the noise behind it.
    """
    told = [_rhythm(recording) for recording in recordings]
    known = [each / run.sample_rate for each, run in zip(told, recordings, strict=True) if each is not None]
    if not known:
        return told
    others = [_in_step(run, median(known) * run.sample_rate) for run in recordings]
    return [own or other for own, other in zip(told, others, strict=True)]


def _rhythm(recording: Recording) -> float | None:
    """Return the period of the changes of one run in samples, None where they are too few, too many or uneven.

    Values that stand still on coarse codes change whenever the signal crosses one: those changes keep no rhythm.
    Values that stand at one level most of the time are at a limit.
    """
    values = recording.torque_values()
    changes = _changes(values)
    number = int(changes.sum())
    noisy = number < np.count_nonzero(np.diff(values))
    if number < max(2, _OFTEN * changes.size if noisy else 0) or number > (1 - _STANDS) * changes.size:
        return None
    if np.unique(values, return_counts=True)[1].max() > _ONE_LEVEL * values.size:
        return None
    spectrum = np.abs(np.fft.rfft(changes, _PADDED * changes.size)) / number
    spectrum[: max(1, number // 2)] = 0.0  # a rhythm has at least as many beats as there are changes, but for a few
    beat = int(np.argmax(spectrum[: 3 * number]))
    in_step = spectrum[beat] > _IN_STEP and (not noisy or number < _TO_A_BEAT * beat / _PADDED)
    return _PADDED * changes.size / beat if in_step else None


def _in_step(recording: Recording, every: float) -> float | None:
    """Return the period near ``every`` in which the steps of a run grow, None where that is chance."""
    beats, told = _beat(_steps(recording), every)
    return recording.torque_values().size / beats if told > _NO_CHANCE else None


def _steps(recording: Recording) -> NDArray[np.float64]:
    steps = np.abs(np.diff(recording.torque_values()))
    return np.asarray(np.minimum(steps, _LARGEST * np.median(steps)))


def _beat(steps: NDArray[np.float64], every: float) -> tuple[float, float]:
    """Return how many beats the run has, of those near what is expected, and their sum in spreads of chance."""
    about = (steps.size + 1) / every
    tried = about + np.linspace(-_AROUND, _AROUND, 8 * round(_AROUND) + 1)
    away = steps - steps.mean()
    turns = np.arange(1, steps.size + 1) / (steps.size + 1)
    told = np.array([abs(np.exp(-2j * pi * beats * turns) @ away) for beats in tried])
    best = int(np.argmax(told))
    return float(tried[best]), float(told[best] / max(np.sqrt(away @ away), np.finfo(float).tiny))


def _changes(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which steps are more than noise, where most are none or that; shape (samples - 1,)."""
    steps = np.abs(np.diff(values))
    return np.asarray(steps > _NOISE * np.median(steps))


def on_straight_lines(recording: Recording, every: float | None) -> Recording:
    """Return the recording with straight lines from one renewal to the next, as it is where nothing is held."""
    if every is None:
        return recording
    name = recording.torque_name()
    values = recording.channels[name].values
    changed = np.flatnonzero(_changes(values)) + 1
    hidden = changed.size < np.count_nonzero(np.diff(values))  # those that do not pass the noise behind the hold
    renewed = np.concatenate([[0], _by_phase(_steps(recording), every) if hidden else _renewals(changed, every)])
    held = np.add.reduceat(values, renewed) / np.diff(np.append(renewed, values.size))
    return recording.with_values(name, np.interp(np.arange(values.size), renewed, held))


def _by_phase(steps: NDArray[np.float64], every: float) -> NDArray[np.int_]:
    """Return the samples that are renewed by the phase in which the steps are large."""
    samples = np.arange(1, steps.size + 1)
    first = float(np.angle(np.exp(2j * pi * samples / every) @ (steps - steps.mean()))) / (2 * pi) * every
    at = np.round(np.arange(first % every, steps.size + 1, every)).astype(int)
    return at[(at > 0) & (at <= steps.size)]


def _renewals(changed: NDArray[np.int_], every: float) -> NDArray[np.int_]:
    """Return the samples that are renewed: those that change and, evenly between them, those whose turn it is."""
    beats = np.maximum(np.round(np.diff(changed) / every), 1).astype(int)
    between = [
        np.linspace(start, stop, number + 1)[1:-1]
        for start, stop, number in zip(changed[:-1], changed[1:], beats, strict=True)
        if number > 1
    ]
    return np.union1d(changed, np.round(np.concatenate([changed[:0], *between])).astype(int))
