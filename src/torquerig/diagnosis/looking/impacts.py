"""Impacts that ring: orders of the shaft at which the envelope of a band beats."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

_LOWEST, _OCTAVES = 400.0, 0.5  # [Hz] below, shafts ring by themselves; width of a band
_ORDERS = (0.1, 20.0)  # of the motor shaft
_STEP = 0.002  # [1/rev of the motor]
_CLEAR = 8.0  # summed log power over the local floor, for each run; 29 clean rigs reach 5.7 at most
_HARMONICS = 3
_RESOLVED = 2.5  # steps of the spectrum: half the main lobe of a Hann window and half a step
_MOST_PARTS, _BETWEEN = 5, 2.0  # mean log power at the other multiples of a lower order; 0.2 by chance
_CLEARLY = 1.15  # times as clear at one rate as at one order
_AS_STRONG = 0.7  # of log power below the order's own multiples: rings that come and go leave a quarter, 1.4 below


@dataclass(frozen=True)
class Impact:
    """A band [Hz] that is struck ``motor_order`` times a turn of the motor, and how clearly [1]."""

    motor_order: float
    band: float
    clearness: float


def impact_orders(runs: Sequence[Observed], known: Sequence[Place]) -> tuple[Impact, ...]:
    """Return the clearest beats of each band's squared envelope over the motor's angle, best first, at most two.

    Squared envelope spectrum in the angle domain (Randall & Antoni 2011, MSSP 25(2)), summed over the first three
    harmonics and over the steady runs. Bands whose beat is a line of the model's own families are left out.
    """
    steady = [run for run in runs if run.steady]
    if not steady:
        return ()
    found: list[Impact] = []
    top = 0.42 * min(run.rate for run in steady)
    centre = _LOWEST * 2 ** (0.5 * _OCTAVES)
    orders = np.arange(*_ORDERS, _STEP)
    while centre < top:
        beats = [_beats(run, centre) for run in steady]
        score = np.sum([beat.score(orders) for beat in beats], axis=0)
        best = int(np.argmax(score))
        at = _fundamental(beats, float(orders[best]), known)
        if score[best] > _CLEAR * len(steady) and not (_of_family(at, known) or _keeps_its_rate(beats, at)):
            found.append(Impact(at, centre, float(score[best])))
        centre *= 2**_OCTAVES
    found.sort(key=lambda impact: -impact.clearness)
    return tuple(found[:2])


def _of_family(at: float, known: Sequence[Place]) -> bool:
    """Whether a beat is a difference of the model's own lines: a whole or fifth order of the motor."""
    return bool(_from_family(np.array([at]), known)[0] < 2 * _STEP)


def _from_family(at: Floats, known: Sequence[Place]) -> Floats:
    """Return how far orders lie from the next difference of the model's own lines [1/rev of the motor]."""
    spacing = min((place.at for place in known if place.domain == "order"), default=1.0)
    return np.asarray(np.abs(at / spacing - np.round(at / spacing)) * spacing)


def _keeps_its_rate(beats: Sequence[_Beats], at: float) -> bool:
    """Whether runs of other speeds beat at the rate that the order has in one of them, and not at the order."""
    turning = float(np.sum([beat.near(at) for beat in beats]))
    rates = [at * beat.speed for beat in beats]
    return any(sum(beat.near(rate / beat.speed) for beat in beats) > _CLEARLY * turning for rate in rates)


@dataclass(frozen=True)
class _Beats:
    """Log power of a squared envelope over its local floor, at multiples of ``step`` [1/rev of the motor].

    ``speed`` is the motor's mean [rad/s].
    """

    log: Floats
    step: float
    speed: float

    def at(self, orders: Floats) -> Floats:
        """Return the log power at each order, 0 beyond."""
        return np.asarray(np.interp(orders / self.step, np.arange(self.log.size), self.log, right=0.0))

    def near(self, order: float) -> float:
        """Return the largest score within what the spectrum resolves of an order."""
        return float(self.score(order + self.step * np.linspace(-_RESOLVED, _RESOLVED, 11)).max())

    def score(self, orders: Floats) -> Floats:
        """Return the log power summed over the first harmonics of each order."""
        return np.asarray(sum(self.at(orders * harmonic) for harmonic in range(1, _HARMONICS + 1)))


def _beats(run: Observed, centre: float) -> _Beats:
    used = [stretch for stretch in run.stretches if not stretch.held]
    part = slice(used[0].start, used[-1].stop)
    envelope = _squared_envelope(run.torque[part], run.rate, centre)
    angle = run.angle[part]
    even = np.linspace(angle[0], angle[-1], envelope.size)
    power = np.abs(np.fft.rfft((np.interp(even, angle, envelope) - envelope.mean()) * np.hanning(envelope.size))) ** 2
    step = 2 * pi / abs(float(angle[-1] - angle[0]))
    size = int(_ORDERS[1] * (_HARMONICS + 1) / step)
    return _Beats(np.log(np.maximum(_over_floor(power[:size]), 1.0)), step, abs(run.mean_speed))


def _fundamental(beats: Sequence[_Beats], at: float, known: Sequence[Place]) -> float:
    """Return the lowest order of which ``at`` is a multiple and whose other multiples beat too.

    Those say nothing that a Hann window does not tell from what stands beside the multiples of ``at`` itself, by
    differences of the model's own lines, unless they are as strong as these: a load makes rings stronger and weaker as
    the shaft turns, and what it makes of a line at either side is a quarter of its power at most.
    """
    resolved = _RESOLVED * max(beat.step for beat in beats)
    own = _mean_log(beats, at * np.array([1.0, 2.0]))
    for divisor in range(_MOST_PARTS, 1, -1):
        between = np.array([h for h in range(1, 2 * divisor) if h % divisor]) * at / divisor
        apart = [_from_family(between - multiple * at, known) for multiple in (0, 1, 2)]
        told = between[np.min(apart, axis=0) > resolved]
        beating = told.size > 0 and _mean_log(beats, told) > _BETWEEN
        if beating or _mean_log(beats, between) > max(_BETWEEN, own - _AS_STRONG):
            return at / divisor
    return at


def _mean_log(beats: Sequence[_Beats], orders: Floats) -> float:
    return float(np.mean([beat.at(orders).mean() for beat in beats]))


def _squared_envelope(values: Floats, rate: float, centre: float) -> Floats:
    spectrum = np.fft.rfft(values - values.mean())
    frequency = np.fft.rfftfreq(values.size, 1 / rate)
    half = 2 ** (0.5 * _OCTAVES)
    inside = (frequency > centre / half) & (frequency < centre * half)
    analytic = np.zeros(values.size, dtype=complex)
    analytic[: spectrum.size][inside] = 2 * spectrum[inside]
    return np.asarray(np.abs(np.fft.ifft(analytic)) ** 2)


def _over_floor(power: Floats) -> Floats:
    from scipy.ndimage import median_filter

    return np.asarray(power / np.maximum(median_filter(power, size=101, mode="nearest") / np.log(2), 1e-300))
