"""What sensor, cable and converter add, seen through whole simulated runs at two speeds."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.mechanisms import (
    BearingDefect,
    BendingCrosstalk,
    Clipping,
    MainsInterference,
    PwmAliasing,
    Quantization,
    SensorBandwidth,
    SensorDrift,
    SensorHysteresis,
    SensorNonlinearity,
    SignalDropout,
    TorqueRipple,
)
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import AmplifierCutoff
from torquerig.rig.parts import Body, Gear, Motor, SpeedController, TorqueSensor
from torquerig.sensor_stages.amplifier import AmplifierLowPass
from torquerig.sensor_stages.clip import Clip
from torquerig.sensor_stages.converter import Converter
from torquerig.sensor_stages.dropout import Dropout
from torquerig.sensor_stages.noise import WhiteNoise
from torquerig.sensor_stages.ringing import Ringing
from torquerig.sensor_stages.rounding import Rounding
from torquerig.sensor_stages.tone import Tone
from torquerig.simulation.simulator import simulate

SPEEDS = pytest.mark.parametrize("speed_rpm", [600.0, 930.0])
LSB = 20 / 2**32  # of the fine converter that these rigs have


def sensed(*effects: Part, speed_rpm: float = 600.0, noise: float = 0.0, profile: str = "steady") -> Rig:
    """A driven 5:1 rig whose sensor is as good as can be: what is read beside the truth is the effect."""
    sensor = TorqueSensor(
        name="torque_sensor", after="gearbox", stiffness=1100, damping=0.12, inertia=4e-5, bandwidth=3000,
        noise_rms=noise, converter_bits=32, sensitivity=2.0,
    )  # fmt: skip
    return Rig(
        (
            Motor(name="motor", inertia=1.5e-4, torque_limit=10.0),
            Gear(name="gearbox", after="motor", ratio=5.0, stiffness=11300, damping=2.0, output_inertia=7e-4),
            sensor,
            Body(name="wear_part", after="torque_sensor", inertia=2e-3, viscous=0.04),
            SpeedController(name="controller", kp=0.05, ki=0.5),
            *effects,
        ),
        Run(speed=speed_rpm * pi / 30, profile=profile),  # type: ignore[arg-type]
    )


def volts(made: Recording) -> NDArray[np.float64]:
    return made.channels["torque_V"].values


def added(*effects: Part, duration: float = 1.0, speed_rpm: float = 600.0) -> NDArray[np.float64]:
    """What the effects change in the reading [V]."""
    with_them, without = (
        simulate(sensed(*some, speed_rpm=speed_rpm), duration=duration, seed=3) for some in (effects, ())
    )
    return volts(with_them) - volts(without)


def spectrum(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Zero-to-peak amplitudes at whole Hz of a second."""
    return 2 * np.abs(np.fft.rfft(values)) / values.size


def test_the_chain_runs_from_the_shaft_to_the_file_whatever_the_order_of_the_parts() -> None:
    """Clipping and dropouts after the noise and before the converter, even if a scenario names them first."""
    effects = (
        Quantization(name="codes", step=0.01),
        SignalDropout(name="lost", duration=0.01, rate=1.0),
        Clipping(name="rail", limit=5.0),
        MainsInterference(name="hum", amplitudes=(0.1,)),
        BearingDefect(name="ball", order_output=3.5, ring_frequency=2000.0, amplitude=0.1),
    )
    rig = sensed()
    rig = Rig((*rig.parts[:1], *effects, *rig.parts[1:]), rig.run)
    expected = [Ringing, AmplifierLowPass, Tone, WhiteNoise, Dropout, Clip, Converter, Rounding]
    assert [type(stage) for stage in rig.stages()] == expected


@SPEEDS
def test_mains_stand_at_50_hz_and_multiples_at_any_speed(speed_rpm: float) -> None:
    found = spectrum(added(MainsInterference(name="hum", amplitudes=(0.05, 0.02)), speed_rpm=speed_rpm))
    assert found[[50, 100]] == pytest.approx([0.05, 0.02], abs=1e-8)
    found[[50, 100]] = 0.0
    assert found.max() < 2 * LSB


@SPEEDS
def test_switching_at_24_khz_appears_at_1_khz_at_any_speed(speed_rpm: float) -> None:
    pwm = PwmAliasing(name="pwm", switching_frequency=24_000.0, amplitude=0.03)
    found = spectrum(added(pwm, speed_rpm=speed_rpm))
    assert np.argmax(found) == 1000 == pwm.apparent_frequency(25_000.0)
    assert found[1000] == pytest.approx(0.03, abs=1e-8)


def test_another_sample_rate_moves_an_alias_and_not_a_line() -> None:
    """The test for aliasing of the handbook (T12): at 20 kHz the 24 kHz appear at 4 kHz, and 1 kHz stays."""
    for effect, seen in (
        (PwmAliasing(name="pwm", switching_frequency=24_000.0, amplitude=0.3), 4000),
        (PwmAliasing(name="pwm", frequency=1000.0, amplitude=0.3), 1000),
    ):
        made = simulate(sensed(effect), duration=1.0, seed=3, sample_rate=20_000.0)
        assert np.argmax(spectrum(volts(made) - volts(made).mean())) == seen
        assert effect.apparent_frequency(20_000.0) == seen


@pytest.mark.parametrize(("cutoff", "gain"), [(200.0, 0.02), (1000.0, 0.45)])
def test_a_lower_cutoff_passes_of_1400_hz_what_signatures_6_1_says(cutoff: float, gain: float) -> None:
    """0.02 at 200 Hz and 0.45 at 1 kHz, as one low-pass and not behind the sensor's own."""
    ripple = TorqueRipple(name="ripple", at="wear_part", group="mechanical", amplitudes={210.0: 0.5})
    made = simulate(sensed(ripple, SensorBandwidth(name="slow", cutoff=cutoff), speed_rpm=2000.0), duration=1.0, seed=3)
    angle = 42 * made.channels["true_motor_angle_rad"].values
    columns = np.column_stack([np.ones(angle.size), np.cos(angle), np.sin(angle)])
    true, read = (
        np.hypot(*np.linalg.lstsq(columns, values, rcond=None)[0][1:])
        for values in (made.channels["true_sensor_torque_Nm"].values, made.torque())
    )
    assert read / true == pytest.approx(gain, abs=0.006)
    # straight lines between samples lose sinc^2(1400/25000) = 1 %
    assert read / true == pytest.approx(np.sinc(1400 / 25_000) ** 2 / sqrt(1 + (1400 / cutoff) ** 4), rel=3e-3)


def test_there_is_one_low_pass_at_the_lowest_cutoff() -> None:
    for cutoffs, expected in (((), 3000.0), ((400.0,), 400.0), ((900.0, 400.0), 400.0), ((5000.0,), 3000.0)):
        effects = [SensorBandwidth(name=f"slow{row}", cutoff=cutoff) for row, cutoff in enumerate(cutoffs)]
        found = [stage.cutoff for stage in sensed(*effects).stages() if isinstance(stage, AmplifierLowPass)]
        assert found == [expected]


def test_the_cutoff_of_one_sensor_leaves_another_alone() -> None:
    slow = SensorBandwidth(name="slow", sensor="other", cutoff=400.0)
    assert sensed(slow).changes_in("torque_sensor") == ()
    assert sensed(slow).changes_in("other") == (AmplifierCutoff(400.0),)


@pytest.mark.long
@SPEEDS
def test_a_drift_is_the_same_at_any_speed(speed_rpm: float) -> None:
    time = np.arange(25_000) / 25_000
    warming = added(SensorDrift(name="warm", span=0.3, time_constant=0.4), speed_rpm=speed_rpm)
    assert warming == pytest.approx(0.3 * (1 - np.exp(-time / 0.4)), abs=LSB)
    straight = added(SensorDrift(name="warm", span=-0.3), speed_rpm=speed_rpm)
    assert straight == pytest.approx(-0.3 * time, abs=LSB)


def test_clipping_cuts_the_noise_too() -> None:
    free, cut = (
        volts(simulate(sensed(*effects, noise=0.05), duration=0.5, seed=3))
        for effects in ((), (Clipping(name="rail", limit=1.0),))
    )
    assert free.max() > 1.05
    assert cut.max() == pytest.approx(1.0, abs=LSB)
    assert np.array_equal(cut[free < 1.0 - LSB], free[free < 1.0 - LSB])


def test_a_hum_rides_on_what_the_amplifier_cut() -> None:
    """The rails of an amplifier come before its cable, the range of a converter behind it."""
    hum = MainsInterference(name="hum", frequency=50.0, amplitudes=(0.2,), phases=(0.0,))
    at_amplifier, at_input = (
        volts(simulate(sensed(hum, Clipping(name="rail", limit=0.5, where=where)), duration=0.5, seed=3))
        for where in ("amplifier", "input")
    )
    assert at_amplifier.max() == pytest.approx(0.7, abs=0.01)
    assert at_input.max() == pytest.approx(0.5, abs=LSB)


def test_coarse_codes_are_the_whole_reading_and_their_error_is_uniform() -> None:
    free, coarse = (
        volts(simulate(sensed(*effects, noise=0.05), duration=1.0, seed=3))
        for effects in ((), (Quantization(name="codes", step=0.02),))
    )
    assert np.array_equal(coarse, 0.02 * np.round(coarse / 0.02))
    # 25 000 independent errors know their rms to 0.3 % (a uniform distribution's, one sigma)
    assert (coarse - free).std() == pytest.approx(0.02 / sqrt(12), rel=0.015)


def test_dropouts_read_their_level_exactly_and_nothing_else_changes() -> None:
    lost = SignalDropout(name="lost", duration=0.004, rate=20.0, level=-5.0)
    free, gaps = (volts(simulate(sensed(*effects, noise=0.05), duration=2.0, seed=3)) for effects in ((), (lost,)))
    out = np.abs(gaps + 5.0) <= LSB
    assert np.array_equal(gaps[~out], free[~out])
    starts = np.count_nonzero(np.diff(out.astype(int)) == 1)
    assert starts == pytest.approx(40, abs=5 * sqrt(40))
    assert out.mean() == pytest.approx(1 - np.exp(-0.08), rel=0.8)


@SPEEDS
def test_bearing_impacts_repeat_at_their_output_order_and_ring_at_a_fixed_frequency(speed_rpm: float) -> None:
    from scipy.signal import hilbert

    ball = BearingDefect(name="ball", order_output=7.43, ring_frequency=1800.0, amplitude=0.2)
    values = added(ball, duration=8.0, speed_rpm=speed_rpm)
    power = np.abs(hilbert(values)) ** 2
    turns = speed_rpm / 60 / 5
    levels = np.abs(np.fft.rfft((power - power.mean()) * np.hanning(power.size)))
    assert np.argmax(levels) / 8.0 / turns == pytest.approx(7.43, abs=0.1)  # 0.125 Hz at 2 turns a second is 0.06
    ring = np.convolve(np.abs(np.fft.rfft(values)) ** 2, np.ones(401) / 401, mode="same")
    assert np.argmax(ring) / 8.0 == pytest.approx(1800.0, abs=50.0)  # the mode is 180 Hz wide


def test_bearing_impacts_come_through_the_amplifier() -> None:
    """Of a ringing far above the cutoff a Butterworth low-pass leaves its area A/(2 pi f), a pulse 0.456 w_c high."""
    ball = BearingDefect(name="ball", order_output=20.0, ring_frequency=1000.0, amplitude=0.2, damping=0.02)
    assert np.abs(added(ball)).max() == pytest.approx(0.4, rel=0.1)  # 2 V per N m
    slow = SensorBandwidth(name="slow", cutoff=50.0)
    with_it, without = (simulate(sensed(*some), duration=1.0, seed=3) for some in ((ball, slow), (slow,)))
    pulse = np.sqrt(2) * np.exp(-np.pi / 4) * np.sin(np.pi / 4)  # peak of its impulse response in units of w_c
    left = np.abs(volts(with_it) - volts(without)).max()
    assert left == pytest.approx(0.4 * 50 / 1000 * pulse, rel=0.1)  # and (50/1000)^2 of the ringing itself


@SPEEDS
def test_bending_stands_once_a_turn_of_the_sensors_shaft_at_any_speed(speed_rpm: float) -> None:
    bend = BendingCrosstalk(name="bend", once=0.03, twice=0.01, once_by_speed_squared=1e-6)
    plain = simulate(sensed(speed_rpm=speed_rpm), duration=2.0, seed=3)
    angle = plain.channels["true_motor_angle_rad"].values / 5
    speed = plain.channels["true_output_speed_rad_s"].values.mean()

    def orders(effect: Part) -> NDArray[np.float64]:
        columns = np.column_stack([f(k * angle) for k in (1, 2, 3) for f in (np.cos, np.sin)])
        found = np.linalg.lstsq(columns, added(effect, duration=2.0, speed_rpm=speed_rpm), rcond=None)[0]
        return np.asarray(np.hypot(found[::2], found[1::2])) / 2.0  # 2 V per N m

    assert orders(BendingCrosstalk(name="bend", once=0.03, twice=0.01)) == pytest.approx([0.03, 0.01, 0.0], abs=1e-5)
    growing = BendingCrosstalk(name="bend", once=0.0, once_by_speed_squared=bend.once_by_speed_squared)
    assert orders(growing)[0] == pytest.approx(1e-6 * speed**2, rel=2e-3)


@SPEEDS
def test_a_gain_error_scales_the_reading(speed_rpm: float) -> None:
    bent = SensorNonlinearity(name="bent", full_scale=10.0, gain_error=0.03)
    plain = volts(simulate(sensed(speed_rpm=speed_rpm), duration=1.0, seed=3))
    assert added(bent, speed_rpm=speed_rpm) == pytest.approx(0.03 * plain, abs=2 * LSB)


@pytest.mark.parametrize("amplitude", [0.2, 0.4])
def test_a_bent_characteristic_doubles_a_line_with_the_square_of_its_amplitude(amplitude: float) -> None:
    """Handbook 6.5: 2f ~ A^2, here n A^2 / (2 full scale) of the line A that the sensor truly carries."""
    ripple = TorqueRipple(name="ripple", at="wear_part", group="mechanical", amplitudes={5.0: amplitude})
    bent = SensorNonlinearity(name="bent", full_scale=5.0, quadratic=0.02)
    idle = Body(name="wear_part", after="torque_sensor", inertia=2e-3)  # no mean torque: 2f comes from 1f alone
    made = [simulate(sensed(ripple, *some).changed(idle), duration=1.0, seed=3) for some in ((bent,), ())]
    turn = made[0].channels["true_motor_speed_rad_s"].values.mean() * made[0].time()

    def line(values: NDArray[np.float64], order: int) -> float:
        columns = np.column_stack([f(k * turn) for k in range(4) for f in (np.cos, np.sin)])
        return float(np.hypot(*np.linalg.lstsq(columns, values, rcond=None)[0][2 * order : 2 * order + 2]))

    true = line(made[0].channels["true_sensor_torque_Nm"].values, 1)
    doubled = line(made[0].torque() - made[1].torque(), 2)
    assert doubled == pytest.approx(0.02 * true**2 / 10, rel=0.02)


def test_hysteresis_reads_high_when_torque_falls_and_low_when_it_rises() -> None:
    """Over a reversal the reading lags by half the width either way; the amplifier overshoots by 4 %."""
    lag = SensorHysteresis(name="lag", width=0.05, reach=0.05)
    with_it, without = (simulate(sensed(*some, profile="reversal"), duration=1.0, seed=3) for some in ((lag,), ()))
    behind = with_it.torque() - without.torque()
    torque = without.channels["true_sensor_torque_Nm"].values
    assert np.ptp(torque) > 10 * lag.reach
    assert behind.max() == pytest.approx(0.025, rel=0.05)
    assert behind.min() == pytest.approx(-0.025, rel=0.05)
    # 100 samples: what the torque did over the last 4 ms
    trend = np.convolve(np.gradient(torque), np.ones(2000), mode="same")
    assert np.corrcoef(np.sign(trend), behind)[0, 1] < -0.7
