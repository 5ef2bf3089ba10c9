"""Tone, drift, clip, rounding, dropout, cross-talk, characteristic and hysteresis against their closed forms."""

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.recording import Channel, Recording
from torquerig.sensor_stages.characteristic import Characteristic
from torquerig.sensor_stages.clip import Clip
from torquerig.sensor_stages.crosstalk import Crosstalk
from torquerig.sensor_stages.drift import Drift
from torquerig.sensor_stages.dropout import Dropout
from torquerig.sensor_stages.hysteresis import Hysteresis
from torquerig.sensor_stages.rounding import Rounding
from torquerig.sensor_stages.tone import Tone, folded

RATE = 25_000.0


def recording(values, seed=7, sensitivity=1.0, **channels):
    torque = Channel(values=np.asarray(values, dtype=float), quantity="torque", unit="V", si_per_unit=1 / sensitivity)
    return Recording(sample_rate=RATE, channels={"torque_V": torque, **channels}, origin={"seed": seed})


def turning(speed, samples):
    """The true angle of a motor at ``speed`` rad/s."""
    values = speed * np.arange(samples) / RATE
    return {"true_motor_angle_rad": Channel(values=values, quantity="motor_angle", unit="rad", truth=True)}


def volts(result):
    return result.channels["torque_V"].values


def amplitudes(values):
    """Zero-to-peak amplitudes at the bins of a record that holds whole periods."""
    return 2 * np.abs(np.fft.rfft(values)) / values.size


def test_a_tone_stands_at_its_frequency_and_harmonics_with_its_amplitudes():
    found = amplitudes(volts(Tone(frequency=50.0, amplitudes=(0.3, 0.0, 0.1)).apply(recording(np.zeros(25_000)))))
    assert found[[50, 100, 150]] == pytest.approx([0.3, 0.0, 0.1], abs=1e-9)
    found[[50, 150]] = 0.0
    assert found.max() < 1e-9


def test_a_tone_with_stated_phase_is_the_cosine_itself():
    source = recording(np.ones(1000))
    made = volts(Tone(frequency=50.0, amplitudes=(0.2,), phases=(0.5,)).apply(source))
    assert made == pytest.approx(1 + 0.2 * np.cos(2 * np.pi * 50 * source.time() + 0.5), abs=1e-12)


@pytest.mark.parametrize(("true", "seen"), [(20_000.0, 5000.0), (24_000.0, 1000.0), (25_280.0, 280.0), (50.0, 50.0)])
def test_what_lies_above_half_the_rate_is_folded_as_signatures_2_7_says(true, seen):
    """At 25 kHz: 20 kHz -> 5 kHz, 24 kHz -> 1 kHz, 25.28 kHz -> 280 Hz."""
    assert folded(true, RATE) == pytest.approx(seen, abs=1e-9)
    found = amplitudes(volts(Tone(frequency=true, amplitudes=(0.1,)).apply(recording(np.zeros(25_000)))))
    assert np.argmax(found) == seen
    assert found.max() == pytest.approx(0.1, rel=1e-6)


def test_two_sources_draw_their_own_phases():
    made = [
        volts(Tone(frequency=50.0, amplitudes=(1.0,), source=source).apply(recording(np.zeros(500), seed=seed)))
        for source, seed in (("a", 1), ("a", 1), ("b", 1), ("a", 2))
    ]
    assert np.array_equal(made[0], made[1])
    assert not np.allclose(made[0], made[2])
    assert not np.allclose(made[0], made[3])


def test_a_drift_reaches_63_percent_after_its_time_constant():
    made = volts(Drift(span=0.4, time_constant=0.5).apply(recording(np.zeros(50_000))))
    assert made[0] == 0.0
    assert made[12_500] == pytest.approx(0.4 * (1 - np.exp(-1)), rel=1e-12)
    assert made[-1] == pytest.approx(0.4 * (1 - np.exp(-4)), rel=1e-3)


def test_a_drift_without_a_time_constant_is_a_straight_line_to_the_end_of_the_recording():
    made = volts(Drift(span=-0.4).apply(recording(np.ones(1000))))
    assert made == pytest.approx(1 - 0.4 * np.arange(1000) / 1000, abs=1e-15)


def test_a_long_time_constant_begins_as_a_straight_line():
    slow = volts(Drift(span=0.4 * 1000 / 0.04, time_constant=1000.0).apply(recording(np.zeros(1000))))
    line = volts(Drift(span=0.4).apply(recording(np.zeros(1000))))
    assert slow == pytest.approx(line, abs=0.4 * 0.04 / 2000 * 1.01)  # the next term of the series: span t / (2 tau)


def test_clipping_keeps_what_lies_within_and_its_third_harmonic_is_the_fourier_one():
    """A sine cut at c = A/2: a1 = A/pi (2 g + sin 2g), g = asin(1/2); a3 by the same integral."""
    source = np.sin(2 * np.pi * 5 * np.arange(25_000) / RATE)
    made = volts(Clip(limit=0.5).apply(recording(source)))
    inside = np.abs(source) <= 0.5
    assert np.array_equal(made[inside], source[inside])
    assert set(np.abs(made[~inside])) == {0.5}
    g = np.arcsin(0.5)
    found = amplitudes(made)
    assert found[5] == pytest.approx((2 * g + np.sin(2 * g)) / np.pi, rel=1e-6)
    third = (4 / np.pi) * ((np.sin(2 * g) / 4 - np.sin(4 * g) / 8) + 0.5 * np.cos(3 * g) / 3)
    assert found[15] == pytest.approx(abs(third), rel=1e-5)


def test_rounding_errs_by_half_a_step_and_by_step_over_root_12_rms():
    source = np.linspace(-3.0, 3.0, 200_003)
    made = volts(Rounding(step=0.05).apply(recording(source)))
    assert np.abs(made / 0.05 - np.round(made / 0.05)).max() < 1e-9
    assert np.abs(made - source).max() <= 0.025 * (1 + 1e-12)
    assert (made - source).std() == pytest.approx(0.05 / np.sqrt(12), rel=1e-3)


@pytest.mark.long
def test_dropouts_are_as_long_and_as_frequent_as_stated():
    """Of a Poisson process: lost share 1 - exp(-rate duration); 400 s at 2 1/s know it to 3.5 % (one sigma)."""
    made = volts(Dropout(duration=0.01, rate=2.0, level=9.0).apply(recording(np.ones(10_000_000))))
    lost = made == 9.0
    assert np.all(made[~lost] == 1.0)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], lost.astype(int), [0]])))
    lengths = edges[1::2] - edges[::2]
    assert np.median(lengths) == 250
    assert lengths[1:-1].min() >= 250
    assert lost.mean() == pytest.approx(1 - np.exp(-0.02), rel=5 * 0.035)


def test_a_dropout_may_be_running_when_the_recording_starts():
    starts = [
        volts(Dropout(duration=0.02, rate=10.0).apply(recording(np.ones(10), seed=seed)))[0] for seed in range(300)
    ]
    # the first sample is lost with 1 - exp(-0.2) = 0.181; 300 draws know that to 0.022
    assert np.mean(np.array(starts) == 0.0) == pytest.approx(0.181, abs=0.09)


def test_crosstalk_stands_once_and_twice_a_turn_of_the_sensor_in_newton_metres():
    samples = 25_000
    source = recording(np.zeros(samples), sensitivity=2.0, **turning(2 * np.pi * 50, samples))
    found = amplitudes(volts(Crosstalk(once=0.03, twice=0.01, turns=0.2).apply(source)))
    assert found[[10, 20]] == pytest.approx([0.06, 0.02], rel=1e-6)  # 2 V per N m, 50/5 turns a second


@pytest.mark.parametrize("turns_per_second", [25, 100])
def test_crosstalk_of_an_unbalance_grows_with_the_square_of_speed(turns_per_second):
    speed = 2 * np.pi * turns_per_second
    source = recording(np.zeros(25_000), **turning(speed, 25_000))
    found = amplitudes(volts(Crosstalk(once=0.0, once_by_speed_squared=1e-7).apply(source)))
    assert found[turns_per_second] == pytest.approx(1e-7 * speed**2, rel=1e-6)


def test_a_bent_characteristic_makes_the_harmonics_of_signatures_6_5():
    """A cos: 2f n A^2/(2 FS), 3f m A^3/(4 FS^2), mean n A^2/(2 FS); 2f ~ A^2."""
    source = 3 * np.cos(2 * np.pi * 100 * np.arange(25_000) / RATE)
    bent = Characteristic(full_scale=10.0, quadratic=0.005, cubic=0.003)
    made = volts(bent.apply(recording(2 * source, sensitivity=2.0))) / 2
    found = amplitudes(made)
    assert found[200] == pytest.approx(0.005 * 9 / 20, rel=1e-9)
    assert found[300] == pytest.approx(0.003 * 27 / 400, rel=1e-9)
    assert made.mean() == pytest.approx(0.005 * 9 / 20, rel=1e-9)


def test_a_gain_error_scales_and_nothing_else():
    source = np.random.default_rng(1).normal(size=1000)
    made = volts(Characteristic(full_scale=10.0, gain_error=0.02).apply(recording(source)))
    assert made == pytest.approx(1.02 * source, rel=1e-14)


def test_a_hysteresis_loop_has_its_width_and_area():
    """Play: area of a loop from -A to A is 4 r (A - r) w = 2 width (A - r)."""
    turn = 2 * np.pi * 10 * np.arange(7500) / RATE
    source = 5 * np.sin(turn)
    made = volts(Hysteresis(width=0.02, reach=0.5).apply(recording(source)))
    rising, falling = (5000, 5000 + 1250)  # both cross zero, after two whole loops
    assert source[rising] == pytest.approx(source[falling], abs=1e-9)
    assert made[falling] - made[rising] == pytest.approx(0.02, rel=1e-9)
    loop = slice(2500, 5001)
    middle = 0.5 * (made[loop][1:] + made[loop][:-1])
    assert abs(np.sum(middle * np.diff(source[loop]))) == pytest.approx(2 * 0.02 * (5 - 0.5), rel=1e-4)


def test_hysteresis_does_not_depend_on_how_fast_the_torque_swings():
    swing = np.concatenate([np.linspace(0, 3, 50), np.linspace(3, -1, 90), np.linspace(-1, 2, 70)])
    slow = np.repeat(swing, 4)
    stage = Hysteresis(width=0.1, reach=0.4)
    assert np.array_equal(volts(stage.apply(recording(slow)))[::4], volts(stage.apply(recording(swing))))


def test_a_small_swing_within_the_play_makes_no_loop():
    source = 0.3 * np.sin(np.linspace(0, 20, 500))
    made = volts(Hysteresis(width=0.1, reach=0.4).apply(recording(source)))
    assert made == pytest.approx(source * (1 - 0.1 / 0.8), rel=1e-12)


@pytest.mark.parametrize(
    "stage",
    [
        Tone(frequency=50.0, amplitudes=(0.0,)),
        Tone(frequency=50.0, amplitudes=()),
        Drift(span=0.0, time_constant=1.0),
        Clip(limit=5.0),
        Rounding(step=0.0),
        Dropout(duration=0.0, rate=100.0),
        Dropout(duration=1.0, rate=0.0),
        Crosstalk(once=0.0),
        Characteristic(full_scale=10.0),
        Hysteresis(width=0.0, reach=1.0),
    ],
    ids=lambda stage: type(stage).__name__,
)
def test_stages_of_zero_size_change_nothing(stage):
    source = np.random.default_rng(3).normal(size=500)
    assert volts(stage.apply(recording(source))).tobytes() == source.tobytes()


def test_a_stage_that_needs_the_angle_says_so():
    with pytest.raises(RecordingError, match="true_motor_angle_rad"):
        Crosstalk(once=0.1).apply(recording(np.zeros(5)))


@pytest.mark.parametrize(
    "make",
    [
        lambda: Tone(frequency=0.0, amplitudes=(1.0,)),
        lambda: Tone(frequency=50.0, amplitudes=(-1.0,)),
        lambda: Drift(span=1.0, time_constant=0.0),
        lambda: Clip(limit=0.0),
        lambda: Rounding(step=-0.1),
        lambda: Dropout(duration=-1.0, rate=1.0),
        lambda: Crosstalk(once=-0.1),
        lambda: Characteristic(full_scale=0.0),
        lambda: Hysteresis(width=1.0, reach=0.4),
    ],
)
def test_disturbances_that_cannot_be_are_refused(make):
    with pytest.raises(InputError, match="cannot be"):
        make()
