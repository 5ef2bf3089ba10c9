"""What the measuring chain adds to the reading and what it passes on: noise, cross-talk and the logger's low-pass."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.sensor_stages.band_noise import BandNoise
from torquerig.sensor_stages.converter import Converter
from torquerig.sensor_stages.crosstalk import Crosstalk
from torquerig.sensor_stages.flicker import FlickerNoise
from torquerig.sensor_stages.logger_low_pass import LoggerLowPass
from torquerig.sensor_stages.noise import WhiteNoise
from torquerig.sensor_stages.rounding import Rounding

Floats = NDArray[np.float64]

_ROUNDING = 12.0  # variance of a number that is rounded to whole steps is 1/12 (Widrow & Kollar)

_COLOUR = 1.5  # of the logarithm: the error of a slow signal may be a fifth of white noise in a band, or five times it


def chain_noise(rig: Rig, seen: RunFeatures) -> Floats:
    """Return the density of the noise of the measuring chain in each band [(N m)^2/Hz].

    Stages come in the order of the signal: the logger's low-pass leaves what follows it.
    """
    bands, unit, rate = seen.bands, seen.unit, seen.run.rate
    power = np.zeros(bands.low.size)
    for stage in rig.stages():
        if isinstance(stage, WhiteNoise | FlickerNoise):
            power += unit**2 * stage.density(bands.middle, rate)
        elif isinstance(stage, BandNoise):
            power += unit**2 * stage.density_between(bands.low, bands.high)
        elif isinstance(stage, Rounding | Converter):
            power += unit**2 * stage.step**2 / _ROUNDING / (0.5 * rate)
        elif isinstance(stage, LoggerLowPass):
            power *= _passed(stage, bands.middle)
    return power


def rounding_error(rig: Rig, seen: RunFeatures, density: Floats) -> Floats:
    """Return how uncertain the logarithm of the density in each band is because codes are coarse [1].

    White noise of rms s before a rounding to steps q leaves the share ``exp(-(2 pi s / q)^2)`` of the error's variance
    ``q^2 / 12`` that is not white: a twentieth at s = 0.28 q. It follows the signal, so that most of it is where the
    signal is and little at high frequencies. Source: autocorrelation of the error for Gaussian signals (Sripad & Snyder
    1977, IEEE Trans. Acoust., Speech, Signal Process. 25; Widrow & Kollar 2008, Quantization Noise).
    """
    noise, coloured = 0.0, 0.0
    for stage in rig.stages():
        if isinstance(stage, WhiteNoise):
            noise = float(np.hypot(noise, stage.rms))
        elif isinstance(stage, Rounding | Converter) and stage.step > 0:
            coloured += stage.step**2 * float(np.exp(-((2 * pi * noise / stage.step) ** 2)))
    return np.asarray(_COLOUR * seen.unit**2 * coloured / _ROUNDING / (0.5 * seen.run.rate) / density)


def crosstalk_lines(twin: Twin, seen: RunFeatures) -> tuple[Floats, Floats]:
    """Return frequencies [Hz] and amplitudes [N m] of the bending that the sensor reads, shape (lines, segments)."""
    turning = np.abs(seen.speed)
    frequency, amplitude = list[Floats](), list[Floats]()
    for stage in twin.rig.stages():
        if isinstance(stage, Crosstalk):
            shaft = np.abs(stage.turns) * turning
            for order, size in ((1.0, stage.once), (2.0, stage.twice), (1.0, stage.once_by_speed_squared * shaft**2)):
                if np.any(size):
                    at = order * shaft / (2 * pi)
                    frequency.append(at)
                    amplitude.append(size * np.abs(twin.amplifier(at)))
    shape = (len(frequency), turning.size)
    return np.array(frequency).reshape(shape), np.array(amplitude).reshape(shape)


def passed_by_logger(rig: Rig, frequency: Floats) -> Floats:
    """Return the share of the power at frequencies [Hz] that the logger's low-pass leaves [1]."""
    power = np.ones_like(frequency)
    for stage in rig.stages():
        if isinstance(stage, LoggerLowPass):
            power = power * _passed(stage, frequency)
    return power


def _passed(stage: LoggerLowPass, frequency: Floats) -> Floats:
    """Return the share of the power that a Butterworth low-pass leaves [1]; a Bessel one is taken for it."""
    return np.asarray(1 / (1 + (frequency / stage.cutoff) ** (2 * stage.order)))
