"""Moving mean, revolution mean and Butterworth low-pass against their closed forms."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.filters.butterworth import ButterworthLowPass
from torquerig.filters.moving_mean import MovingMeanKept, moving_mean
from torquerig.filters.revolution_mean import RevolutionMean
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run


def recording(values, rate=1000.0, **run):
    torque = Channel(values=np.asarray(values, dtype=float), quantity="torque", unit="V")
    return Recording(sample_rate=rate, channels={"torque_V": torque}, run=Run(**run))


@pytest.mark.parametrize("samples", [1, 2, 3, 6, 7, 40])
def test_moving_mean_is_the_mean_of_what_the_window_holds(samples):
    # MATLAB movmean: even windows hold samples / 2 values before and one fewer after; ends shrink
    values = np.random.default_rng(0).normal(3.0, 1.0, 40)
    back, ahead = samples // 2, (samples - 1) // 2
    expected = [values[max(i - back, 0) : i + ahead + 1].mean() for i in range(values.size)]
    assert moving_mean(values, samples) == pytest.approx(expected, abs=1e-14)


def test_a_mean_kept_around_nothing_changes_nothing():
    values = np.random.default_rng(1).normal(size=500)
    kept = MovingMeanKept(samples=100, around=()).apply(recording(values))
    assert kept.torque() == pytest.approx(values, abs=1e-14)


def test_a_mean_kept_around_a_stage_that_deletes_leaves_the_mean():
    class Delete:
        def apply(self, source):
            return source.with_values("torque_V", np.zeros(source.samples))

    values = np.random.default_rng(2).normal(size=500)
    kept = MovingMeanKept(samples=100, around=(Delete(),)).apply(recording(values))
    assert kept.torque() == pytest.approx(moving_mean(values, 100), abs=1e-14)


@pytest.mark.parametrize("frequency", [5.0, 20.0, 30.0, 60.0])
def test_low_pass_has_the_squared_butterworth_gain_and_no_delay(frequency):
    at = np.arange(20000) / 1000.0
    answer = ButterworthLowPass(cutoff=20.0, order=4).apply(recording(np.sin(2 * pi * frequency * at))).torque()
    middle = slice(8000, 12000)  # 400 ring times from the ends
    gain = 2 * np.mean(answer[middle] * np.exp(-2j * pi * frequency * at[middle])) * 1j
    # the bilinear transform bends f to rate / pi tan(pi f / rate)
    bent = np.tan(pi * frequency / 1000) / np.tan(pi * 20 / 1000)
    assert gain == pytest.approx(1 / (1 + bent**8), abs=1e-9)


def test_low_pass_keeps_a_constant():
    assert ButterworthLowPass(cutoff=20.0).apply(recording(np.full(2000, 1.5))).torque() == pytest.approx(
        1.5, abs=1e-12
    )


def test_revolution_mean_removes_every_whole_output_order():
    # 60 rpm at the motor, 2:1, 1000 Hz: the output turns once in 2000 samples
    at = np.arange(20000) / 1000.0
    lines = sum(np.sin(2 * pi * 0.5 * order * at + order) for order in (1, 2, 5, 84))
    answer = RevolutionMean(ratio=2.0).apply(recording(1.0 + lines, speed=2 * pi)).torque()
    assert answer[1000:-1000] == pytest.approx(1.0, abs=1e-12)


def test_revolution_mean_follows_the_encoder_rather_than_the_set_point():
    at = np.arange(20000) / 1000.0
    speed = Channel(values=np.full(20000, 2 * pi), quantity="motor_speed", unit="rad/s")
    source = recording(np.sin(2 * pi * 0.5 * at), speed=7.0).with_channel("speed", speed)
    assert RevolutionMean(ratio=2.0).apply(source).torque()[1000:-1000] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("stage", "source", "message"),
    [
        (MovingMeanKept(samples=1000, around=()), recording(np.zeros(999)), "too few for a moving mean of 1000"),
        (ButterworthLowPass(cutoff=20.0), recording(np.zeros(100)), "too few for a low-pass"),
        (ButterworthLowPass(cutoff=500.0), recording(np.zeros(5000)), "lower the cutoff"),
        (RevolutionMean(ratio=5.0), recording(np.zeros(1000), speed=2 * pi), "turns fewer than 1 times"),
        (RevolutionMean(ratio=5.0), recording(np.zeros(1000)), "states no motor speed"),
    ],
)
def test_recordings_that_cannot_serve_are_refused_in_one_sentence(stage, source, message):
    with pytest.raises(RecordingError, match=message) as refused:
        stage.apply(source)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "make",
    [
        lambda: MovingMeanKept(samples=0, around=()),
        lambda: ButterworthLowPass(cutoff=0.0),
        lambda: ButterworthLowPass(cutoff=10.0, order=0),
        lambda: RevolutionMean(ratio=5.0, turns=0.0),
    ],
)
def test_filters_that_cannot_be_are_refused(make):
    with pytest.raises(InputError, match="is not possible"):
        make()
