"""Laws that a scenario states: spectrum of turbulence, corner of noise, attenuation of a logger's filter."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt
from typing import Any

import numpy as np
import pytest
from scipy.signal import bessel, freqs, freqz, welch

from torquerig.mechanisms import TurbulentLoad
from torquerig.mechanisms.turbulent_load import Turbulence
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Gear, Motor, SpeedController
from torquerig.rig.steady import steady_torque
from torquerig.rig.terms import Load
from torquerig.sensor_stages.flicker import FlickerNoise
from torquerig.sensor_stages.logger_low_pass import LoggerLowPass, _sections

RATE = 1000.0  # [Hz]


def constant(level: float, count: int) -> Recording:
    values = np.full(count, level)
    return Recording(sample_rate=RATE, channels={"torque_V": Channel(quantity="torque", unit="V", values=values)})


def fan(**law: Any) -> Rig:
    return Rig(
        (
            Motor(name="motor", inertia=1e-4, torque_limit=50.0),
            Gear(name="gearbox", after="motor", ratio=5.0, stiffness=1000.0, damping=1.0),
            Body(name="fan", after="gearbox", inertia=2e-3),
            SpeedController(name="loop", kp=0.05, ki=1.0),
            TurbulentLoad(name="air", at="fan", **law),
        ),
        Run(speed=100.0), measured="gearbox",
    )  # fmt: skip


@pytest.mark.parametrize("speed", [50.0, 100.0])
def test_the_mean_follows_the_speed_and_its_square(speed: float) -> None:
    made = fan(linear=0.01, quadratic=2e-3, turbulence=0.2, turbulence_cutoff=3.0)
    at_fan = speed / 5
    expected = (0.01 * at_fan + 2e-3 * at_fan**2) / 5
    assert steady_torque(made.at(replace(made.run, speed=speed)), "motor") == pytest.approx(expected, rel=1e-9)


def test_the_turbulence_is_a_share_of_the_mean_at_the_set_point() -> None:
    (load,) = (term for term in fan(quadratic=2e-3, turbulence=0.2, turbulence_cutoff=3.0).terms()
               if isinstance(term, Load))  # fmt: skip
    assert isinstance(load.process, Turbulence)
    assert load.process.rms == pytest.approx(0.2 * 2e-3 * 20**2)


def test_turbulence_has_its_spectrum() -> None:
    """400 averages: each band is known to 5 %, and 20 % is four of its standard deviations."""
    process = Turbulence(rms=0.5, cutoff=20.0)
    samples = process.sample(400_000, RATE, np.random.default_rng(1))
    assert samples.std() == pytest.approx(0.5, rel=0.02)
    assert abs(samples.mean()) < 0.02
    at, found = welch(samples, RATE, nperseg=2000)
    shown = (at >= 2) & (at <= 100)  # folding at 500 Hz adds 1 % at 100 Hz
    assert found[shown] == pytest.approx(process.density(at[shown]), rel=0.3)
    assert found[shown].sum() == pytest.approx(process.density(at[shown]).sum(), rel=0.05)


def test_turbulence_without_a_spectrum_is_refused() -> None:
    with pytest.raises(ValueError, match="add turbulence_cutoff"):
        TurbulentLoad(name="air", quadratic=1e-3, turbulence=0.1)


@pytest.mark.parametrize("exponent", [1.0, 2.0])
def test_flicker_noise_equals_the_white_noise_at_its_corner(exponent: float) -> None:
    stage = FlickerNoise(rms=0.1, corner=50.0, exponent=exponent)
    quiet = Recording(
        name="quiet",
        sample_rate=RATE,
        channels={"torque_V": Channel(quantity="torque", unit="V", values=np.zeros(200_000))},
    )
    at, found = welch(stage.apply(quiet).torque(), RATE, nperseg=2000)
    shown = (at >= 5) & (at <= 200)
    assert found[shown].sum() == pytest.approx(stage.density(at[shown], RATE).sum(), rel=0.1)
    near = np.abs(at - 50) < 5
    assert found[near].mean() == pytest.approx(2 * 0.1**2 / RATE, rel=0.15)


@pytest.mark.parametrize("order", [1, 2, 3, 5, 8, 10])
@pytest.mark.parametrize("cutoff", [0.5, 20.0])
def test_the_loggers_butterworth_has_its_attenuation(order: int, cutoff: float) -> None:
    """Straight lines between samples cost ``sinc^2``, 0.53 % at 0.04 of the rate, in every section."""
    at = cutoff * np.array([0.2, 0.5, 1.0, 2.0])
    response = np.ones(at.size, dtype=complex)
    for b, a in _sections(cutoff, order, "butterworth", RATE):
        response *= freqz(b, a, at, fs=RATE)[1]
    expected = 1 / np.sqrt(1 + (at / cutoff) ** (2 * order))
    assert np.abs(response) == pytest.approx(expected, rel=6e-3 * order)


def test_the_loggers_bessel_is_3_db_down_at_its_cutoff_and_as_the_analog_one_below() -> None:
    at = np.array([2.0, 10.0, 20.0])
    response = np.ones(at.size, dtype=complex)
    for b, a in _sections(20.0, 4, "bessel", RATE):
        response *= freqz(b, a, at, fs=RATE)[1]
    analog = freqs(*bessel(4, 2 * pi * 20.0, analog=True, norm="mag"), worN=2 * pi * at)[1]
    assert abs(response[-1]) == pytest.approx(1 / sqrt(2), rel=1e-2)
    assert response == pytest.approx(analog, rel=2e-2)


def test_a_constant_passes_unchanged() -> None:
    flat = Recording(
        name="flat",
        sample_rate=RATE,
        channels={"torque_V": Channel(quantity="torque", unit="V", values=np.full(100, 0.3))},
    )
    assert np.array_equal(LoggerLowPass(cutoff=5.0, order=6).apply(flat).torque(), flat.torque())
