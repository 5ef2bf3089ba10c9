"""Dropouts behind a low-pass: the signal falls to one common level for milliseconds, again and again, edges rounded.

The reading is lost before the amplifier, so its edges are as slow as the amplifier and noise goes on. Moments whose
level departs from the neighbourhood are looked for by a whitening matched filter, fitted by rectangular pulses behind
a low-pass, and believed where some of them fall to one level, alike in shape, far outside the rest.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.pulse_behind_low_pass import (
    Fit,
    LowPass,
    LowPassKind,
    Windows,
    window_noise,
    window_size,
)
from torquerig.recordings.repair.robust_spread import spread_about_zero
from torquerig.recordings.repair.short_departures import depths, peaks_of, short_departures

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Ints = NDArray[np.int64]

RATE = 2500.0  # [Hz] to which faster signals are averaged: content below 800 Hz determines lengths from 1 ms on
_SLOWEST = 125.0  # [Hz] at which the longest moment that is found holds two samples
_BAND = 800.0  # [Hz]
_LEAST, _MOST = 6.0, 200  # robust spreads of a departure that is looked at; how many are
_SHORTEST, _LONGEST = 0.001, 0.017  # [s]
_STEP, _FINE = 0.0008, 0.0003  # [s] between the starts and lengths that are tried at first, and then
_KINDS: tuple[LowPassKind, ...] = ("butterworth", "first order", "bessel")
_CUTOFFS = (50.0, 85.0, 140.0, 230.0, 400.0)  # [Hz] that are tried at first
_ALL_CUTOFFS = (40.0, *np.geomspace(50.0, 1300.0, 13))  # [Hz] that are tried then; and steps about the best
_ABOUT = np.exp(np.linspace(-0.21, 0.21, 7))
_UNEXPLAINED = 0.5  # share of a moment's energy that another shape would leave
_GAIN = 50.0  # of a moment that counts, in units of noise power
_FIRST_LEVEL, _ONE_LEVEL = 0.2, 0.35  # of the depth, by which levels of one kind differ
_EXAMPLES = 24  # moments by which the low-pass is told
_FOUND = 0.45  # of the depth, at which others are looked at
_SEVERAL = 2000
_OTHER_LENGTHS = np.array([0.6, 1.0, 1.5])  # of the median length, by which moments are searched
_TRIALS = 3  # levels
_RISES = 0.5  # of the depth: where the level changes by more it does not come back

# what is believed
_FEWEST = 4  # moments
_CLEAR = 3.0  # robust spreads of the neighbourhood, half a second long, from it to the level
_SPREAD = 0.25  # of the depths
_MEAN_UNEXPLAINED = 0.4
_OTHERS, _LARGER = 0.25, 1.0  # of the moments: departures half as deep or of another shape, and deeper ones
_DEEPER = 1.4  # times the depth to the level: what is deeper has no part in it
_NEAR = 0.03  # [s] of a moment, within which its own echoes are
_AS_STRONG = 0.2  # of the moments' gain: what is fainter is noise
_SHARE = 0.1  # of the time: what is there more often is a state of the signal
_AS_LIKELY = 0.03, 10.0  # of the gain, and at least in units of noise: by how much a low-pass may fit worse
_LENGTH_OFF = 0.05, 0.0003  # of a length, and [s]: by how much more it may be off


def rounded_dropouts(values: Floats, rate: float) -> RoundedDropouts | None:
    """Return the dropouts of a stretch, None where there are none.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Without NaN, in any unit; some seconds to some minutes.
    rate : float
        [Hz].
    """
    signal, rate = averaged(values, rate)
    if rate < _SLOWEST or signal.size < 20 * window_size(rate) or not np.ptp(signal):
        return None
    noise = window_noise(signal, rate)
    band = min(_BAND, 0.4 * rate)
    at = short_departures(signal, rate, noise, least=_LEAST, most=_MOST)
    if at.size < _FEWEST:
        return None
    windows = Windows(signal, rate, at, noise, step=_STEP, band=min(0.5 * _BAND, band))
    for seen in _alike(windows):
        found, shape = _refined(signal, rate, noise, at[seen], band=band)
        evidence = None if found is None else _evidence(found, shape, signal, rate)
        if found is not None and evidence is not None and evidence.is_convincing:
            return _answer(found, shape, evidence.clear, rate)
    return None


def _refined(signal: Floats, rate: float, noise: Floats, at: Ints, *, band: float) -> tuple[_Found | None, _Shape]:
    """Return all moments like those ``at`` some places, and their shape, by two rounds."""
    cutoffs: tuple[float, ...] = _ALL_CUTOFFS
    while True:
        examples = at[np.linspace(0, at.size - 1, min(at.size, _EXAMPLES)).astype(int)]
        windows = Windows(signal, rate, examples, noise, step=_FINE, band=band)
        shape = _shape(windows, cutoffs, step=_FINE if cutoffs is not _ALL_CUTOFFS else 2 * _FINE)
        found = _everywhere(signal, rate, noise, shape)
        if found is None or cutoffs is not _ALL_CUTOFFS:
            return found, shape
        at = found.at[found.members]
        cutoffs = tuple(min(shape.low_pass.cutoff, _ALL_CUTOFFS[-1]) * _ABOUT)


def block_of(rate: float) -> int:
    """Return how many samples at a rate [Hz] one mean holds, so that means come at 2.5 to 5 kHz or as the samples."""
    return max(int(rate / RATE), 1)


def averaged(values: Floats, rate: float) -> tuple[Floats, float]:
    """Return means of samples at 2.5 to 5 kHz, or the samples where they are slower, and their rate [Hz]."""
    block = block_of(rate)
    count = values.size // block
    return values[: count * block].reshape(count, block).mean(axis=1), rate / block


def _alike(windows: Windows) -> list[Flags]:
    """Return which windows hold moments of one level, the likeliest first, each by the low-pass that explains most."""
    lengths, found = np.arange(_SHORTEST, _LONGEST, _STEP), list[tuple[float, Flags]]()
    shapes = [LowPass(kind, cutoff) for kind in _KINDS[:2] for cutoff in _CUTOFFS]
    for low_pass in (*shapes, LowPass("butterworth", np.inf)):
        fit = windows.fitted(low_pass, lengths, before=0.035, after=0.015)
        for sign in (1.0, -1.0):
            members, others = _one_level(fit, sign)
            if members.sum() >= _FEWEST:
                purity = members.sum() / (members.sum() + others)
                score = float(np.sum(np.log(fit.gain[members]) * (1 - fit.unexplained[members])))
                found.append((score * purity**2, members))
    answer: list[Flags] = []
    for _, members in sorted(found, key=lambda each: -each[0]):
        if len(answer) < _TRIALS and not any((members & other).sum() > 0.5 * members.sum() for other in answer):
            answer.append(members)
    return answer


def _one_level(fit: Fit, sign: float) -> tuple[Flags, int]:
    """Return which fits are at the level that most share, and how many others are as deep."""
    good = (np.sign(fit.depth) == sign) & (fit.unexplained < _UNEXPLAINED) & (fit.gain > _GAIN)
    if good.sum() < _FEWEST:
        return np.zeros(good.size, dtype=bool), 0
    levels, depth = fit.level[good], np.abs(fit.depth[good])
    near = np.abs(levels[:, None] - levels) < _FIRST_LEVEL * depth[:, None]
    level = float(np.median(levels[near[np.argmax(near.sum(axis=1))]]))
    away = sign * (level - fit.around)
    relative = sign * fit.depth / np.where(away > 0, away, np.inf)
    members = good & (np.abs(relative - 1) < 0.25)
    return members, int(np.sum((relative > _FOUND) & (relative < _DEEPER) & ~members))


@dataclass(frozen=True)
class _Shape:
    low_pass: LowPass
    level: float
    sign: float
    length: float
    between: tuple[float, float]
    lengths: Floats
    windows: Windows


def _shape(windows: Windows, cutoffs: Iterable[float], *, step: float) -> _Shape:
    """Return the low-pass that explains examples best, and their level and length, in steps [s] of that."""
    lengths = np.arange(_SHORTEST, _LONGEST, step)
    shapes = [LowPass(kind, float(cutoff)) for kind, cutoff in product(_KINDS, cutoffs)]
    tried: list[tuple[float, LowPass, Fit]] = []
    for each in (*shapes, LowPass("butterworth", np.inf)):
        own = windows.fitted(each, lengths, before=0.012, after=0.012)
        tried.append((float(own.gain.sum()), each, own))
    most, low_pass, fit = max(tried, key=lambda each: each[0])
    least = most - max(_AS_LIKELY[0] * most, _AS_LIKELY[1])
    medians = [float(np.median(other.length)) for gain, _, other in tried if gain >= least]
    return _Shape(
        low_pass=low_pass, level=float(np.median(fit.level)), sign=float(np.sign(np.median(fit.depth))),
        length=float(np.median(fit.length)), between=(min(medians), max(medians)), lengths=lengths, windows=windows,
    )  # fmt: skip


@dataclass(frozen=True)
class _Found:
    at: Ints
    fit: Fit
    relative: Floats  # depth over that to the level
    members: Ints


def _everywhere(signal: Floats, rate: float, noise: Floats, shape: _Shape) -> _Found | None:
    """Return all departures towards the level, and which of them are moments of this shape."""
    size = window_size(rate) // 2
    coarse = np.median(signal[: signal.size // size * size].reshape(-1, size), axis=1)
    around = np.interp(np.arange(signal.size), (np.arange(coarse.size) + 0.5) * size, coarse)
    away = shape.sign * (shape.level - around)
    relative = np.zeros(signal.size)
    for length in shape.length * _OTHER_LENGTHS:
        depth = depths(signal, rate, shape.windows.weight, length=float(length), low_pass=shape.low_pass)
        each = np.where(away > 0, shape.sign * depth / np.maximum(away, 1e-300), 0.0)
        shift = round(0.5 * length * rate)
        relative[shift:] = np.maximum(relative[shift:], each[: each.size - shift])
    apart = max(round(0.5 * shape.length * rate), 2)
    at = peaks_of(relative, least=_FOUND, apart=apart, shy=0.5, most=_SEVERAL)
    if at.size < _FEWEST:
        return None
    windows = Windows(signal, rate, at, noise, step=_FINE, band=_BAND, like=shape.windows)
    fit = windows.fitted(shape.low_pass, shape.lengths, before=0.012, after=0.008)
    away = shape.sign * (shape.level - fit.around)
    relative = shape.sign * fit.depth / np.where(away > 0, away, np.inf)
    good = (
        (np.abs(relative - 1) < _ONE_LEVEL) & (fit.unexplained < _UNEXPLAINED) & (fit.gain > _GAIN)
        & (np.abs(windows.rise) < _RISES * away)
    )  # fmt: skip
    members: list[int] = []
    for index in np.flatnonzero(good)[np.argsort(fit.start[good])].tolist():
        before = members[-1] if members else None
        if before is None or fit.start[index] > fit.start[before] + 0.9 * fit.length[before] * rate:
            members.append(index)
        elif fit.gain[index] > fit.gain[before]:
            members[-1] = index
    return _Found(at, fit, relative, np.array(members, dtype=np.int64)) if len(members) >= _FEWEST else None


@dataclass(frozen=True)
class _Evidence:
    """How far off the level is, how alike the moments are, and how many departures are not like them."""

    moments: int
    clear: float
    spread: float
    unexplained: float
    others: int
    larger: int
    share: float
    length: float

    @property
    def is_convincing(self) -> bool:
        return bool(
            self.clear > _CLEAR and self.spread < _SPREAD and self.unexplained < _MEAN_UNEXPLAINED
            and self.others <= max(1, _OTHERS * self.moments) and self.larger <= max(2, _LARGER * self.moments)
            and self.share < _SHARE and _SHORTEST + _FINE < self.length < _LONGEST - 2 * _FINE
        )  # fmt: skip


def _evidence(found: _Found, shape: _Shape, signal: Floats, rate: float) -> _Evidence:
    members, fit = found.members, found.fit
    rest = np.setdiff1d(np.arange(found.at.size), members)
    near = np.abs(fit.start[rest][:, None] - fit.start[members]).min(axis=1, initial=np.inf) < _NEAR * rate
    strong = fit.gain[rest] > _AS_STRONG * float(np.median(fit.gain[members]))
    beside = found.relative[rest[~near & strong]]
    away = np.abs(shape.level - fit.around[members])
    return _Evidence(
        moments=members.size, clear=float(np.median(away / _spreads_about(signal, rate, found.at[members]))),
        spread=spread_about_zero(found.relative[members] - 1), unexplained=float(np.median(fit.unexplained[members])),
        others=int(np.sum((beside > _FOUND) & (beside < _DEEPER))), larger=int(np.sum(beside >= _DEEPER)),
        share=float(fit.length[members].sum()) * rate / signal.size, length=float(np.median(fit.length[members])),
    )  # fmt: skip


def _answer(found: _Found, shape: _Shape, clear: float, rate: float) -> RoundedDropouts:
    starts, lengths = found.fit.start[found.members] / rate, found.fit.length[found.members]
    middle, (share, more) = float(np.median(lengths)), _LENGTH_OFF
    low, high = min(shape.between[0], middle), max(shape.between[1], middle)
    return RoundedDropouts(
        level=shape.level, starts=tuple(starts.tolist()), lengths=tuple(lengths.tolist()),
        length=(max((1 - share) * low - more, 0.0), (1 + share) * high + more), low_pass=shape.low_pass, clear=clear,
    )  # fmt: skip


def _spreads_about(signal: Floats, rate: float, at: Ints) -> Floats:
    """Return the robust standard deviation within a quarter of a second either way of each sample."""
    reach = round(0.25 * rate)
    around = signal[np.clip(at[:, None] + np.arange(-reach, reach + 1), 0, signal.size - 1)]
    low, high = np.percentile(around, [15.87, 84.13], axis=1)
    return np.asarray(np.maximum(0.5 * (high - low), 1e-300))
