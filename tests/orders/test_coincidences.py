"""Coincidences at 1000 rpm against handbook section 7, and the search for a better speed."""

from math import pi

import pytest

from torquerig.orders.kinematics.coincidences import better_speed, coincidences
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.teeth import Planetary

RPM = pi / 30
REPORT_MOTOR = Kinematics(pole_pairs=7, slots=12, ratio=5, teeth=(Planetary(21, 84, 3),))


def test_every_motor_order_divisible_by_three_stands_on_the_mains_at_1000_rpm():
    # handbook 0: f_m = 50/3 Hz, so M3k = 50 k Hz
    found = coincidences(REPORT_MOTOR.lines(), 1000 * RPM)
    expected = {
        line for line in REPORT_MOTOR.lines() if line.motor_order % 3 == 0 and line.frequency(1000 * RPM) <= 40 * 50
    }
    assert {hit.line for hit in found.on_mains} == expected
    assert {hit.multiple for hit in found.on_mains} >= {1, 2, 4, 6, 7, 8, 14, 28}
    assert max(abs(hit.offset) for hit in found.on_mains) < 1e-9


def test_equal_orders_of_the_handbook_table():
    # handbook section 7: 14 = 2p = 2 x p, 84 = LCM = 12 p, ring 84 = the reference report's code line 36
    groups = {
        group.motor_order: {(line.family, line.harmonic) for line in group.lines}
        for group in coincidences(REPORT_MOTOR.lines(), 1000 * RPM).equal_orders
    }
    assert groups[14.0] == {("cogging_tolerance_poles", 1), ("electrical", 2)}
    assert groups[84.0] == {("cogging", 1), ("six_pulse", 2)}
    assert groups[16.8] == {("gear_mesh", 1), ("slots_times_pole_pairs", 1)}
    assert all(len({family for family, _ in members}) > 1 for members in groups.values())


def test_the_better_speed_is_the_nearest_clear_one():
    lines = REPORT_MOTOR.lines()
    found = better_speed(lines, 1000 * RPM, clearance=1.0)

    def smallest(rpm):
        return min(abs(line.frequency(rpm * RPM) - 50 * multiple) for line in lines for multiple in range(1, 41))

    rpm = found.motor_speed / RPM
    assert not found.crowded
    assert smallest(rpm) == pytest.approx(found.clearance)
    assert found.clearance >= 1.0
    nearer = range(1000 - round(abs(rpm - 1000)) + 1, 1000 + round(abs(rpm - 1000)))
    assert all(smallest(each) < 1.0 for each in nearer)


def test_a_clear_speed_is_kept():
    assert better_speed(REPORT_MOTOR.lines(), 970 * RPM).motor_speed == pytest.approx(970 * RPM)


def test_a_60_hz_grid_has_other_coincidences():
    found = coincidences(REPORT_MOTOR.lines(), 1000 * RPM, mains=60)
    assert {hit.multiple for hit in found.on_mains} >= {5, 10}  # M18 = 300, M36 = 600 Hz
    assert not any(hit.line.family == "motor" for hit in found.on_mains)


def test_what_no_speed_can_clear_is_named():
    # within 0.1 % of 1000 rpm no motor order can leave the mains by 1 Hz: M3 moves by 0.05 Hz
    found = better_speed(REPORT_MOTOR.lines(), 1000 * RPM, within=0.001)
    assert found.clearance < 1.0
    assert ("motor", 3) in {(line.family, line.harmonic) for line in found.crowded}


def test_no_lines_have_no_coincidences():
    assert coincidences((), 100.0).on_mains == ()
    assert better_speed((), 100.0).crowded == ()
