"""Flat tops that a hum or an alias rides on: an amplifier's rails cut the signal before its cable picks these up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.flat_tops import FEWEST_FLAT, FLAT_SHARE, FlatTops
from torquerig.recordings.repair.mains_hum import grid_line
from torquerig.recordings.repair.strong_tone import power_of, strongest_tone, tone_waves

Floats = NDArray[np.float64]

_HARMONICS = 3
_TOP = 1e-3  # share of the samples above which a first guess of the limit lies
_FIRST, _LAST = 0.02, 1e-3  # of the signal's span, around a first and the last guess: within are samples of the pile
_BELOW = 0.999  # of the full range: what stops above stops in the converter
_CLOSER, _ROUNDS = 0.6, 12
_OVER_BESIDE = 4.0  # samples of a pile over those just below, on twice its width


def flat_under_hum(recordings: Sequence[Recording], *, full_range: float = float("inf")) -> FlatTops | None:
    """Return the level at which the signal stops once a hum or an alias is taken off, where it piles up there.

    What stops at ``full_range`` [V] stops in the converter, behind any cable.

    The hum is fitted by least squares with the harmonics 1 to 3 of the grid, their amplitudes straight in time (which
    takes up what its frequency is misjudged by), and once more on the samples near the limit alone, closer and closer:
    a limit leaves these nothing but the hum, so that they come to lie within 0.1 % of the span of one level. Noise
    behind the limit of more than that hides it. So is the strongest line above 400 Hz, without harmonics: what turns
    with the shafts is cut itself, and leaves no pile when it is taken off. None where nothing piles up.
    """
    found: dict[str, tuple[float, float]] = {}
    for recording in recordings:
        volts = recording.torque_values()
        for frequency, harmonics in _tones(volts, recording.sample_rate):
            waves = tone_waves(np.arange(volts.size) / recording.sample_rate, frequency, harmonics)
            hum = np.hstack([np.ones((volts.size, 1)), waves])
            for sign in (1.0, -1.0):
                pile = _pile(sign * volts, hum)
                if pile is not None and pile[0] < _BELOW * full_range:
                    found[recording.name] = pile
    return FlatTops.of_runs(found) if found else None


def _tones(volts: Floats, rate: float) -> Iterator[tuple[float, int]]:
    """Yield the frequency [Hz] of a hum and of an alias that stand out, each with how many harmonics it has."""
    power, step = power_of(volts, rate)
    grid, alias = grid_line(power, step), strongest_tone(power, step)
    if grid is not None:
        yield grid, _HARMONICS
    if alias is not None:
        yield alias, 1


def _pile(volts: Floats, hum: Floats) -> tuple[float, float] | None:
    """Return the level [V] at which the largest values pile up with the hum off, and their share, else None."""
    left = volts - hum[:, 1:] @ _fitted(hum, volts)[1:]
    limit, span = float(np.quantile(left, 1 - _TOP)), float(np.ptp(left))
    within = _FIRST * span
    for _ in range(_ROUNDS):
        near = np.abs(left - limit) < within
        if near.sum() < 2 * hum.shape[1]:
            return None
        fitted = _fitted(hum[near], volts[near])
        limit, left = float(fitted[0]), volts - hum[:, 1:] @ fitted[1:]
        within = max(_CLOSER * within, _LAST * span)
    piled = int((np.abs(left - limit) < within).sum())
    beside = int(((left <= limit - within) & (left > limit - 3 * within)).sum())
    beyond = int((np.abs(left) > abs(limit) + within).sum())
    enough = piled > max(FEWEST_FLAT, FLAT_SHARE * volts.size, _OVER_BESIDE * beside, beyond)
    return (limit, piled / volts.size) if limit > 0 and enough else None


def _fitted(columns: Floats, values: Floats) -> Floats:
    """Return the factors of least squares by the normal equations: waves of some periods are far from dependent."""
    return np.asarray(np.linalg.lstsq(columns.T @ columns, columns.T @ values, rcond=None)[0])
