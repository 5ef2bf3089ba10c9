"""The fleet's equations against closed forms: steady motion, a forced two-mass train, slip, gap, belt, low-pass."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from proof.fleet.chain import converted, encoder_counts, low_passed
from proof.fleet.counting import levels, whittle
from proof.fleet.courses import Courses
from proof.fleet.effect import Motion
from proof.fleet.effects.backlash import Backlash
from proof.fleet.effects.bearing_defect import BearingDefect
from proof.fleet.kernel import POINTS, run_train
from proof.fleet.recording import move, train_with
from proof.fleet.response import sensed_per_error, sensed_per_torque
from proof.fleet.rig import draw_rig
from proof.fleet.settling import start_state, substeps_of
from proof.fleet.stages_stated import _free_strand
from proof.fleet.train import ANGLE

RATE = 10000.0


@pytest.fixture(scope="module")
def calm():
    """A direct servo drive without lines, friction of the motor and random load: the laws alone remain."""
    rig = draw_rig("calm", (2, 19), plans=("one_speed",), motors=("servo",), drives=("direct",), loads=("free",))
    nothing = np.zeros(POINTS)
    train = train_with(rig, ())._replace(
        motor_table=nothing, load_table=nothing, motor_coulomb=0.0, dry=np.zeros(2), control_frames=1, control_delay=0,
        torque_limit=1e9,
    )  # fmt: skip
    return rig, train


def courses(train, speed, *, frames, **pushes):
    nothing = np.zeros(frames)
    base = Courses(np.full(frames, speed * train.ratio), nothing, nothing, nothing, nothing, np.ones(frames))
    return base.with_pushes(pushes)


def moved(train, inputs):
    return run_train(train, start_state(train, inputs), inputs.arrays(), substeps_of(train, RATE), RATE)


def test_steady_speed_and_torque_follow_from_friction(calm):
    rig, train = calm
    speed = rig.design.scale.output_speed
    out = moved(train, courses(train, speed, frames=5000))
    assert out[-1000:, 3] == pytest.approx(speed, rel=1e-6)
    # the sensor carries the viscous friction of all masses behind it: the body alone
    assert out[-1000:, 0].mean() == pytest.approx(train.viscous[-1] * speed, rel=1e-6)


def test_drag_grows_with_the_square_of_the_speed(calm):
    rig, train = calm
    speed = rig.design.scale.output_speed
    train = train._replace(drag=0.3 * rig.design.scale.torque / speed**2)
    sensed = [moved(train, courses(train, share * speed, frames=5000))[-1000:, 0].mean() for share in (0.5, 1.0)]
    drag = [one - train.viscous[-1] * share * speed for one, share in zip(sensed, (0.5, 1.0), strict=True)]
    assert drag[1] / drag[0] == pytest.approx(4.0, rel=1e-5)
    assert drag[1] == pytest.approx(0.3 * rig.design.scale.torque, rel=1e-5)


@pytest.mark.parametrize("frequency", [7.0, 23.0, 90.0])
def test_a_forced_train_answers_as_its_linear_response(calm, frequency):
    rig, train = calm
    speed = rig.design.scale.output_speed
    frames = 30000
    t = np.arange(frames) / RATE
    push = 0.05 * rig.design.scale.torque * np.cos(2.0 * pi * frequency * t)
    out = moved(train, courses(train, speed, frames=frames, push_load=push))
    last = slice(-10000, None)  # 1 s, a whole number of periods
    line = 2.0 * np.mean(out[last, 0] * np.exp(-2j * pi * frequency * t[last]))
    wanted = 0.05 * rig.design.scale.torque * sensed_per_torque(train, frequency, -1, speed=0.0)
    # the controller samples at 10 kHz: half a period late, which the continuous response does not have
    assert abs(line) == pytest.approx(abs(wanted), rel=0.03)


def test_two_masses_on_a_spring_in_closed_form(calm):
    _, train = calm
    j1, j2, k = 2e-3, 5e-3, 400.0
    two = train._replace(
        inertia=np.array([j1, j2]), stiffness=np.array([k]), damping=np.zeros(1), viscous=np.zeros(2), kp=1e-12, ki=0.0,
        sensor_spring=0, ratio=1.0, drag=0.0,
    )  # fmt: skip
    for frequency in (5.0, 60.0, 200.0):
        w = 2.0 * pi * frequency
        wanted = -k * j1 / (k * (j1 + j2) - w * w * j1 * j2)  # torque on j2, both masses free
        assert sensed_per_torque(two, frequency, 1, speed=0.0).real == pytest.approx(wanted, rel=1e-5)
        error = k * (-w * w) * j1 * j2 / (k * (j1 + j2) - w * w * j1 * j2)
        assert sensed_per_error(two, frequency, 0, speed=0.0).real == pytest.approx(error, rel=1e-5)


def test_a_transmission_error_makes_its_line(calm):
    _, train = calm
    speed = 2.0 * pi * 4.0
    order, size = 9, 1e-4
    errors, slopes = train.errors.copy(), train.slopes.copy()
    errors[0] = size * np.cos(order * ANGLE)
    slopes[0] = -size * order * np.sin(order * ANGLE)
    train = train._replace(
        errors=errors, slopes=slopes, has_error=np.array([True] + [False] * (len(train.has_error) - 1))
    )
    out = moved(train, courses(train, speed, frames=30000))
    angle = out[-10000:, 2]
    line = 2.0 * np.mean((out[-10000:, 0] - out[-10000:, 0].mean()) * np.exp(-1j * order * angle))
    wanted = size * sensed_per_error(train, 36.0, 0, speed=0.0)
    assert abs(line) == pytest.approx(abs(wanted), rel=0.03)


def test_balls_strike_as_often_backward_as_forward():
    rate = 1000.0
    time = np.arange(0, 20, 1 / rate)
    angle = 2 * pi * 5 * np.where(time < 10, time, 20 - time)  # ten seconds forward, ten backward
    motion = Motion(time, np.zeros(time.size), angle, angle, np.gradient(angle, time), rate, 20.0)
    defect = BearingDefect("drum", order=3.6, ring=200.0, damping=0.03, torque=1.0, slip=0.005, loaded=0.0)
    rung = defect.on_torque(motion.torque, motion, np.random.default_rng(1))
    assert rung[time > 10].std() == pytest.approx(rung[time < 10].std(), rel=0.05)


def test_an_induction_motor_slips_by_its_load():
    rig = draw_rig("slip", (2, 30), plans=("one_speed",), motors=("induction",), drives=("direct",), loads=("brake",))
    motion = move(rig, replace(rig.runs[0], duration=4.0), 0, ())
    train = train_with(rig, ())
    steady = motion.time > 1.0
    field = rig.runs[0].speed
    torque = motion.torque[steady].mean() + train.motor_coulomb + train.viscous[0] * motion.output_speed[steady].mean()
    x = train.breakdown_torque / torque - np.sqrt((train.breakdown_torque / torque) ** 2 - 1.0)
    # Kloss on the stable branch; the load varies by some per cent and the slip with it
    assert field - motion.output_speed[steady].mean() == pytest.approx(train.breakdown_slip * x, rel=0.03)


def test_the_input_leads_by_half_the_gap_under_load():
    kinds = {"motors": ("servo",), "drives": ("one_stage",), "loads": ("free",)}
    rig = draw_rig("gap", (2, 40), plans=("one_speed",), **kinds)
    gap = 0.01
    rig = replace(rig, effects=(Backlash("gearbox", 0, gap, 1.0),), laws=replace(rig.laws, contact_exponent=1.0))
    with_gap, without = (move(rig, rig.runs[0], 0, effects) for effects in (rig.effects, ()))
    lead = [one.motor_angle / rig.design.ratio - one.output_angle for one in (with_gap, without)]
    # both carry the same steady torque; its ripple moves the twist by less than a hundredth of the gap
    assert np.mean(lead[0]) - np.mean(lead[1]) == pytest.approx(0.5 * gap, rel=0.02)


def test_the_free_strand_of_a_belt_with_equal_pulleys_is_half_of_what_they_leave():
    assert _free_strand(30, 30, 100) == pytest.approx((100 - 30) / 2.0, rel=1e-9)
    # unequal pulleys: length of an open belt on two circles, centre distance 40 pitches
    small, large, middle = 20 / (2 * pi), 40 / (2 * pi), 40.0
    wrap = np.arcsin((large - small) / middle)
    length = 2.0 * middle * np.cos(wrap) + pi * (small + large) + 2.0 * wrap * (large - small)
    assert _free_strand(20, 40, length) == pytest.approx(middle * np.cos(wrap), rel=1e-9)


def test_the_amplifier_is_a_second_order_butterworth():
    rate, cutoff = 20000.0, 500.0
    t = np.arange(40000) / rate
    for frequency in (100.0, 500.0, 1000.0):
        out = low_passed(np.cos(2.0 * pi * frequency * t), cutoff, rate)[20000:]
        gain = np.abs(2.0 * np.mean(out * np.exp(-2j * pi * frequency * t[20000:])))
        # straight lines between frames lose sinc^2, here below 1 % at 1 kHz
        assert gain == pytest.approx(1.0 / np.sqrt(1.0 + (frequency / cutoff) ** 4), rel=0.01)


def test_converter_and_encoder():
    codes = converted(np.array([-11.0, 0.1, 11.0]), full=10.0, bits=16)
    assert codes == pytest.approx([-10.0, 0.1, 10.0], abs=20.0 / 2**16)
    assert list(encoder_counts(np.array([-0.01, 0.0, 2.0 * pi]), 100)) == [-1, 0, 100]


def test_the_likelihood_ratio_of_white_noise_in_closed_form():
    rng = np.random.default_rng(3)
    size, ratio = 40000, 1.21
    draw = lambda factor, count: [np.sqrt(factor) * rng.standard_normal(size) for _ in range(count)]  # noqa: E731
    judged = draw(ratio, 1)[0]
    nats = whittle(judged, draw(1.0, 40), draw(ratio, 40), steady=True)
    # Kullback-Leibler divergence of two normal distributions, one per sample
    expected = 0.5 * size * (ratio - 1.0 - np.log(ratio))
    assert nats == pytest.approx(expected, rel=0.25)
    same = draw(1.0, 3)
    assert whittle(judged, same, same, steady=True) == 0.0
    assert levels(judged, same, same) == 0.0
