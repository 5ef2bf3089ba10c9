"""Load of the bed on the wear part: mean torque, particle hits and slow variation, by the laws of the case."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.laws import Laws, Pulse, SlowFilter
from proof.rig_program.plan import Run


def load_course(run: Run, laws: Laws, rng: np.random.Generator, *, mean: float, samples: int) -> NDArray[np.float64]:
    """Draw the torque of the bed at every sample (n,) [Nm] around its ``mean`` [Nm]; it is never negative."""
    hits = particle_hits(run, laws, rng, samples=samples)
    slow = slow_variation(laws, rng, samples=samples)
    return np.asarray(np.maximum(mean * (1.0 + nominal.HITS_SHARE * hits + nominal.SLOW_SHARE * slow), 0.0))


def particle_hits(run: Run, laws: Laws, rng: np.random.Generator, *, samples: int) -> NDArray[np.float64]:
    """Draw Poisson hits (n,), without their mean and with the rms that Campbell's theorem gives made 1.

    Source: Rice 1944, Bell Syst. Tech. J. 23, sec. 1.2 (Campbell's theorem): the variance of pulses h(t) of size a at
    rate r is r E[a^2] times the integral of h^2.
    """
    rate, decay = nominal.hit_rate(run.occupancy, run.particle), nominal.hit_decay(run.particle)
    pulse = pulse_shape(laws.pulse, decay)
    count = int(rng.poisson(rate * samples / nominal.SAMPLE_RATE))
    sizes = rng.gamma(laws.hit_shape, 1.0 / laws.hit_shape, count)
    train = np.zeros(samples)
    np.add.at(train, rng.integers(0, samples, count), sizes)
    course = convolve(train, pulse)
    mean = rate * pulse.sum() / nominal.SAMPLE_RATE
    variance = rate * (1.0 + 1.0 / laws.hit_shape) * np.sum(pulse**2) / nominal.SAMPLE_RATE
    return np.asarray((course - mean) / np.sqrt(variance))


def pulse_shape(pulse: Pulse, decay: float) -> NDArray[np.float64]:
    """Return one hit of unit height (m,); the half-sine has the integral of the decay."""
    if pulse is Pulse.EXPONENTIAL:
        return np.asarray(np.exp(-np.arange(round(12.0 * decay * nominal.SAMPLE_RATE)) / (decay * nominal.SAMPLE_RATE)))
    length = max(round(0.5 * np.pi * decay * nominal.SAMPLE_RATE), 3)
    return np.asarray(np.sin(np.pi * (np.arange(length) + 0.5) / length))


def slow_variation(laws: Laws, rng: np.random.Generator, *, samples: int) -> NDArray[np.float64]:
    """Draw noise of unit rms below `nominal.SLOW_CORNER` (n,), shaped in the frequency domain by the law's filter."""
    step = 250
    points = samples // step + 512  # the surplus is discarded, so that the ends do not join
    spectrum = np.fft.rfft(rng.standard_normal(points))
    ratio = np.fft.rfftfreq(points, step / nominal.SAMPLE_RATE) / nominal.SLOW_CORNER
    if laws.slow_filter is SlowFilter.BUTTERWORTH:
        gain = 1.0 / np.sqrt(1.0 + ratio**4)
    elif laws.slow_filter is SlowFilter.TWO_POLES:
        gain = 1.0 / (1.0 + 0.414 * ratio**2)
    else:
        gain = np.exp(-0.3466 * ratio**2)
    both = np.concatenate([gain, gain[1:-1]]) if points % 2 == 0 else np.concatenate([gain, gain[1:]])
    coarse = np.fft.irfft(spectrum * gain, points) / np.sqrt(np.mean(both**2))
    return np.asarray(np.interp(np.arange(samples), step * np.arange(points), coarse))


def convolve(train: NDArray[np.float64], pulse: NDArray[np.float64]) -> NDArray[np.float64]:
    """Put a pulse at every spike of a train (n,), without wrapping round."""
    size = 1 << (train.size + pulse.size - 1).bit_length()
    product = np.fft.rfft(train, size) * np.fft.rfft(pulse, size)
    return np.asarray(np.fft.irfft(product, size)[: train.size])
