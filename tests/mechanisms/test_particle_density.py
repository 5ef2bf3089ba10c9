"""The particle load's spectral density: against its own samples and against its closed-form variance."""

from dataclasses import replace

import numpy as np
import pytest

from torquerig.mechanisms.particle_load import ParticleProcess

PROCESS = ParticleProcess(mean=1.0, rate=400.0, decay=0.004, shape=1.5, hit_rms=0.05, slow_rms=0.03, slow_cutoff=1.5)


RISING = replace(PROCESS, rise=0.0015)


@pytest.mark.parametrize("process", [PROCESS, RISING])
def test_density_integrates_to_the_variance(process: ParticleProcess) -> None:
    frequencies = np.linspace(0.0, 20_000.0, 2_000_001)
    variance = np.trapezoid(process.density(frequencies), frequencies)
    assert variance == pytest.approx(0.05**2 + 0.03**2, rel=5e-3)


@pytest.mark.parametrize("process", [PROCESS, RISING])
def test_density_is_that_of_the_samples(process: ParticleProcess) -> None:
    from scipy.signal import welch

    rate = 2000.0
    values = process.sample(400_000, rate, np.random.default_rng(3))
    frequencies, power = welch(values, rate, nperseg=8000)
    band = (frequencies > 5.0) & (frequencies < 100.0)
    ratio = power[band] / process.density(frequencies[band])
    assert ratio.mean() == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize("course", [0, 1])
def test_hits_of_another_course_have_its_spectrum_and_the_same_variance(course: int) -> None:
    decay, rate = PROCESS.decay, 2e5
    t = (np.arange(int(8 * decay * rate)) + 0.5) / rate
    half_sine = np.where(t < 0.5 * np.pi * decay, np.sin(2 * t / decay), 0.0)
    pulse = (half_sine, np.maximum(1 - t / (2 * decay), 0.0))[course]
    hits = replace(PROCESS, slow_rms=0.0)
    for frequency in (1.0, 40.0, 90.0, 1.5 / (0.5 * np.pi * decay)):
        passed = np.abs(np.sum(pulse * np.exp(-2j * np.pi * frequency * t)) / rate) ** 2
        expected = 2 * 0.05**2 * passed / (np.sum(pulse**2) / rate)
        assert hits.shaped_densities(np.array([frequency]))[course, 0] == pytest.approx(expected, rel=2e-3, abs=1e-10)
    frequencies = np.linspace(0.0, 20_000.0, 2_000_001)
    variance = np.trapezoid(PROCESS.shaped_densities(frequencies)[course], frequencies)
    assert variance == pytest.approx(0.05**2 + 0.03**2, rel=5e-3)
