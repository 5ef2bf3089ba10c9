"""Which source of the angle is taken, what a tacho tells, and how far the stated uncertainties are true."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.orders.angle.best_angle import best_motor_angle, best_motor_speed
from torquerig.orders.angle.tacho import motor_angle_from_tacho, rising_edges
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE = 5000.0
AT = np.arange(50_000) / RATE
SPEED = 1000 * pi / 30
LINES = Kinematics(pole_pairs=7, slots=12, ratio=5).lines(2)
TRUE = SPEED * 1.004 * (AT + 0.0005 * np.sin(2 * pi * 0.3 * AT))


def recording(torque=None, others=None, **channels):
    torque = Channel(values=np.zeros(AT.size) if torque is None else torque, quantity="torque", unit="V")
    run = Run(speed=SPEED, gear_ratio=5, others=others or {})
    return Recording(sample_rate=RATE, channels={"torque_V": torque, **channels}, run=run)


def tacho(per_motor_turn):
    pulses = (np.mod(TRUE / (2 * pi) * per_motor_turn, 1.0) < 0.3) * 5.0
    return Channel(values=pulses + 0.05 * np.random.default_rng(1).normal(size=AT.size), quantity="tacho", unit="V")


def comb(amplitude, seed):
    rng = np.random.default_rng(seed)
    lines = sum(amplitude * np.cos(line.motor_order * TRUE + rng.uniform(0, 6)) for line in LINES)
    return lines + 0.1 * rng.normal(size=AT.size)


@pytest.mark.parametrize("pulses", [1.0, 2.0, 0.2, 0.4])
def test_a_tacho_tells_the_angle_and_how_many_pulses_a_turn_has(pulses):
    angle = motor_angle_from_tacho(recording(tacho=tacho(pulses)), ratio=5.0)
    assert f"{pulses:g} pulses" in angle.origin
    wrong = angle.values - TRUE
    # an edge is known to a sample: 0.02 rad
    assert np.std(wrong) < 0.03
    assert abs(angle.mean_speed(RATE) / (SPEED * 1.004) - 1) < 3e-4


def test_the_sheet_may_state_the_pulses():
    angle = motor_angle_from_tacho(recording(tacho=tacho(1.0), others={"tacho_pulses_per_motor_turn": 2}))
    assert angle.mean_speed(RATE) == pytest.approx(0.5 * 1.004 * SPEED, rel=1e-3)


def test_an_edge_lies_between_samples_and_noise_on_a_flank_makes_no_second():
    assert rising_edges(np.array([0.0, 0, 1, 1, 0, 0, 0.2, 0.6, 1, 1])) == pytest.approx([1.5, 6.75])
    assert rising_edges(np.array([0.0, 0, 0.6, 0.45, 0.6, 1, 1, 0, 0, 1])).size == 2
    assert rising_edges(np.full(10, 2.0)).size == 0


def test_sources_are_taken_in_their_order():
    speed = Channel(values=np.full(AT.size, SPEED * 1.004), quantity="motor_speed", unit="rad/s")
    torque = comb(0.1, 1)
    assert best_motor_angle(recording(torque, tacho=tacho(1.0), speed=speed), LINES).origin == "from the channel speed"
    assert "tacho" in best_motor_angle(recording(torque, tacho=tacho(1.0)), LINES).origin
    assert "by the lines of the torque" in best_motor_angle(recording(torque), LINES).origin


@pytest.mark.long
@pytest.mark.parametrize("amplitude", [0.02, 0.2])
def test_the_uncertainty_of_the_comb_is_of_the_right_size(amplitude):
    found = [best_motor_speed(recording(comb(amplitude, seed)), LINES) for seed in range(6)]
    stated = np.mean([one.half_width for one in found])
    # six draws, of one wander; where the speed varies by 0.1 % the interval is wider than these few errors
    truth = (TRUE[-1] - TRUE[0]) / (AT.size - 1) * RATE
    real = np.sqrt(np.mean([(one.value / truth - 1) ** 2 for one in found]))
    assert real < stated < 1e-4


def test_where_no_comb_stands_out_the_set_point_is_said_to_be_all():
    noise = np.random.default_rng(2).normal(size=AT.size)
    found = best_motor_speed(recording(noise), LINES)
    assert found.value == pytest.approx(SPEED, rel=1e-4)
    assert "set-point alone" in found.origin
    assert found.half_width == 0.01


def test_a_tacho_that_cannot_serve_is_refused():
    still = Channel(values=np.zeros(AT.size), quantity="tacho", unit="V")
    with pytest.raises(RecordingError, match="has 0 pulses"):
        motor_angle_from_tacho(recording(tacho=still))
    many = Channel(values=(np.mod(TRUE / (2 * pi) * 40.37, 1.0) < 0.3) * 1.0, quantity="tacho", unit="V")
    with pytest.raises(RecordingError, match="do not follow from"):
        motor_angle_from_tacho(recording(tacho=many), ratio=5.0)


def test_a_tacho_on_the_output_shaft_counts_by_the_ratio():
    # one pulse per output turn at 5:1: a fifth of a pulse per motor turn
    stated = recording(tacho=tacho(0.2), others={"tacho_pulses_per_output_turn": 1})
    assert "0.2 pulses a motor turn" in motor_angle_from_tacho(stated, ratio=5.0).origin
