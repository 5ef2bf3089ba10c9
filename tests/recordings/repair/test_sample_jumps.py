"""Jumps of a sample stand alone: steps do, blows that ring, coarse codes and ends of lost moments do not."""

from __future__ import annotations

import numpy as np
from scipy.signal import lfilter

from torquerig.recordings.repair.sample_jumps import sample_jumps

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
