"""Error to the true load by band, in energy, in hits and in time; and the judgement that gathers it."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.filters.chains.filter_chain import Chain, report_filter_code_chain
from torquerig.metrics.filter_evaluation import evaluate_filter
from torquerig.metrics.load_error import TRUE_SPEED, load_error
from torquerig.metrics.truth_error import TRUE_LOAD, truth_error
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE = 5000.0
SPEED = 1000 * pi / 30
DRIVE = Kinematics(pole_pairs=7, slots=12, ratio=5.0)
TIME = np.arange(9 * int(RATE)) / RATE  # every line on a bin
LOAD = 1.0 + 0.2 * np.sin(2 * pi * 0.7 * TIME) + 0.05 * np.random.default_rng(1).normal(size=TIME.size)


def recording(torque, *, truth=True):
    channels = {
        "torque_V": Channel(values=torque, quantity="torque", unit="V"),
        "motor_speed": Channel(values=np.full(TIME.size, SPEED), quantity="motor_speed", unit="rad/s"),
    }
    if truth:
        channels[TRUE_LOAD] = Channel(values=LOAD, quantity="torque", unit="N*m", truth=True)
        speed = np.full(TIME.size, SPEED / 5)
        channels[TRUE_SPEED] = Channel(values=speed, quantity="speed", unit="rad/s", truth=True)
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=SPEED, gear_ratio=5.0), name="by hand")


def test_a_perfect_reading_has_no_error():
    error = load_error(recording(LOAD), recording(LOAD))
    assert error.rms == 0
    assert error.energy_percent == pytest.approx(0.0, abs=1e-12)
    assert error.delay.seconds == pytest.approx(0.0, abs=1e-9)


def test_the_bands_hold_the_whole_error_and_a_line_its_own():
    line = 0.3 * np.sin(2 * pi * 70 * TIME)
    given = recording(LOAD + line + 0.1)
    error = load_error(given, given)
    assert np.sqrt(np.sum(np.square(error.in_band))) == pytest.approx(error.rms, rel=1e-9)
    assert error.rms == pytest.approx(truth_error(given, given), rel=1e-12)
    assert dict(zip(error.bands, error.in_band, strict=True))[50, 100] == pytest.approx(0.3 / np.sqrt(2), rel=1e-9)
    assert error.mean == pytest.approx(0.1, rel=1e-9)


def test_the_energy_error_is_that_of_the_mean_at_constant_speed():
    error = load_error(recording(1.02 * LOAD), recording(LOAD))
    assert error.energy_percent == pytest.approx(2.0, rel=1e-9)


def test_a_late_reading_is_found_late():
    late = np.concatenate([np.full(40, LOAD[0]), LOAD])[: LOAD.size]
    assert load_error(recording(late), recording(LOAD)).delay.seconds == pytest.approx(40 / RATE, abs=1e-3)


def test_a_measured_recording_has_no_error_and_still_a_judgement():
    given = recording(LOAD + np.sin(7 * SPEED * TIME), truth=False)
    with pytest.raises(RecordingError, match="true load is not known"):
        load_error(given, given)
    made = evaluate_filter(report_filter_code_chain(DRIVE), given, ratio=5.0, known=DRIVE.lines(20))
    assert made.error_after is None
    assert made.placebo.beyond > 0.9
    assert made.delay.seconds == pytest.approx(0.0, abs=1e-4)
    assert made.effect.std_reduction_percent > 50


def test_a_chain_that_takes_the_line_brings_the_reading_to_the_load():
    given = recording(LOAD + np.sin(7 * SPEED * TIME))
    made = evaluate_filter(report_filter_code_chain(DRIVE), given, ratio=5.0, known=DRIVE.lines(20))
    assert made.error_before.rms == pytest.approx(1 / np.sqrt(2), rel=1e-3)
    assert made.error_after.rms < 0.02
    assert made.after.torque().mean() == pytest.approx(given.torque().mean(), rel=1e-9)


def test_the_empty_chain_changes_nothing_and_has_no_placebo():
    made = evaluate_filter(Chain(name="none", stages=()), recording(LOAD), ratio=5.0, known=DRIVE.lines(20))
    assert made.placebo is None
    assert made.error_after == made.error_before
    assert made.step.hit_peak == pytest.approx(1.0)
