"""Jumps of a sample stand alone: steps do, blows that ring, coarse codes and ends of lost moments do not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.signal import lfilter

from torquerig.diagnosis.sample_findings import sample_findings
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.sample_jumps import sample_jumps
from torquerig.scenario.model import Scenario

RATE = 25000.0
TIME = np.arange(int(2 * RATE)) / RATE
NOISE = 3e-3 * np.random.default_rng(5).standard_normal(TIME.size)
SMOOTH = 1.0 + 0.3 * np.sin(2 * np.pi * 20.0 * TIME) + NOISE
AT = [5000, 17321, 40000]


def test_a_gain_that_changes_jumps_where_it_does() -> None:
    gain = np.ones(TIME.size)
    gain[AT[0] : AT[1]] = gain[AT[2] :] = 1.2
    assert sample_jumps(SMOOTH * gain).tolist() == AT


def test_no_noise_and_no_smooth_signal_does() -> None:
    assert sample_jumps(SMOOTH).size == 0


def test_blows_that_ring_do_not() -> None:
    """Through an amplifier of 2 kHz, in discrete time by matched poles."""
    blows = np.zeros(TIME.size)
    blows[AT] = 3.0
    pole = np.exp((-0.3 + 1j * np.sqrt(1 - 0.3**2)) * 2 * np.pi * 2000.0 / RATE)
    ringing = lfilter([0.0, 1.0], np.poly([pole, pole.conjugate()]).real, blows)
    assert np.abs(np.diff(ringing)).max() > 100 * 3e-3
    assert sample_jumps(SMOOTH + ringing).size == 0


def test_the_ends_of_lost_moments_do_not() -> None:
    lost = SMOOTH.copy()
    lost[AT[0] : AT[1]] = -0.5
    assert sample_jumps(lost).tolist() == AT[:2]
    assert sample_jumps(lost, [(AT[0], AT[1])]).size == 0


def test_steps_of_a_code_do_not() -> None:
    codes = np.round(SMOOTH / 0.05) * 0.05
    assert sample_jumps(codes, resolution=0.05).size == 0


@pytest.mark.long
def test_they_are_told_where_no_gain_can_be(record: Callable[..., Recording], wear_rig: Scenario) -> None:
    """A gain that is higher for half of the time, so that nobody knows which one is usual."""
    clean = record(wear_rig.rig, 3, duration=8.0, rate=10_000.0)
    volts = clean.channels["torque_V"].values.copy()
    changes = [9_000, 20_000, 31_000, 43_000, 55_000, 66_000]
    for start, stop in zip(changes[::2], changes[1::2], strict=True):
        volts[start:stop] *= 1.2
    told = dict(sample_findings([clean.with_values("torque_V", volts)], wear_rig.rig).untrue)
    (sentence,) = [each for each in told if "from one sample to the next" in each]
    assert "0.9, 2, 3.1, 4.3 s and later" in sentence
    assert (told[sentence].domain, told[sentence].at) == ("time", pytest.approx(0.9))
    assert sample_findings([clean], wear_rig.rig).untrue == ()
