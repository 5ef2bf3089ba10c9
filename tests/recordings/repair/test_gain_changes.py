"""Moments at another gain: found to the sample, scaled back, and never seen in loads, tones or telegraphs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.gain_changes import GainMoment, gain_moments, with_one_gain
from torquerig.scenario.model import Scenario

START, STOP = 21_000, 26_000  # samples at 10 kHz


@pytest.fixture(scope="module", params=["steady", "ramp"])
def clean(request: pytest.FixtureRequest, wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=8.0, rate=10_000.0, profile=request.param)


def volts_of(recording: Recording) -> np.ndarray:
    return recording.channels["torque_V"].values.copy()


@pytest.mark.parametrize("factor", [0.3, 0.7, 1.6])
@pytest.mark.parametrize("zero", [0.0, 0.5])
def test_a_gain_is_found_to_the_sample_and_scaled_back(factor: float, zero: float, clean: Recording) -> None:
    volts = volts_of(clean)
    volts[START:STOP] = zero + factor * (volts[START:STOP] - zero)
    spoilt = clean.with_values("torque_V", volts)
    (found,) = gain_moments(spoilt)
    assert (found.start, found.stop) == (START, STOP)
    assert found.factor == pytest.approx(factor, rel=0.06)
    mended = volts_of(with_one_gain(spoilt, [found]))
    error = mended[START:STOP] - volts_of(clean)[START:STOP]
    # the slow part is held at both ends, the rest is as good as the factor
    assert np.std(error) < 0.1 * np.std(volts_of(clean)[START:STOP])
    assert np.array_equal(mended[:START], volts[:START])


@pytest.mark.parametrize("takes", [4, 8])
def test_a_gain_behind_an_amplifier_is_found(takes: int, clean: Recording) -> None:
    """Its edge takes some samples, and noise of the amplifier goes on."""
    gain = np.ones(clean.samples)
    gain[START:STOP] = 0.5
    gain = np.convolve(gain, np.full(takes, 1 / takes), "same")
    noise = 1e-4 * np.random.default_rng(2).standard_normal(clean.samples)
    (found,) = gain_moments(clean.with_values("torque_V", volts_of(clean) * gain + noise))
    assert (found.start, found.stop) == (pytest.approx(START, abs=takes), pytest.approx(STOP, abs=takes))
    assert found.factor == pytest.approx(0.5, rel=0.06)


def test_what_is_no_gain_is_left_alone(clean: Recording) -> None:
    volts, time = volts_of(clean), np.arange(clean.samples) / clean.sample_rate
    assert gain_moments(clean) == ()
    tone, level, noise = volts.copy(), volts.copy(), volts.copy()
    tone[START:STOP] += 0.3 * np.cos(2 * np.pi * 731.0 * time[START:STOP])
    level[START:STOP] += 0.5
    noise[START:STOP] += 0.02 * np.random.default_rng(1).standard_normal(STOP - START)
    for spoilt in (tone, level, noise):
        assert gain_moments(clean.with_values("torque_V", spoilt)) == ()


def test_moments_without_signal_are_no_gain(clean: Recording) -> None:
    volts = volts_of(clean)
    volts[START:STOP] *= 1e-3
    assert gain_moments(clean.with_values("torque_V", volts), without=[(START, STOP)]) == ()


def test_a_moment_at_the_end_is_scaled_back_too(clean: Recording) -> None:
    volts = volts_of(clean)
    volts[START:] *= 0.5
    mended = with_one_gain(clean.with_values("torque_V", volts), [GainMoment(START, volts.size, 0.5)])
    assert np.std(volts_of(mended)[START:] - volts_of(clean)[START:]) < 1e-3 * np.std(volts_of(clean))
