"""What a run asks of its motor, by hand-made numbers; the impossible is refused and the rest flagged, by name."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi, sqrt

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.rig.parts import Motor
from torquerig.rig.steady import steady_torque
from torquerig.scenario.checks.requirement_check import check_requirement, requirement_faults
from torquerig.scenario.drive_requirement import drive_requirement
from torquerig.scenario.model import Scenario
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario

# ruff: noqa: E501 (a table: one case in a row)
RPM = pi / 30
RATIO, EFFICIENCY = 5, 0.97


@cache
def catalog():
    return load_catalog(shipped_folder())


def wear_rig(*settings: str) -> Scenario:
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), settings)
    return read_scenario(document, catalog(), seed=1)


def cycle(*segments: str) -> tuple[str, ...]:
    return ("profile=duty_cycle", f"operating_point.duty_cycle={{segments: [{', '.join(segments)}]}}")


def test_steady_torque_by_hand():
    """(1.0 load + 0.010 x 20.944 drag) / (5 x 0.97) at the wear part; 0.015 + 1.5e-4 x 104.72 in the motor."""
    asked, _ = drive_requirement(wear_rig().rig, duration=10).at_worst()
    assert asked == pytest.approx((1.0 + 0.010 * 200 * RPM) / (RATIO * EFFICIENCY) + 0.015 + 1.5e-4 * 1000 * RPM)


@pytest.mark.parametrize("occupancy", [0, 5, 21])
def test_steady_torque_is_the_one_that_ripple_is_counted_from(occupancy):
    """One place for both: a steady profile asks for what the lines of the motor are counted from."""
    rig = wear_rig(f"load.occupancy={occupancy}").rig
    assert drive_requirement(rig, duration=10).rms_torque == pytest.approx(steady_torque(rig, "motor"), rel=1e-9)


def test_power_flows_back_while_braking():
    """What the inertia gives back arrives times the efficiency, what the load takes is there still."""
    made = wear_rig(*cycle("{duration: 1 s, motor_speed: 1000 rpm, load_torque: 0 N*m}",
                           "{duration: 0.1 s, motor_speed: 0 rpm, ramp: true, load_torque: 0 N*m}"))  # fmt: skip
    requirement = drive_requirement(made.rig, duration=10)
    slope = -1000 * RPM / 0.1
    # the first piece begins with the step from the rest in which the cycle ends
    assert requirement.step.tolist() == [True, False, False]
    beyond = made.rig.terms()
    ratios = made.rig.speed_ratios("motor")
    inertia = sum(term.inertia * ratios[term.node] ** 2 for term in beyond if hasattr(term, "inertia"))
    rotor = 1.5e-4
    drag = 0.010 * 200 * RPM / RATIO
    expected = rotor * slope + 0.015 + 1.5e-4 * 1000 * RPM + EFFICIENCY * ((inertia - rotor) * slope + drag)
    assert requirement.torque[2, 0] == pytest.approx(expected, rel=1e-6)


def test_rms_of_a_straight_piece_is_exact():
    requirement = drive_requirement(wear_rig("profile=ramp").rig, duration=10)
    fine = np.concatenate([np.linspace(a, b, 20001)[:-1] for a, b in requirement.torque])
    weights = np.repeat(requirement.duration / 20000, 20000)
    assert requirement.rms_torque == pytest.approx(sqrt(np.sum(weights * fine**2) / np.sum(weights)), rel=1e-4)


def test_a_step_takes_the_drives_limit_for_as_long_as_it_needs():
    made = wear_rig(*cycle("{duration: 5 s, motor_speed: 1000 rpm}", "{duration: 5 s, motor_speed: 0 rpm}"))
    requirement = drive_requirement(made.rig, duration=10)
    rows = np.flatnonzero(requirement.step)
    assert np.abs(requirement.torque[rows]) == pytest.approx(2.0)
    assert requirement.duration.sum() == pytest.approx(10)
    # braking is helped by the load and the friction, so it is shorter
    assert requirement.duration[rows[1]] < requirement.duration[rows[0]] < 0.1
    assert not requirement.late


def test_within_all_ratings_nothing_is_said():
    assert check_requirement(wear_rig(), catalog(), duration=10) == ()


REFUSED = {
    "torque": (("load.occupancy=21", "motor.torque_limit=0.5 N*m"),
               r"bldc-12n14p must give 0\.857 N\*m at 0 s, and its drive's limit is 0\.5 N\*m; lower the load"),
    "acceleration": (cycle("{duration: 10 ms, output_speed: 300 rpm, ramp: true}", "{duration: 1 s, output_speed: 0 rpm}"),
                     r"must give .* N\*m at 0\.01 s, and its drive's limit is 2 N\*m; lower the load or the accel"),
    "speed": (("output_speed=1300 rpm",), r"bldc-12n14p needs 6500 rpm, reaches at most 6000 rpm; choose a smaller"),
    "short": (("operating_point.duty_cycle={segments: [{duration: 2 s, motor_speed: 9 rpm}], repeats: 4}",
               "profile=duty_cycle"), r"duty_cycle ends after 8 s, and the run lasts 10 s; make the run shorter"),
}  # fmt: skip


@pytest.mark.parametrize(("settings", "told"), REFUSED.values(), ids=REFUSED)
def test_the_impossible_is_refused_with_its_line(settings, told):
    with pytest.raises(InputError, match=rf"wear_rig\.yaml:\d+: operating_point: .*{told}"):
        check_requirement(wear_rig(*settings), catalog(), duration=10)


FLAGGED = {
    "speed unsure": (("output_speed=700 rpm", "load.occupancy=0"), "its largest speed is known only as 3000..6000 rpm"),
    "above rated": (("output_speed=700 rpm", "load.occupancy=0"), "needs 3500 rpm, above its rated 1000..3000 rpm"),
    "torque unsure": (("load.occupancy=21",), "an rms torque of 0.857 N*m, which may exceed its rated 0.78..1.24 N*m"),
    "beyond rated": (("load.mean_by_occupancy_percent={0: 6 N*m, 21: 6 N*m}",), "which exceeds its rated 0.78..1.24"),
    "late": (cycle("{duration: 10 ms, output_speed: 300 rpm}", "{duration: 1 s, output_speed: 0 rpm}"),
             "cannot follow the step from 0 to 1500 rpm of the motor at 0 s: it takes 0.0235 s at the drive"),
    "too slow": (("motor.catalog=GP-71M", "output_speed=20 rpm"), "turns with 100 rpm, below the 150..400 rpm of"),
}  # fmt: skip


@pytest.mark.parametrize(("settings", "told"), FLAGGED.values(), ids=FLAGGED)
def test_what_is_beyond_a_rating_is_flagged(settings, told):
    assert any(told in flag for flag in check_requirement(wear_rig(*settings), catalog(), duration=10))


def test_a_supply_too_low_for_the_speed_is_refused_and_near_it_flagged():
    """HDS6A-0104A: Kt 0.50..0.55 N*m/Arms at 6000 rpm is a back-EMF of 181..200 V between phases, of 230 V."""
    made = wear_rig("motor.catalog=HDS6A-0104A", "motor.torque_limit=2 N*m", "output_speed=1200 rpm")
    entry = catalog().motor("HDS6A-0104A")
    requirement = drive_requirement(made.rig, duration=1)

    def told(volts: float) -> tuple[bool, str]:
        low = entry.model_copy(update={"supply_voltage": replace(entry.supply_voltage, value=volts)})
        faults = [one for one in requirement_faults(requirement, made.rig, low) if "supply" in one.text]
        return (faults[0].impossible, faults[0].text) if faults else (False, "")

    assert told(180)[0]
    assert "has a back-EMF of 181 V or more at 6000 rpm, above its supply of 180 V" in told(180)[1]
    assert not told(195)[0]
    assert "may need up to" in told(195)[1]
    assert told(400) == (False, "")


def test_a_limit_above_what_motor_and_drive_give_helps_nothing():
    made = wear_rig("load.mean_by_occupancy_percent={0: 12 N*m, 21: 12 N*m}", "motor.torque_limit=5 N*m")
    assert made.rig.parts_of(Motor)[0].torque_limit == 5
    with pytest.raises(InputError, match=r"must give 2\.\d+ N\*m, more than its peak torque 2 N\*m"):
        check_requirement(made, catalog(), duration=10)


def test_an_induction_motor_on_an_inverter_is_asked_too():
    """Breakdown at 2.2 times 1.8 N*m; 20 N*m at the wear part are 4.1 N*m at the motor."""
    drive = ("rig.speed_controller={kind: induction_drive, pole_pairs: 2, rated_torque: 1.8 N*m, rated_speed: 1380 rpm,"
             " breakdown_torque: 4 N*m}")  # fmt: skip
    made = wear_rig(drive, "motor.catalog=GP-71M")
    assert check_requirement(made, catalog(), duration=10) == ()
    heavy = wear_rig(drive, "motor.catalog=GP-71M", "load.mean_by_occupancy_percent={0: 20 N*m, 21: 20 N*m}")
    with pytest.raises(InputError, match=r"GP-71M must give 4\.\d+ N\*m at 0 s, and its drive's limit is 2 N\*m"):
        check_requirement(heavy, catalog(), duration=10)
