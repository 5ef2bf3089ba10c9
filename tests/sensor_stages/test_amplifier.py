"""The amplifier against the analytic Butterworth magnitude and the closed form of its first-order hold."""

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.recording import Channel, Recording
from torquerig.sensor_stages.amplifier import AmplifierLowPass

RATE = 25000.0
CUTOFF = 3000.0


def seen(values, stage):
    torque = Channel(values=np.asarray(values, dtype=float), quantity="torque", unit="V")
    return stage.apply(Recording(sample_rate=RATE, channels={"torque_V": torque})).channels["torque_V"].values


def measured_gain(frequency, stage):
    """Complex gain of the settled second half, over a whole number of periods."""
    at = np.arange(50000) / RATE
    answer = seen(np.sin(2 * np.pi * frequency * at), stage)[25000:]
    return 2 * np.mean(answer * np.exp(-2j * np.pi * frequency * at[25000:])) * 1j


def analytic(frequency, order=2):
    return 1 / np.sqrt(1 + (frequency / CUTOFF) ** (2 * order))


@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("frequency", [50.0, 280.0, 1400.0, 3000.0, 5000.0, 7500.0])
def test_magnitude_is_the_analog_one_less_what_straight_lines_lose(frequency, order):
    gain = abs(measured_gain(frequency, AmplifierLowPass(cutoff=CUTOFF, order=order)))
    # the hold keeps sinc^2(x) >= 1 - (pi x)^2 / 3 of the sine; the rest goes to images at rate - f and above
    lost = (np.pi * frequency / RATE) ** 2 / 3
    worst = lost * (analytic(frequency, order) + analytic(RATE - frequency, order))
    assert abs(gain - analytic(frequency, order)) <= worst + 1e-9


@pytest.mark.parametrize("frequency", [280.0, 3000.0, 7500.0])
def test_first_order_hold_equals_its_closed_form(frequency):
    # the hold turns a sampled sine into images at f + k rate, each of height sinc^2; the analog filter sees them all
    images = frequency + RATE * np.arange(-400, 401)
    s = 2j * np.pi * images
    wc = 2 * np.pi * CUTOFF
    expected = np.sum(np.sinc(images / RATE) ** 2 * wc**2 / (s**2 + np.sqrt(2) * wc * s + wc**2))
    # the sum cut at 400 images lacks less than 400^-3
    assert measured_gain(frequency, AmplifierLowPass(cutoff=CUTOFF)) == pytest.approx(expected, abs=1e-7)


def test_a_constant_passes_unchanged_from_the_first_sample():
    assert np.array_equal(seen(np.full(1000, 1.2345), AmplifierLowPass(cutoff=10.0)), np.full(1000, 1.2345))


def test_a_ramp_comes_out_late_by_the_damping_term():
    # 1 / (s^2/wc^2 + sqrt2 s/wc + 1) answers a ramp by the ramp, sqrt2/wc later; exact under a first-order hold
    at = np.arange(25000) / RATE
    answer = seen(at, AmplifierLowPass(cutoff=CUTOFF))
    assert answer[-1] == pytest.approx(at[-1] - np.sqrt(2) / (2 * np.pi * CUTOFF), abs=1e-10)


@pytest.mark.parametrize("wrong", [{"cutoff": 0.0}, {"cutoff": -5.0}, {"cutoff": 100.0, "order": 9}])
def test_an_amplifier_that_cannot_be_is_refused(wrong):
    with pytest.raises(InputError, match="cutoff must be above 0"):
        AmplifierLowPass(**wrong)


def test_no_samples_are_refused():
    with pytest.raises(RecordingError, match="no samples"):
        seen([], AmplifierLowPass(cutoff=CUTOFF))
