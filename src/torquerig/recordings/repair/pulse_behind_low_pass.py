"""A moment without signal behind an amplifier: a rectangular pulse through a low-pass, fitted in the frequency domain.

Where a reading y falls to a level L for a time T before a low-pass h, y = h * s + (L - s) h * rect(T): what a moment
adds is known but for its start, its length and its depth. A matched filter gives start and depth of the least squares
fit under coloured noise (Turin 1960, IRE Trans. Inf. Theory 6, 311).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

LowPassKind = Literal["butterworth", "first order", "bessel"]

_WINDOW = 0.13  # [s] cut out about a moment: ten times the longest, and mostly free of a second one
_TAPERED = 0.3  # share of it that fades in and out
_MISMATCH = 0.1  # of a moment's own spectrum that the shape may be wrong by, so that no frequency counts too much
_HIGH_PASS = 4.0  # [Hz] below which a window of that length holds no more than its slope
_BESSEL = 1.3616541  # the -3 dB point of s^2 + 3 s + 3, over one


@dataclass(frozen=True)
class LowPass:
    """An amplifier's low-pass by its kind and its -3 dB ``cutoff`` [Hz], infinity where none is seen."""

    kind: LowPassKind
    cutoff: float

    def response(self, frequency: Floats) -> Complex:
        """Return the complex gain at frequencies [Hz], shape (bins,)."""
        s = 1j * frequency / self.cutoff
        if self.kind == "first order":
            return np.asarray(1 / (1 + s))
        if self.kind == "bessel":
            return np.asarray(3 / (3 + 3 * _BESSEL * s + (_BESSEL * s) ** 2))
        return np.asarray(1 / (1 + np.sqrt(2) * s + s**2))

    @property
    def settling(self) -> float:
        """The time after a step until some 2 % are missing [s]."""
        return 0.9 / self.cutoff


def step_spectrum(frequency: Floats, low_pass: LowPass, *, rate: float) -> Complex:
    """Return the transform of a unit step at zero, sampled as means at ``rate`` [Hz]; 0 at 0 Hz, where it has none.

    Parameters
    ----------
    frequency : ndarray, shape (bins,)
        [Hz].
    """
    integrated = np.where(frequency > 0, rate / (2j * np.pi * np.where(frequency > 0, frequency, 1.0)), 0.0)
    return np.asarray(integrated * np.sinc(frequency / rate) * low_pass.response(frequency))


def pulse_spectrum(frequency: Floats, length: float, low_pass: LowPass, *, rate: float) -> Complex:
    """Return the transform of a unit pulse that begins at zero, ``length`` [s] long, sampled as means at ``rate`` [Hz].

    Parameters
    ----------
    frequency : ndarray, shape (bins,)
        [Hz].
    """
    rectangle = length * rate * np.sinc(frequency * length) * np.exp(-1j * np.pi * frequency * length)
    return np.asarray(rectangle * np.sinc(frequency / rate) * low_pass.response(frequency))


@dataclass(frozen=True)
class Fit:
    """The best pulse in each window, all of shape (windows,).

    ``gain`` is how much of the window's weighted energy it explains, ``unexplained`` the share of it beyond noise that
    stays, ``start`` its first sample in the signal, ``length`` [s], ``depth`` and ``around`` (the level about it) and
    ``level`` (their sum) in the signal's unit.
    """

    gain: Floats
    unexplained: Floats
    start: Floats
    length: Floats
    depth: Floats
    around: Floats

    @property
    def level(self) -> Floats:
        """The level of each, in the signal's unit."""
        return np.asarray(self.around + self.depth)


@dataclass(frozen=True)
class Windows:
    """Windows of a signal about places where it may be lost, transformed, and the weights of their frequencies.

    Parameters
    ----------
    signal : ndarray, shape (samples,)
    rate : float
        [Hz].
    at : ndarray of int, shape (windows,)
        Their middles.
    noise : ndarray, shape (bins,)
        Power of a window without a moment.
    step : float
        Between the starts and between the lengths that are tried [s], which are off by up to half of it.
    band : float
        The highest frequency that counts [Hz].
    like : Windows, optional
        Those whose weights are taken over.
    """

    signal: Floats
    rate: float
    at: NDArray[np.int64]
    noise: Floats
    step: float
    band: float
    like: Windows | None = None
    base: Floats = field(init=False)
    spectra: Complex = field(init=False)
    weight: Floats = field(init=False)

    def __post_init__(self) -> None:
        size = window_size(self.rate)
        raw = _cut(self.signal, self.at - size // 2, size)
        object.__setattr__(self, "base", _trend(raw))
        object.__setattr__(self, "spectra", np.fft.rfft((raw - self.base) * _taper(size), axis=1))
        if self.like is not None:
            object.__setattr__(self, "weight", self.like.weight)
            return
        frequency = np.fft.rfftfreq(size, 1 / self.rate)
        mean = np.mean(np.abs(self.spectra) ** 2, axis=0)
        wrong = mean * (_MISMATCH**2 + np.minimum((np.pi * frequency * self.step) ** 2, 1.0))
        used = (frequency >= _HIGH_PASS) & (frequency <= self.band)
        object.__setattr__(self, "weight", np.where(used, 1 / (self.noise + wrong), 0.0))

    def fitted(self, low_pass: LowPass, lengths: Floats, *, before: float, after: float) -> Fit:
        """Return the best pulse of each window among ``lengths`` [s] that begins so long before or after its middle.

        A pulse is a step up and, its length later, a step down. So one matched filter for a step serves all lengths,
        which are rounded to the distance of the starts that are tried.
        """
        size, index, used = window_size(self.rate), np.arange(self.at.size), int(np.flatnonzero(self.weight)[-1]) + 1
        frequency = np.asarray(np.fft.rfftfreq(size, 1 / self.rate)[:used], dtype=np.float64)
        weight = self.weight[:used]
        spectra = self.spectra[:, :used]
        steps = 2 * max(used, round(0.5 * size / self.rate / self.step))  # of starts within a window
        first = round((0.5 - before * self.rate / size) * steps)
        last = round((0.5 + after * self.rate / size) * steps) + 1
        counts = np.unique(np.maximum(np.round(lengths * self.rate / size * steps).astype(int), 1))
        lengths = counts * size / steps / self.rate
        step = step_spectrum(frequency, low_pass, rate=self.rate)
        turned = np.exp(-2j * np.pi * frequency * lengths[:, None])
        energies = 2 * (np.abs(step * (1 - turned)) ** 2 * weight).sum(axis=1)
        up = np.fft.irfft(spectra * (step.conj() * weight), steps, axis=1) * steps
        down = np.concatenate([up, up], axis=1)  # a window repeats
        up = up[:, first:last]
        best, depth, start, length = (np.zeros(self.at.size) for _ in range(4))
        for count, each, energy in zip(counts.tolist(), lengths.tolist(), energies.tolist(), strict=True):
            matched = up - down[:, first + count : last + count]
            place = np.argmax(np.abs(matched), axis=1)
            peak = matched[index, place]
            better = peak**2 > best * energy
            best = np.where(better, peak**2 / energy, best)
            depth, length = np.where(better, peak / energy, depth), np.where(better, each, length)
            start = np.where(better, (first + place) * size / steps, start)
        total = 2 * (np.abs(spectra) ** 2 * weight).sum(axis=1)
        beyond = np.maximum(total - 2 * float((self.noise[:used] * weight).sum()), 1e-9)
        middle = np.clip(start + 0.5 * length * self.rate, 0, size - 1).astype(int)
        return Fit(
            gain=best, unexplained=np.clip(1 - best / beyond, 0.0, 1.0), start=self.at - size // 2 + start,
            length=length, depth=depth, around=self.base[index, middle],
        )  # fmt: skip

    @property
    def rise(self) -> Floats:
        """By how much the level after each window is above that before it."""
        return np.asarray(self.base[:, -1] - self.base[:, 0])


def window_size(rate: float) -> int:
    """Return the samples of a window, an even number."""
    return 2 * max(round(0.5 * _WINDOW * rate), 8)


def window_noise(signal: Floats, rate: float) -> Floats:
    """Return the usual power of a window at each frequency, by the median over all, which moments do not move."""
    size = window_size(rate)
    raw = _cut(signal, np.arange(0, max(signal.size - size, 1), size // 2), size)
    power = np.abs(np.fft.rfft((raw - _trend(raw)) * _taper(size), axis=1)) ** 2
    middle = np.median(power, axis=0) / np.log(2)
    return np.asarray(np.maximum(middle, 1e-9 * middle.max() + 1e-300))


def _cut(signal: Floats, starts: NDArray[np.int64], size: int) -> Floats:
    return np.asarray(signal[np.clip(starts[:, None] + np.arange(size), 0, signal.size - 1)])


def _trend(raw: Floats) -> Floats:
    """Return the straight lines through the medians of the first and the last sixth of each window."""
    size = raw.shape[1]
    part = max(size // 6, 1)
    first, last = np.median(raw[:, :part], axis=1), np.median(raw[:, -part:], axis=1)
    along = (np.arange(size) - 0.5 * (part - 1)) / (size - part)
    return np.asarray(first[:, None] + (last - first)[:, None] * along)


def _taper(size: int) -> Floats:
    """Return a window of cosine edges (Tukey)."""
    edge = max(int(0.5 * _TAPERED * size), 1)
    rising = 0.5 * (1 - np.cos(np.pi * (np.arange(edge) + 0.5) / edge))
    return np.concatenate([rising, np.ones(size - 2 * edge), rising[::-1]])
