"""What is compared of a run: its lines, its level, and the spectrum of what is left."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.observed import Observed, Stretch
from torquerig.diagnose.places import RESOLVED, Place
from torquerig.diagnose.regression import regressed

Floats = NDArray[np.float64]

BANDS_PER_OCTAVE = 8
_LOWEST_BAND = 1.2  # [Hz]
_HIGHEST_SHARE = 0.46  # of the sample rate: nearer to half of it converters and filters differ
_FEWEST_TURNS = 0.9  # periods of a line within a stretch
POINTS = 9  # speeds kept of each stretch


@dataclass(frozen=True, kw_only=True)
class Features:
    """Numbers of one run, the same for a recording and for a simulation.

    Parameters
    ----------
    stretches : tuple of Stretch
        The stretches looked at.
    places : tuple of Place
        The lines that were asked for.
    amplitude : ndarray, shape (stretches, places)
        Complex [N m]; NaN where a stretch cannot show the line (too slow, too fast, or another stands there).
    level : ndarray, shape (stretches,)
        Mean torque [N m], the lines' share taken out.
    speed : ndarray, shape (stretches, POINTS)
        Of the motor [rad/s], along each stretch.
    duration, acceleration : ndarray, shape (stretches,)
        [s], [rad/s^2] of the motor.
    band : ndarray, shape (bands,)
        Middle of each band [Hz].
    power : ndarray, shape (bands,)
        Mean one-sided density [(N m)^2/Hz] of what the lines leave; empty where the speed moves.
    count : ndarray, shape (bands,)
        Independent values behind each ``power``.
    width : ndarray, shape (bands,)
        Of each band [Hz].
    """

    observed: Observed
    stretches: tuple[Stretch, ...]
    places: tuple[Place, ...]
    amplitude: NDArray[np.complex128]
    level: Floats
    speed: Floats
    duration: Floats
    acceleration: Floats
    band: Floats
    power: Floats
    count: Floats
    width: Floats

    @cached_property
    def line_frequency(self) -> Floats:
        """Where each place stands along each stretch [Hz], shape (stretches, places, POINTS)."""
        turning = np.array([place.domain == "order" for place in self.places], dtype=bool)
        at = np.array([place.at for place in self.places])
        revolutions = np.abs(self.speed)[:, None, :] / (2 * pi)
        return np.asarray(np.where(turning[None, :, None], at[None, :, None] * revolutions, at[None, :, None]))


def features(observed: Observed, places: Sequence[Place], *, held: bool | None = False) -> Features:
    """Return the features of the stretches that fits may see (``held`` False), may not see (True), or all (None)."""
    stretches = [stretch for stretch in observed.stretches if held is None or stretch.held == held]
    amplitudes, levels, spectra = [], [], []
    for stretch in stretches:
        amplitude, level, rest = _lines(observed, stretch, places)
        amplitudes.append(amplitude)
        levels.append(level)
        if observed.steady:
            spectra.append(_periodogram(rest, observed.rate))
    speeds = np.array([observed.speed[np.linspace(s.start, s.stop - 1, POINTS).astype(int)] for s in stretches])
    duration = np.array([(s.stop - s.start) / observed.rate for s in stretches])
    band, power, count, width = _bands(spectra, stretches, observed.rate)
    return Features(
        observed=observed, stretches=tuple(stretches), places=tuple(places), amplitude=np.array(amplitudes),
        level=np.array(levels),
        speed=speeds, duration=duration, acceleration=(speeds[:, -1] - speeds[:, 0]) / duration,
        band=band, power=power, count=count, width=width,
    )  # fmt: skip


def shown_places(observed: Observed, stretch: Stretch, places: Sequence[Place]) -> list[int]:
    """Return which places the stretch can show: turning often enough, below half the rate, apart from each other."""
    speeds = np.abs(observed.speed[stretch.start : stretch.stop])
    duration = (stretch.stop - stretch.start) / observed.rate
    mean, top = float(speeds.mean()), float(speeds.max())
    shown: list[int] = []
    taken: list[float] = []
    for index, place in enumerate(places):
        at = place.frequency(mean)
        turning = at * duration >= _FEWEST_TURNS and place.frequency(top) < 0.4 * observed.rate
        if turning and all(abs(at - other) * duration >= RESOLVED for other in taken):
            shown.append(index)
            taken.append(at)
    return shown


def _lines(
    observed: Observed, stretch: Stretch, places: Sequence[Place]
) -> tuple[NDArray[np.complex128], float, Floats]:
    part = slice(stretch.start, stretch.stop)
    time = np.arange(stretch.start, stretch.stop) / observed.rate
    shown = shown_places(observed, stretch, places)
    phases = [places[index].phase(observed.angle[part], time) for index in shown]
    found = regressed(observed.torque[part], np.array(phases).reshape(len(shown), time.size))
    amplitude = np.full(len(places), np.nan, dtype=complex)
    amplitude[shown] = found.amplitude
    return amplitude, found.level, found.rest


def _periodogram(rest: Floats, rate: float) -> Floats:
    window = np.hanning(rest.size)
    spectrum = np.fft.rfft(rest * window)
    return np.asarray(2 * np.abs(spectrum) ** 2 / ((window**2).sum() * rate))


def _bands(
    spectra: Sequence[Floats], stretches: Sequence[Stretch], rate: float
) -> tuple[Floats, Floats, Floats, Floats]:
    octaves = np.log2(_HIGHEST_SHARE * rate / _LOWEST_BAND)
    edges = _LOWEST_BAND * 2 ** (np.arange(int(octaves * BANDS_PER_OCTAVE) + 1) / BANDS_PER_OCTAVE)
    if not spectra:
        return np.sqrt(edges[:-1] * edges[1:]), np.array([]), np.array([]), np.diff(edges)
    length = min(stretch.stop - stretch.start for stretch in stretches)
    frequency = np.fft.rfftfreq(length, 1 / rate)
    mean = np.mean([spectrum[: frequency.size] for spectrum in spectra], axis=0)
    index = np.searchsorted(edges, frequency, side="right") - 1
    inside = (index >= 0) & (index < edges.size - 1)
    bins = np.bincount(index[inside], minlength=edges.size - 1)
    power = np.bincount(index[inside], weights=mean[inside], minlength=edges.size - 1)
    seen = bins > 0
    middle = np.bincount(index[inside], weights=np.log(np.maximum(frequency[inside], 1e-9)), minlength=edges.size - 1)
    # a Hann window couples neighbouring bins: about 0.7 of them are independent
    count = np.asarray(0.7 * bins[seen] * len(spectra), dtype=np.float64)
    width = np.asarray(bins[seen] * (rate / length), dtype=np.float64)
    return np.exp(middle[seen] / bins[seen]), power[seen] / bins[seen], count, width
