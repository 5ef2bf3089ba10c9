"""The kinematic lines against the reference report's eq. 3.1-3.4 and Table I, and against handbook."""

from dataclasses import replace
from math import pi

import pytest

from torquerig.errors import InputError
from torquerig.orders.kinematics.kinematic_lines import Kinematics, kinematic_lines
from torquerig.orders.kinematics.line_families import FAMILIES
from torquerig.orders.kinematics.teeth import Planetary, Spur

RPM = pi / 30
OF_A_DRIVE = [family for family in FAMILIES if family not in ("intermediate", "belt", "bearing")]  # others need a rig
REPORT_MOTOR = Kinematics(pole_pairs=7, slots=12, ratio=5)


def frequencies(kinematics, family, rpm=1000.0, harmonics=4):
    return [line.frequency(rpm * RPM) for line in kinematics.lines(harmonics) if line.family == family]


@pytest.mark.parametrize(
    ("family", "printed"),
    [
        # reference report, Table I; 12.32 there is 13.33 (report audit A), the others are printed to two digits
        ("shaft", [3.33, 6.66, 9.99, 13.33]),
        ("motor", [16.67, 33.33, 50.0, 66.66]),
        ("cogging_per_pole", [100.0, 200.0, 300.0, 400.0, 500.0]),
        ("electrical", [116.67, 233.33, 350.0, 466.66, 583.33]),
        ("slots_times_pole_pairs", [280.0, 560.0, 840.0, 1120.0, 1400.0]),
    ],
)
def test_table_i_of_the_reference_report(family, printed):
    # the table cuts instead of rounding: up to 0.01 below per printed digit, 9.99 for 10.00
    assert frequencies(REPORT_MOTOR, family, harmonics=len(printed)) == pytest.approx(printed, abs=0.011)


@pytest.mark.parametrize(
    ("family", "motor_order", "hertz"),
    [
        # handbook section 7, at 1000 rpm
        ("cogging", 84, 1400.0),
        ("cogging_tolerance_slots", 12, 200.0),
        ("cogging_tolerance_poles", 14, 700.0 / 3),
        ("six_pulse", 42, 700.0),
    ],
)
def test_handbook_coincidence_table(family, motor_order, hertz):
    line = next(line for line in REPORT_MOTOR.lines() if line.family == family)
    assert line.motor_order == motor_order
    assert line.output_order == 5 * motor_order
    assert line.frequency(1000 * RPM) == pytest.approx(hertz, rel=1e-12)


def test_planetary_21_84_meshes_at_280_hz_at_1000_rpm():
    # handbook section 9
    geared = replace(REPORT_MOTOR, teeth=(Planetary(21, 84, 3),))
    assert frequencies(geared, "gear_mesh") == pytest.approx([280.0, 560.0, 840.0, 1120.0], rel=1e-12)
    assert frequencies(geared, "gear_mesh", rpm=600) == pytest.approx([168.0, 336.0, 504.0, 672.0], rel=1e-12)
    line = next(line for line in geared.lines() if line.family == "gear_mesh")
    assert line.output_order == 84.0


def test_two_stages_mesh_at_their_own_shafts():
    # 20:50 then 42:84 stand at 84 per output turn, that is 280 Hz at 1000 rpm and 5:1 (report audit C)
    geared = Kinematics(ratio=5, teeth=(Spur(20, 50), Spur(42, 84)))
    first, second = (line for line in geared.lines(1) if line.family == "gear_mesh")
    assert (first.motor_order, first.output_order) == (20.0, 100.0)
    assert (second.motor_order, second.output_order) == pytest.approx((16.8, 84.0))


def test_two_equal_stages_keep_their_places():
    stage = Planetary(21, 84, 3)
    geared = Kinematics(ratio=25, teeth=(stage, stage))
    first, second = (line for line in geared.lines(1) if line.family == "gear_mesh")
    assert (first.output_order, second.output_order) == (420.0, 84.0)
    assert (first.motor_order, second.motor_order) == pytest.approx((16.8, 3.36))


def test_motor_and_output_order_differ_by_the_ratio_in_every_line():
    geared = replace(REPORT_MOTOR, teeth=(Planetary(21, 84, 3),))
    assert {line.family for line in geared.lines()} == set(OF_A_DRIVE)
    for line in geared.lines():
        assert line.output_order == pytest.approx(5 * line.motor_order, rel=1e-12)


def test_frequency_is_proportional_to_speed_and_blind_to_its_sign():
    for line in REPORT_MOTOR.lines():
        assert line.frequency(-3.0) == line.frequency(3.0) == pytest.approx(3 * line.frequency(1.0))


def test_what_is_unknown_leaves_its_lines_out_and_is_named():
    induction = Kinematics(pole_pairs=2, slots=None, ratio=1)
    assert {line.family for line in induction.lines()} == {
        "shaft",
        "motor",
        "cogging_tolerance_poles",
        "electrical",
        "six_pulse",
    }
    assert induction.left_out["cogging"] == "slots unknown"
    assert set(induction.left_out) | {line.family for line in induction.lines()} == set(OF_A_DRIVE)
    bare = Kinematics(ratio=5)
    assert set(bare.left_out) | {line.family for line in bare.lines()} == set(OF_A_DRIVE)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"pole_pairs": 0}, "pole pairs are not possible"),
        ({"slots": -12}, "slots are not possible"),
        ({"ratio": 0.0}, "gear ratio"),
        ({"ratio": float("nan")}, "gear ratio"),
        ({"harmonics": 0}, "harmonics are not possible"),
        ({"teeth": (Planetary(18, 72, 3),), "ratio": 4.0}, "teeth give a ratio of 5"),
    ],
)
def test_counts_that_cannot_be_are_refused(wrong, message):
    with pytest.raises(InputError, match=message):
        kinematic_lines(**({"pole_pairs": 7, "slots": 12, "ratio": 5.0} | wrong))
