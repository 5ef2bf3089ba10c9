"""A chain beside itself at empty orders: what stands at its lines, and what any so many notches would cut."""

from math import pi

import numpy as np
import pytest

from torquerig.filters.butterworth import ButterworthLowPass
from torquerig.filters.chains.filter_chain import Chain, report_filter_code_chain, report_filter_text_chain
from torquerig.filters.evaluation.known_angle import FOUND_ANGLE, with_known_angle
from torquerig.filters.evaluation.placebo import empty_shifts, placebo
from torquerig.filters.evaluation.shifted_chain import shiftable_lines, shifted_chain
from torquerig.filters.harmonic_regression import HarmonicRegression
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE = 5000.0
SPEED = 1000 * pi / 30
DRIVE = Kinematics(pole_pairs=7, slots=12, ratio=5.0)


def recording(torque, *, angle=True):
    channels = {"torque_V": Channel(values=torque, quantity="torque", unit="V")}
    if angle:
        turned = SPEED * np.arange(torque.size) / RATE
        channels["angle"] = Channel(values=turned, quantity="motor_angle", unit="rad")
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=SPEED, gear_ratio=5.0))


def noise(seconds=20, seed=1):
    return np.random.default_rng(seed).normal(size=int(seconds * RATE))


def test_in_white_noise_the_chain_cuts_what_its_placebo_cuts():
    chain = report_filter_code_chain(DRIVE)
    found = placebo(chain, recording(noise()), known=DRIVE.lines(20))
    # every band is 1 Hz wide; lines that coincide share theirs
    bands = sorted({round(line.frequency(SPEED), 6) for line in chain.lines})
    assert found.cut == pytest.approx(len(bands) / (RATE / 2), rel=0.3)
    assert found.median == pytest.approx(len(chain.lines) / (RATE / 2), rel=0.3)
    assert abs(found.beyond) < 0.003


def test_what_stands_at_the_lines_is_told_from_what_does_not():
    time = np.arange(20 * int(RATE)) / RATE
    line = np.sqrt(2) * np.sin(2 * pi * 7 * SPEED / (2 * pi) * time)
    found = placebo(report_filter_code_chain(DRIVE), recording(noise() + line), known=DRIVE.lines(20))
    assert found.beyond == pytest.approx(0.5, abs=0.01)
    assert found.p_value == pytest.approx(1 / (1 + len(found.shifts)))
    assert max(found.std_cuts) < 0.02


def test_the_moved_lines_keep_clear_of_every_known_one():
    chain = report_filter_code_chain(DRIVE)
    known = DRIVE.lines(20)
    shifts = empty_shifts(chain, known=known, speed=SPEED)
    assert len(shifts) >= 20
    places = np.array([line.output_order for line in known])
    half_width = 0.5 * 2 * pi * 5 / SPEED
    for by in shifts:
        moved = np.array([line.output_order for line in shiftable_lines(shifted_chain(chain, by))])
        assert np.abs(moved[:, None] - places).min() >= 1.2 * half_width - 1e-9
        assert moved.min() > half_width


def test_a_moved_chain_moves_lines_and_nothing_else():
    chain = report_filter_text_chain(DRIVE)
    moved = shifted_chain(chain, 0.5)
    assert [line.output_order for line in shiftable_lines(moved)] == pytest.approx(
        [line.output_order + 0.5 for line in shiftable_lines(chain)]
    )
    assert [line.motor_order for line in moved.lines] == pytest.approx([line.motor_order + 0.1 for line in chain.lines])
    assert moved.stages[0].samples == chain.stages[0].samples


def test_a_chain_without_lines_has_no_placebo():
    chain = Chain(name="low", stages=(ButterworthLowPass(cutoff=20.0),))
    assert placebo(chain, recording(noise(2)), known=DRIVE.lines(20)) is None


def test_a_constant_torque_has_no_placebo():
    assert placebo(report_filter_code_chain(DRIVE), recording(np.ones(20000)), known=DRIVE.lines(20)) is None


@pytest.mark.long
def test_without_an_encoder_chain_and_placebo_share_the_angle_that_the_true_lines_give():
    time = np.arange(20 * int(RATE)) / RATE
    lines = tuple(line for line in DRIVE.lines(4) if line.family in ("motor", "electrical"))
    torque = 0.3 * noise() + sum(np.sin(line.motor_order * 1.004 * SPEED * time) for line in lines)
    given = with_known_angle(recording(torque, angle=False), lines)
    turned = given.channels[FOUND_ANGLE].values
    assert (turned[-1] - turned[0]) / time[-1] == pytest.approx(1.004 * SPEED, rel=1e-4)
    chain = Chain(name="lines", stages=(HarmonicRegression(lines=lines),))
    found = placebo(chain, recording(torque, angle=False), known=DRIVE.lines(20))
    # the noise, 2 % of the power, stays
    assert found.cut > 0.97
    assert found.median < 0.02
