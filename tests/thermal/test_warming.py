"""A duty again and again: the settled cycle, the closed form of on and off, the time to the limit, runaway."""

from __future__ import annotations

from math import exp, inf, log

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.scenario.drive_requirement import DriveRequirement
from torquerig.thermal.motor_duty import MotorDuty, duty_of_recording, duty_of_requirement
from torquerig.thermal.thermal_motor import ThermalMotor
from torquerig.thermal.two_node import TwoNode
from torquerig.thermal.warming import warming

NETWORK = TwoNode(winding_capacity=90.0, housing_capacity=800.0, winding_to_housing=0.35, housing_to_ambient=0.75)
ONE_BODY = TwoNode(winding_capacity=90.0, housing_capacity=9e7, winding_to_housing=0.35, housing_to_ambient=1e-7)
COLD = np.zeros(2)
AMBIENT = 20.0  # where resistance is stated, so that copper loss starts at its cold value


def motor(network: TwoNode = NETWORK, *, copper: float = 40.0) -> ThermalMotor:
    return ThermalMotor(network=network, copper_loss=copper, torque_constant=0.5, coulomb=0.0, viscous=0.0, iron=0.0,
                        rated_speed=300.0, limit=130.0)  # fmt: skip


def duty(*stretches: tuple[float, float]) -> MotorDuty:
    """Return a duty of (duration, torque), at rest."""
    spans, torques = (np.array(column, dtype=float) for column in zip(*stretches, strict=True))
    still = np.zeros(spans.size)
    return MotorDuty(duration=spans, torque_square=torques**2, speed=still, speed_square=still,
                     peak_torque=float(torques.max()))  # fmt: skip


def test_the_settled_cycle_comes_back_to_itself():
    made = warming(motor(), duty((30, 2.0), (10, 3.0), (60, 0.0)), ambient=AMBIENT)
    settled = made.settled()
    times, course = made.course(settled)
    assert times[-1] == pytest.approx(100)
    assert course[-1] == pytest.approx(course[0], rel=1e-12)
    matrix, offset = made.cycle_map()
    start = COLD
    for _ in range(2000):
        start = matrix @ start + offset
    assert start == pytest.approx(settled, rel=1e-9)


def test_on_and_off_of_one_body_has_its_textbook_peak():
    """x = P R (1 - e^(-on/tau)) / (1 - e^(-(on + off)/tau)), tau = R C; copper without temperature coefficient.

    Intermittent duty S3 (IEC 60034-1): the rise swings between that and itself times e^(-off/tau). With the
    coefficient the loss grows, R and tau become R / (1 - k R) while the current flows.
    """
    on, off, copper = 20.0, 40.0, 40.0
    grown = 0.00393 * copper * 0.35
    hot, cool = exp(-on * (1 - grown) / (0.35 * 90)), exp(-off / (0.35 * 90))
    peak = copper * 0.35 / (1 - grown) * (1 - hot) / (1 - hot * cool)
    made = warming(motor(ONE_BODY, copper=copper), duty((on, 1.0), (off, 0.0)), ambient=AMBIENT)
    low, high, _ = made.extremes(made.settled())
    assert high - AMBIENT == pytest.approx(peak, rel=1e-5)
    assert low - AMBIENT == pytest.approx(peak * cool, rel=1e-5)


def test_a_short_cycle_is_as_warm_as_its_mean_square():
    """Far below the fast constant of 24 s only the mean heat counts (the temperature coefficient's swing is second)."""
    short = warming(motor(), duty((0.02, 2.0), (0.06, 0.0)), ambient=AMBIENT)
    even = warming(motor(), duty((1.0, 1.0)), ambient=AMBIENT)
    assert short.settled() == pytest.approx(even.settled(), rel=1e-3)


def test_time_to_the_limit_of_one_body():
    """t = -tau ln(1 - x / x_end), from cold, where copper loss is 120 W and the limit 20 + 30 C."""
    made = warming(motor(ONE_BODY, copper=120.0), duty((1e5, 1.0)), ambient=AMBIENT)
    grown = 0.00393 * 120 * 0.35
    end, tau = 120 * 0.35 / (1 - grown), 0.35 * 90 / (1 - grown)
    assert made.time_to(50.0, COLD) == pytest.approx(-tau * log(1 - 30 / end), rel=1e-4)
    assert made.time_to(AMBIENT + end * 1.01, COLD) is None


@pytest.mark.parametrize("limit", [60.0, 90.0, 97.0])
def test_the_cycle_that_reaches_the_limit_is_found(limit):
    made = warming(motor(), duty((4, 3.0), (10, 0.0), (1, 2.0)), ambient=AMBIENT)
    assert made.extremes(made.settled())[1] > limit
    found = made.time_to(limit, COLD)
    matrix, offset = made.cycle_map()
    state, cycle = COLD, 0
    while made.extremes(state)[1] < limit:
        state, cycle = matrix @ state + offset, cycle + 1
    assert cycle > 0
    assert cycle * 15 <= found <= (cycle + 1) * 15
    # at that moment it is there
    into, at = found - cycle * 15, state
    for stretch, span in zip(made.stretches, made.durations, strict=True):
        part = min(into, span)
        at, into = stretch.after(part, at), into - part
    assert at[0] + AMBIENT == pytest.approx(limit, abs=1e-6)


def test_runaway_has_no_settled_cycle_but_a_time():
    """k R > 1: 0.00393 x 300 W x 1.1 K/W = 1.3."""
    made = warming(motor(copper=300.0), duty((10, 1.0)), ambient=AMBIENT)
    assert made.settled() is None
    assert 0 < made.time_to(130.0, COLD) < 120


def test_friction_and_iron_warm_the_housing():
    one = ThermalMotor(network=NETWORK, copper_loss=0.0, torque_constant=0.5, coulomb=0.02, viscous=1e-4, iron=8.0,
                       rated_speed=300.0, limit=130.0)  # fmt: skip
    speed = 75.0
    loss = 0.02 * speed + 1e-4 * speed**2 + 8.0 / 8  # (1/4)^1.5
    running = MotorDuty(duration=np.array([1.0]), torque_square=np.zeros(1), speed=np.array([speed]),
                        speed_square=np.array([speed**2]), peak_torque=0.0)  # fmt: skip
    assert warming(one, running, ambient=AMBIENT).settled() == pytest.approx([loss * 0.75] * 2)


def test_a_demand_keeps_its_heat_however_it_is_cut():
    requirement = DriveRequirement(
        duration=np.array([30.0, 200.0, 0.1]),
        speed=np.array([[0.0, 100.0], [100.0, 100.0], [100.0, 0.0]]),
        torque=np.array([[1.0, 2.0], [2.0, 2.0], [-2.0, 0.0]]),
        step=np.zeros(3, dtype=bool),
        load=np.full((3, 2), np.nan),
        held=np.zeros(3, dtype=bool),
    )
    made = duty_of_requirement(requirement)
    assert made.rms_torque == pytest.approx(requirement.rms_torque)
    assert made.length == pytest.approx(230.1)
    assert made.mean_speed == pytest.approx((30 * 50 + 200 * 100 + 0.1 * 50) / 230.1)
    assert 25 < made.duration.size < 40


def recording(**channels: tuple[str, np.ndarray]) -> Recording:
    made = {name: Channel(values=values, quantity=quantity, unit="x") for name, (quantity, values) in channels.items()}
    return Recording(sample_rate=1000.0, channels=made, run=Run(speed=50.0))


def test_a_recorded_torque_becomes_its_mean_squares():
    time = np.arange(3000) / 1000
    made = duty_of_recording(recording(T=("motor_torque", np.where(time < 1, 2.0, np.sin(2 * np.pi * 10 * time)))))
    assert made.duration.sum() == pytest.approx(3.0)
    assert made.torque_square == pytest.approx([4, 4, 0.5, 0.5, 0.5, 0.5])
    assert made.speed == pytest.approx(50.0)
    assert made.peak_torque == 2.0
    with pytest.raises(RecordingError, match="there is no channel of motor torque; simulate with --truth"):
        duty_of_recording(recording(V=("torque", time)))


def test_nothing_is_infinite_in_a_cool_cycle():
    made = warming(motor(), duty((1, 0.0)), ambient=AMBIENT)
    assert made.extremes(made.settled()) == (AMBIENT, AMBIENT, AMBIENT)
    assert made.time_to(130.0, COLD) is None
    assert made.time_to(AMBIENT, COLD) == 0.0
    assert max(made.extremes(COLD)) < inf
