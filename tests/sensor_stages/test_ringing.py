"""Ringing: impacts at their angles, between samples, in either direction, ringing as a damped mode does."""

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.recordings.recording import Channel, Recording
from torquerig.sensor_stages.ringing import Ringing

RATE = 25_000.0


def rung(angle, seed=7, sensitivity=1.0, **values):
    stated = {"order": 3.572, "frequency": 2000.0, "damping": 0.05, "amplitude": 0.2}
    channels = {
        "torque_V": Channel(values=np.zeros(angle.size), quantity="torque", unit="V", si_per_unit=1 / sensitivity),
        "true_motor_angle_rad": Channel(values=angle, quantity="motor_angle", unit="rad", truth=True),
    }
    source = Recording(sample_rate=RATE, channels=channels, origin={"seed": seed})
    return Ringing(**{**stated, **values}).apply(source).channels["torque_V"].values


def steady(turns_per_second, seconds):
    return 2 * np.pi * turns_per_second * np.arange(int(seconds * RATE)) / RATE


def envelope_orders(values, turns_per_second, highest):
    """The strongest line of the squared envelope up to ``highest`` per turn, and its order."""
    from scipy.signal import hilbert

    power = np.abs(hilbert(values)) ** 2
    levels = np.abs(np.fft.rfft((power - power.mean()) * np.hanning(power.size)))
    orders = np.fft.rfftfreq(power.size, 1 / RATE) / turns_per_second
    levels[orders > highest] = 0.0
    return orders[np.argmax(levels)]


@pytest.mark.parametrize("turns_per_second", [3.0, 7.0])
def test_the_envelope_repeats_at_the_order_whatever_the_speed(turns_per_second):
    values = rung(steady(turns_per_second, 8.0))
    # a record of 8 s at 3 turns a second resolves 0.04 1/rev
    assert envelope_orders(values, turns_per_second, 5.0) == pytest.approx(3.572, abs=0.05)


@pytest.mark.parametrize("turns_per_second", [3.0, 7.0])
def test_the_ring_frequency_stays_where_it_is(turns_per_second):
    values = rung(steady(turns_per_second, 8.0))
    levels = np.convolve(np.abs(np.fft.rfft(values)) ** 2, np.ones(161) / 161, mode="same")
    assert np.argmax(levels) / 8.0 == pytest.approx(2000.0, abs=60.0)  # a mode of 5 % is 200 Hz wide


def test_impacts_ring_as_the_equation_says_and_fall_between_samples():
    values = rung(steady(1.0, 0.5), order=47.0, frequency=900.0, damping=0.1, amplitude=0.3, sensitivity=2.0)
    apart = RATE / 47  # 531.9 samples; a ringing is over (6e-6) before the next
    since = (np.linspace(0, 1, 2001)[:, None] + np.arange(400)) / RATE
    expected = 0.6 * np.exp(-2 * np.pi * 0.1 * 900 * since) * np.sin(2 * np.pi * 900 * since)
    loud = np.flatnonzero(np.abs(values) > 1e-3)
    starts = []
    for first in loud[np.concatenate([[True], np.diff(loud) > 150])]:
        misses = np.abs(expected[:, : values[first:].size] - values[first : first + 400]).max(axis=1)
        # the grid of starts is 20 ns fine, half of which is 0.6 * 2 pi 900 * 10 ns
        assert misses.min() < 4.5e-5
        starts.append(first - np.argmin(misses) / 2000)
    assert len(starts) > 20
    assert np.diff(starts) == pytest.approx(apart, abs=2e-3)


def test_there_are_as_many_impacts_as_turns_times_order_forwards_and_backwards():
    forward = steady(5.0, 4.0)
    there_and_back = np.concatenate([forward, forward[::-1]])
    for angle, expected in ((forward, 20 * 3.572), (forward[::-1], 20 * 3.572), (there_and_back, 40 * 3.572)):
        values = rung(angle, frequency=6000.0, damping=0.5)
        loud = np.flatnonzero(np.abs(values) > 0.01)
        impacts = 1 + np.count_nonzero(np.diff(loud) > 20)  # a ringing is over after 5 samples
        assert impacts == pytest.approx(expected, abs=2)


def test_energy_is_that_of_independent_ringings():
    """One ringing holds A^2 (1/(4 a)) (1 - zeta^2/(1 + zeta^2)), a = 2 pi zeta f, if the next comes after it died."""
    values = rung(steady(5.0, 10.0), damping=0.1)
    decay = 2 * np.pi * 0.1 * 2000.0
    one = 0.2**2 / (4 * decay) * (1 - 0.01 / 1.01)
    assert np.sum(values**2) / RATE == pytest.approx(50 * 3.572 * one, rel=0.01)


@pytest.mark.long
def test_the_density_of_a_band_is_the_mean_of_its_density():
    """A band that a narrow mode stands in at its edge holds far more than the density at its middle says."""
    ring = Ringing(order=3.0, frequency=1000.0, damping=0.01, amplitude=0.3, load_zone=0.4)
    low, high = np.array([10.0, 910.0, 1000.0, 1090.0]), np.array([910.0, 995.0, 1090.0, 9000.0])
    fine = [np.linspace(*edges, 2_000_001) for edges in zip(low, high, strict=True)]
    means = [ring.density(each, 30.0).mean() for each in fine]
    assert ring.density_between(low, high, 30.0) == pytest.approx(means, rel=1e-4)
    assert means[2] > 3 * ring.density(np.array([1045.0]), 30.0)[0]


def test_slip_smears_the_high_harmonics_and_keeps_the_low_ones():
    exact, slipping = (
        np.abs(np.fft.rfft(np.abs(rung(steady(5.0, 40.0), slip=slip, damping=0.1)))) for slip in (0.0, 0.02)
    )
    first = 3.572 * 5 * 40
    low, high = (slice(round(k * first) - 5, round(k * first) + 6) for k in (1, 20))
    assert slipping[low].max() > 0.3 * exact[low].max()
    assert slipping[high].max() < 0.3 * exact[high].max()


def test_the_load_zone_modulates_once_a_turn():
    values = rung(steady(5.0, 20.0), load_zone=0.6, order=40.0)
    assert envelope_orders(values, 5.0, 5.0) == pytest.approx(1.0, abs=0.02)


def test_zero_amplitude_changes_nothing_and_the_seed_fixes_the_rest():
    angle = steady(5.0, 0.2)
    assert not rung(angle, amplitude=0.0).any()
    assert np.array_equal(rung(angle, slip=0.01), rung(angle, slip=0.01))
    assert not np.array_equal(rung(angle), rung(angle, seed=8))


@pytest.mark.parametrize("wrong", [{"order": 0.0}, {"damping": 0.0}, {"slip": 0.5}, {"load_zone": 2.0}])
def test_impacts_that_cannot_be_are_refused(wrong):
    with pytest.raises(InputError, match="cannot be"):
        rung(steady(5.0, 0.1), **wrong)


def test_a_mode_above_half_the_sample_rate_is_refused():
    with pytest.raises(InputError, match="cannot be sampled"):
        rung(steady(5.0, 0.1), frequency=12_500.0)
