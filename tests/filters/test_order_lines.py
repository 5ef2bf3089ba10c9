"""Stages that follow the angle: order band-stop and weighed lines, under wander, in ramps, beside broadband load."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.filters.block_regression import block_amplitudes, blocks_of
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.filter_effect import chain_effect
from torquerig.filters.order_bandstop import OrderBandstop
from torquerig.filters.removed_lines import no_line_text
from torquerig.filters.weighted_lines import WeightedLines
from torquerig.orders.analysis.order_envelope import hop_sums, hops_of, resolved_orders, without_lines
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.sensor_stages.encoder import Encoder

RATE = 5000.0
AT = np.arange(100_000) / RATE
SPEED = 1000 * pi / 30
LINES = tuple(line for line in Kinematics(pole_pairs=7, slots=12, ratio=5).lines() if line.motor_order < 90)
ORDERS = sorted({round(line.motor_order, 9) for line in LINES})


def turned(share):
    return np.cumsum(SPEED * (1 + share * np.sin(2 * pi * 0.1 * AT))) / RATE


def disturbance(angle, amplitude=0.5):
    phases = np.random.default_rng(4).uniform(0, 2 * pi, len(ORDERS))
    return sum(amplitude * np.cos(order * angle + phase) for order, phase in zip(ORDERS, phases, strict=True))


def recording(torque, angle, profile="steady"):
    channels = {"torque_V": Channel(values=torque, quantity="torque", unit="V")}
    source = Recording(sample_rate=RATE, channels=channels, run=Run(speed=SPEED, profile=profile))
    truth = Channel(values=angle, quantity="motor_angle", unit="rad", truth=True)
    return Encoder(counts_per_rev=16384).apply(source.with_channel("true_motor_angle_rad", truth)).without_truth()


def rms(values):
    return float(np.sqrt(np.mean(values**2)))


@pytest.mark.parametrize("stage", [OrderBandstop(lines=LINES), WeightedLines(lines=LINES)])
def test_lines_under_two_per_cent_wander_fall_by_45_db(stage):
    # issue: 45 dB; the load's own noise is left out here, so that what is left is of the lines alone
    angle = turned(0.02)
    lines = disturbance(angle)
    left = stage.apply(recording(2.0 + lines, angle)).torque() - 2.0
    assert 20 * np.log10(rms(left) / rms(lines)) < -45


@pytest.mark.parametrize("stage", [OrderBandstop(lines=LINES), WeightedLines(lines=LINES)])
def test_noise_elsewhere_is_left_to_a_tenth(stage):
    angle = turned(0.02)
    noise = 0.1 * np.random.default_rng(5).normal(size=AT.size)
    wrong = stage.apply(recording(2.0 + noise + disturbance(angle), angle)).torque() - 2.0 - noise
    # the Hann bands take sqrt(22 lines x 1.5 x 2 / 6 s / 2500 Hz) = 0.07 of the noise; a block of 20 s takes less
    assert rms(wrong) < 0.1 * rms(noise)


@pytest.mark.parametrize("amplitude", [0.0, 0.5])
def test_a_chain_that_removes_no_line_names_the_tested_orders(amplitude):
    angle = turned(0.0)
    load = 0.3 * np.random.default_rng(7).normal(size=AT.size)
    before = recording(2.0 + load + disturbance(angle, amplitude), angle)
    lines = tuple(line for line in LINES if line.family in ("cogging", "six_pulse"))
    chain = Chain(name="order_lines", stages=(WeightedLines(lines=lines),))
    effect = chain_effect(before, chain.apply(before), ratio=5, lines=lines)
    expected = f"no line was removed; of {len({line.motor_order for line in lines})} tested orders none has more than 4"
    assert no_line_text(chain, effect).startswith(expected) == (amplitude == 0)
    assert no_line_text(replace(chain, stages=()), effect) == ""


def test_weak_lines_stay_and_no_load_is_taken_for_them():
    angle = turned(0.002)
    load = 1.0 + np.cumsum(np.random.default_rng(6).normal(size=AT.size)) * 0.002  # red: most where the low lines stand
    source = recording(load, angle)
    plain, weighed = (
        OrderBandstop(lines=LINES).apply(source).torque(),
        WeightedLines(lines=LINES).apply(source).torque(),
    )
    assert rms(weighed - load) < 0.5 * rms(plain - load)


def test_a_ramp_is_followed():
    speed = SPEED * np.minimum(0.1 + AT / AT[-1], 1.0)
    angle = np.cumsum(speed) / RATE
    lines = disturbance(angle)
    for stage in (OrderBandstop(lines=LINES), WeightedLines(lines=LINES)):
        left = stage.apply(recording(1.0 + lines, angle, profile="ramp")).torque() - 1.0
        assert 20 * np.log10(rms(left) / rms(lines)) < -35


def test_hop_sums_and_lines_are_what_their_names_say():
    angle = turned(0.02)[:5000]
    hops = hops_of(angle, ratio=5.0)
    orders = np.array([0.2, 7.0, 84.0])
    values = np.random.default_rng(8).normal(size=angle.size)
    sums = hop_sums(values, hops, orders).sum(axis=2)
    expected = np.array(
        [[(values - values.mean()) @ wave(order * angle) for order in orders] for wave in (np.cos, np.sin)]
    )
    # the compiled cosine is true to 1e-12
    assert sums == pytest.approx(expected, abs=1e-11 * np.abs(values).sum())
    amplitudes = np.ones((2, 3, hops.edges.size))
    lines = sum(np.cos(order * angle) + np.sin(order * angle) for order in orders)
    assert values - without_lines(values, hops, orders, amplitudes) == pytest.approx(lines, abs=1e-11)


def test_amplitudes_in_blocks_are_fitted_jointly():
    angle = turned(0.02)
    hops = hops_of(angle, ratio=5.0)
    orders = resolved_orders(ORDERS, hops.fastest)
    blocks = blocks_of(hops, length=20_000)
    fitted = block_amplitudes(3.0 + disturbance(angle), hops, orders, blocks)
    assert fitted.shape == (2, len(ORDERS), len(blocks.spans))
    # the speed within an eighth of a turn changes by 0.05 %: the sums of the normal equations are true to about 1e-3
    assert np.hypot(*fitted) == pytest.approx(0.5, abs=2e-3)


def test_lines_near_half_the_rate_are_left_alone():
    angle = turned(0.0)
    hops = hops_of(angle, ratio=5.0)
    assert resolved_orders([1.0, 130.0, 140.0], hops.fastest) == pytest.approx([1.0, 130.0])


def test_what_cannot_be_is_refused():
    with pytest.raises(InputError, match="remove nothing"):
        OrderBandstop(lines=LINES, half_width=0.0)
    with pytest.raises(InputError, match="write for example 30 s"):
        WeightedLines(lines=LINES, block=0.0)
    for stage in (OrderBandstop(lines=LINES), WeightedLines(lines=LINES)):
        with pytest.raises(RecordingError, match="does not turn"):
            stage.apply(recording(np.ones(1000), np.zeros(1000)))
