"""Comb, synchronous average, Vold-Kalman and adaptive canceller: what goes, what stays, the delay they state."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.filters.adaptive_canceller import AdaptiveCanceller
from torquerig.filters.comb import CausalComb, Comb
from torquerig.filters.synchronous_average import SynchronousAverage, mean_turn
from torquerig.filters.vold_kalman import VoldKalman, smoothest
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE = 5000.0
AT = np.arange(100_000) / RATE
SPEED = 1000 * pi / 30
ALL = Kinematics(pole_pairs=7, slots=12, ratio=5).lines()
LINES = tuple(line for line in ALL if line.motor_order < 90)
SHAFT = tuple(line for line in ALL if line.family == "shaft" and line.harmonic == 1)
ORDERS = sorted({round(line.motor_order, 9) for line in LINES})


def turned(share):
    return np.cumsum(SPEED * (1 + share * np.sin(2 * pi * 0.1 * AT))) / RATE


def disturbance(angle, orders=ORDERS):
    phases = np.random.default_rng(4).uniform(0, 2 * pi, len(orders))
    return sum(0.5 * np.cos(order * angle + phase) for order, phase in zip(orders, phases, strict=True))


def recording(torque, angle=None):
    channels = {"torque_V": Channel(values=torque, quantity="torque", unit="V")}
    if angle is not None:
        channels["motor_angle_rad"] = Channel(values=angle, quantity="motor_angle", unit="rad")
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=SPEED, gear_ratio=5))


def rms(values):
    return float(np.sqrt(np.mean(values**2)))


def decibel(left, before):
    return 20 * np.log10(rms(left) / rms(before))


@pytest.mark.parametrize(
    ("stage", "highest"),
    # a mean turn of 1500 points with straight lines between: 84 output orders lose 1 % of themselves
    [(VoldKalman(lines=LINES), 90), (SynchronousAverage(ratio=5.0), 17)],
)
def test_lines_under_wander_go_and_slow_load_stays(stage, highest):
    angle = turned(0.02)
    lines = disturbance(angle, [order for order in ORDERS if order < highest])
    load = 2.0 + 0.1 * np.sin(2 * pi * 0.37 * AT)
    left = stage.apply(recording(load + lines, angle)).torque() - load
    assert decibel(left, lines) < -35


def test_a_learner_has_the_lines_once_it_has_learned():
    angle = turned(0.02)
    lines = disturbance(angle)
    left = AdaptiveCanceller(lines=LINES).apply(recording(2.0 + lines, angle)).torque() - 2.0
    late = AT > 10  # 15 time constants of 0.64 s
    assert decibel(left[late], lines[late]) < -60
    assert decibel(left[AT < 0.1], lines[AT < 0.1]) > -10


def test_a_learner_is_a_notch_of_the_stated_width():
    # Widrow 1975: at half_width beside the line the gain is 1 / sqrt(2)
    line = LINES[4:5]  # motor order 1, 16.7 Hz
    beside = line[0].frequency(SPEED) + 0.25
    wave = np.exp(2j * pi * beside * AT)
    stage = AdaptiveCanceller(lines=line, half_width=0.25)
    angle = SPEED * AT
    answer = sum(
        unit * stage.apply(recording(part, angle)).torque() for unit, part in ((1, wave.real), (1j, wave.imag))
    )
    late = AT > 15
    gain = abs(np.mean(answer[late] * wave.conj()[late]))
    assert gain == pytest.approx(1 / np.sqrt(2), rel=0.02)


def test_a_learner_states_its_delay():
    stage = AdaptiveCanceller(lines=LINES)
    late = (AT - stage.apply(recording(AT, SPEED * AT)).torque())[AT > 15].mean()
    assert late == pytest.approx(stage.delay(recording(AT)), rel=0.05)


def test_the_smoothest_amplitude_has_half_its_power_at_the_stated_width():
    # 800 hops of one sample; Tuma 2005: -3 dB at the width
    hops, width = 800, 0.02
    wave = np.cos(2 * pi * width * np.arange(hops))
    found = smoothest(0.5 * wave[None, None, :].repeat(2, axis=0), np.ones(hops), half_width=width)
    middle = slice(200, 600)
    assert np.std(found[0, 0, :-1][middle]) / np.std(wave[middle]) == pytest.approx(1 / np.sqrt(2), rel=0.02)
    constant = smoothest(np.ones((2, 1, hops)), np.ones(hops), half_width=width)
    assert constant == pytest.approx(2.0, abs=1e-6)


@pytest.mark.parametrize("stage", [Comb(lines=SHAFT), CausalComb(lines=SHAFT)])
def test_a_comb_takes_every_harmonic_and_keeps_mean_and_slow_load(stage):
    angle = SPEED * AT
    # 1500 samples a turn: harmonics up to the 25th stand below 84 Hz
    lines = disturbance(angle, [0.2 * n for n in range(1, 26)])
    slow = 2.0 + 0.5 * np.sin(2 * pi * 0.04 * AT)
    answer = stage.apply(recording(slow + lines, angle)).torque()
    learned = slice(int(21 * 0.3 * RATE), None)
    assert decibel((answer - slow)[learned], lines[learned]) < -35
    assert answer.mean() == pytest.approx(slow.mean(), abs=0.02)


def test_a_comb_works_where_the_period_is_no_whole_number_of_samples():
    speed = SPEED * 1.00137
    angle = speed * AT
    lines = disturbance(angle, [0.2 * n for n in range(1, 26)])
    left = Comb(lines=SHAFT).apply(recording(2.0 + lines, angle)).torque() - 2.0
    assert decibel(left, lines) < -45


def test_a_causal_comb_states_its_delay():
    stage = CausalComb(lines=SHAFT)
    late = (AT - stage.apply(recording(AT)).torque())[AT > 10].mean()
    assert stage.delay(recording(AT)) == pytest.approx(0.15)
    assert late == pytest.approx(0.15, rel=1e-3)


def test_the_mean_turn_is_the_mean():
    turns = np.arange(4000) / 100  # forty turns of a hundred samples
    rng = np.random.default_rng(2)
    values = rng.normal(size=4000)
    assert mean_turn(values, turns, 100) == pytest.approx(values.reshape(40, 100).mean(axis=0), abs=1e-6)


def test_an_average_over_n_turns_takes_an_nth_of_the_noise_power():
    noise = np.random.default_rng(3).normal(size=AT.size)
    left = SynchronousAverage(ratio=5.0).apply(recording(noise, SPEED * AT)).torque()
    turns = SPEED * AT[-1] / (2 * pi * 5)
    # straight lines between the points take 2/3 of it on the mean, at the points all of it
    assert 0.5 / turns < np.mean((noise - left) ** 2) < 1.1 / turns


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Comb(lines=SHAFT, periods=0), "at least 1"),
        (lambda: VoldKalman(lines=LINES, half_width=0.0), "are not possible"),
        (lambda: VoldKalman(lines=LINES, half_width=3.0), "less than 2"),
        (lambda: AdaptiveCanceller(lines=LINES, half_width=0.0), "above 0 Hz"),
        (lambda: SynchronousAverage(ratio=0.0), "more than 0"),
    ],
)
def test_stages_that_cannot_be_are_refused(make, message):
    with pytest.raises(InputError, match=message):
        make()


@pytest.mark.parametrize(
    ("stage", "message"),
    [
        (Comb(lines=SHAFT), "three of them"),
        (VoldKalman(lines=LINES), "turns less than once"),
        (SynchronousAverage(ratio=5.0), "needs 2"),
        (AdaptiveCanceller(lines=LINES, half_width=60.0), "make them narrower"),
    ],
)
def test_recordings_that_cannot_serve_are_refused(stage, message):
    short = slice(0, 500)
    with pytest.raises(RecordingError, match=message):
        stage.apply(recording(AT[short], SPEED * AT[short]))
