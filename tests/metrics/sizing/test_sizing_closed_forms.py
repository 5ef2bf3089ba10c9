"""Figures of a sizing against closed forms: a trapezoid without friction, a load that is all inertia, known levels."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.best_ratio import AlphaBeta, alpha_beta
from torquerig.metrics.sizing.drive_current import drive_current
from torquerig.metrics.sizing.drive_sizing import (
    EXCEEDS,
    HOLDS,
    LIMITED,
    SIZING_UNITS,
    UNKNOWN,
    UNSURE,
    limit_word,
    sizing,
)
from torquerig.metrics.sizing.gearbox_use import BOTH_WAYS, ONE_WAY, behind_stage, gearbox_use, service_factor
from torquerig.metrics.sizing.inertia_ratio import inertia_ratio
from torquerig.metrics.sizing.load_fidelity import reading_per_load, rigid_fidelity
from torquerig.metrics.sizing.open_data import exact_value, over_intervals
from torquerig.metrics.sizing.output_torque import OutputTorque
from torquerig.metrics.sizing.regeneration import regenerated, regeneration
from torquerig.metrics.sizing.sensor_use import sensor_use
from torquerig.metrics.sizing.sized_drive import sized_drive
from torquerig.metrics.sizing.speed_torque import continuous_torque, speed_torque, voltage_torque
from torquerig.parameter import Estimate
from torquerig.scenario.drive_requirement import DriveRequirement
from torquerig.scenario.reading import read_scenario

CATALOG = load_catalog(shipped_folder())
ROTOR, BODY, RATIO, TOP = 1.5e-4, 0.03, 5.0, 20.0  # kg m^2, kg m^2, 1, rad/s of the output
SCENARIO = """
operating_point:
  profile: duty_cycle
  duty_cycle:
    segments:
      - {duration: 1 s, output_speed: 20 rad/s, ramp: true}
      - {duration: 1 s, output_speed: 20 rad/s}
      - {duration: 1 s, output_speed: 0 rad/s, ramp: true}
      - {duration: 1 s, output_speed: 0 rad/s}
rig:
  motor: {kind: motor, catalog: bldc-12n14p, coulomb: 0 N*m, viscous: 0 N*m*s/rad}
  gearbox: {kind: gear, catalog: NPT005-5, efficiency: 1.0, input_inertia: 0 kg*m^2, output_inertia: 0.001 kg*m^2}
  torque_sensor: {kind: torque_sensor, catalog: reference-10nm, inertia: 0.001 kg*m^2}
  wear_part: {kind: body, inertia: 0.028 kg*m^2}
  speed_controller: {kind: speed_controller, motor: motor, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}
"""


def drive(text: str = SCENARIO):
    document = parse_document(text, Path("trapezoid.yaml"))
    return sized_drive(read_scenario(document, CATALOG, seed=1), CATALOG)


def test_trapezoid_without_friction_has_the_textbook_torque():
    sized = sizing(drive(), names=("rms_torque",)).figures
    turned = (ROTOR + BODY / RATIO**2) * TOP * RATIO  # N m for 1 s up and 1 s down of 4 s
    assert sized["peak_torque"].value == pytest.approx(turned)
    assert sized["rms_torque"].value == pytest.approx(turned / sqrt(2))
    assert sized["peak_power"].value == pytest.approx(turned * TOP * RATIO)
    assert sized["mean_speed"].value == pytest.approx(TOP * RATIO / 2)


def test_inertia_ratio_of_the_trapezoid():
    assert inertia_ratio(drive())["inertia_ratio"].value == pytest.approx(BODY / RATIO**2 / ROTOR)


def test_braking_gives_back_all_kinetic_energy_and_copper_takes_its_share():
    sized = drive()
    kinetic = 0.5 * (ROTOR + BODY / RATIO**2) * (TOP * RATIO) ** 2
    found = regeneration(sized)
    assert found["braking_energy"].value == pytest.approx(kinetic)
    left = found["regenerated_energy"]
    assert left.low is not None
    assert left.high is not None
    assert 0 <= left.low < left.high < kinetic
    assert "torque constant of bldc-12n14p" in left.missing


@pytest.mark.parametrize("copper", [0.0, 3.0, 40.0])
def test_given_back_agrees_with_a_fine_sum(copper):
    requirement = DriveRequirement(duration=np.array([2.0, 1.0]), speed=np.array([[10.0, 2.0], [5.0, 5.0]]),
                         torque=np.array([[1.0, -1.5], [-0.1, 0.2]]), step=np.array([False, False]),
                         load=np.full((2, 2), np.nan), held=np.array([False, False]))  # fmt: skip
    share = (np.arange(200_000) + 0.5) / 200_000
    total = 0.0
    for span, torque, speed in zip(requirement.duration, requirement.torque, requirement.speed, strict=True):
        moment, turned = (one[0] + share * (one[1] - one[0]) for one in (torque, speed))
        total += span * float(np.mean(np.maximum(0.0, -(moment * turned + copper * moment**2))))
    assert regenerated(requirement, copper=copper) == pytest.approx(total, rel=1e-6, abs=1e-9)


def test_alpha_beta_of_an_inertia_is_the_matched_one():
    """Inertial load: i = sqrt(J_L / J_M), and beta = 4 J_L w^2 (Giberti, Cinquemani and Legnani 2011, eq. 24)."""
    load, rotor, turned = 0.02, 3e-4, 50.0
    task = AlphaBeta(torque=load * turned, acceleration=turned, product=load * turned**2, inertia=rotor)
    assert task.best == pytest.approx(sqrt(load / rotor))
    assert task.beta == pytest.approx(4 * load * turned**2)
    least = task.rms_torque(task.best)
    assert least == pytest.approx(2 * sqrt(load * rotor) * turned)
    assert task.alpha(least) == pytest.approx(task.beta)  # the smallest motor that fits, at one ratio only
    ratios = np.geomspace(1, 100, 999)
    assert min(task.rms_torque(one) for one in ratios) == pytest.approx(least, rel=1e-4)


def test_at_the_ends_of_the_fitting_range_the_torque_is_the_rating():
    task = AlphaBeta(torque=4.0, acceleration=30.0, product=25.0, inertia=2e-4, efficiency=0.9)
    low, high = task.fitting(1.0)
    assert low < task.best < high
    for ratio in (low, high):
        assert task.rms_torque(ratio) == pytest.approx(1.0)
    assert task.fitting(0.99 * task.rms_torque(task.best)) is None


def test_without_acceleration_only_speed_bounds_the_ratio():
    steady = AlphaBeta(torque=4.0, acceleration=0.0, product=0.0, inertia=2e-4, efficiency=0.8)
    assert steady.best == float("inf")
    assert steady.fitting(1.0) == (pytest.approx(5.0), float("inf"))
    assert steady.rms_torque(5.0) == pytest.approx(1.0)


def test_the_task_of_the_trapezoid_and_its_own_ratio():
    sized = drive()
    task = alpha_beta(sized)
    assert task.best == pytest.approx(sqrt(BODY / ROTOR))
    assert task.rms_torque(RATIO) == pytest.approx(sized.requirement().rms_torque)


def test_behind_the_gear_stands_what_turns_the_load():
    behind = behind_stage(drive(), {}, "gearbox")
    assert behind.peak == pytest.approx(BODY * TOP)
    assert behind.alternates
    assert not behind.reverses


def test_cubic_mean_of_two_levels():
    ends = np.array([[4.0, 4.0], [1.0, 1.0]])
    behind = OutputTorque(duration=np.array([1.0, 3.0]), speed=np.array([[2.0, 2.0], [2.0, 2.0]]), torque=ends,
                          acceleration=np.zeros(2))  # fmt: skip
    assert behind.cubic_mean == pytest.approx(((4**3 + 3 * 1) / 4) ** (1 / 3))
    assert not behind.alternates
    assert replace(behind, speed=np.zeros((2, 2))).cubic_mean == 0


def test_service_factor_follows_the_cycle():
    assert service_factor(drive(), "gearbox") is BOTH_WAYS  # braking loads the other flank
    loaded = SCENARIO.replace(" rad/s", " rad/s, load_torque: 2 N*m")  # more than braking takes
    assert (
        service_factor(drive(loaded.replace("  speed_controller", LOAD + "  speed_controller")), "gearbox") is ONE_WAY
    )


LOAD = """  load: {kind: particle_load, at: wear_part, mean_by_occupancy_percent: {0: 2 N*m}, hit_rate: 60 1/s,
         hit_decay: 4 ms, hit_shape: 1.5, hit_rms: 0.1, slow_rms: 0.06, slow_cutoff: 1.5 Hz}
"""


def test_gearbox_sensor_and_current_in_closed_form():
    sized = drive()
    box = gearbox_use(sized)
    assert box["gearbox_peak_use"].value == pytest.approx(BODY * TOP / 22.0)  # T2a of the NPT005 [B2]
    assert box["gearbox_jam_use"].value == pytest.approx(2.0 * RATIO / 22.0)
    assert box["gearbox_speed_use"].unknown
    assert box["gearbox_speed_use"].missing == "largest input speed of NPT005-5"
    sensor = sensor_use(sized)
    assert sensor["sensor_range_use"].value == pytest.approx(2.0 * RATIO / 10.0)
    assert (sensor["sensor_overload"].low, sensor["sensor_overload"].high) == pytest.approx((0.5, 1 / 1.5))
    current = drive_current(sized)
    assert current["limit_current"].value == pytest.approx(2.0 / 0.15)
    assert (current["limit_current"].low, current["limit_current"].high) == pytest.approx((2 / 0.40, 2 / 0.04))
    assert current["rms_current_use"].missing == "rated current of bldc-12n14p"


def test_share_of_the_load_is_that_of_the_inertias_and_of_the_twin():
    text = SCENARIO.replace("  speed_controller", LOAD + "  speed_controller")
    rig = drive(text).rig
    before = ROTOR * RATIO**2 + 0.001
    assert rigid_fidelity(rig) == pytest.approx(before / (before + 0.029))
    open_loop = np.abs(reading_per_load(rig, np.array([1.0]), closed=False))[0]
    assert open_loop == pytest.approx(rigid_fidelity(rig), rel=2e-3)  # the first mode lies at 60 Hz: (1/60)^2
    assert np.abs(reading_per_load(rig, np.array([0.01]), closed=True))[0] == pytest.approx(1.0, abs=0.01)


def test_a_figure_over_intervals_names_the_datum_that_decides():
    data = {"wide": Estimate(low=1.0, high=3.0), "narrow": Estimate(2.0, low=1.9, high=2.1), "exact": exact_value(10.0)}
    found = over_intervals(data, lambda v: v["exact"] * v["wide"] / v["narrow"])
    assert (found.low, found.high) == pytest.approx((10 / 2.1, 30 / 1.9))
    assert found.value is None  # nobody states the wide one
    assert found.missing == "wide, narrow"
    assert over_intervals({**data, "lost": Estimate()}, lambda v: v["lost"]).missing == "lost"
    assert over_intervals(data, lambda v: v["exact"]) == Figure(value=10.0)


@pytest.mark.parametrize(
    ("figure", "word"),
    [(Figure(value=1.0), HOLDS), (Figure(low=0.5, high=1.2), UNSURE), (Figure(low=1.1, high=1.2), EXCEEDS),
     (Figure(missing="x"), UNKNOWN)],
)  # fmt: skip
def test_words(figure, word):
    assert limit_word(figure) == word


def test_every_limited_figure_is_a_share():
    assert set(LIMITED) <= set(SIZING_UNITS)
    assert {SIZING_UNITS[name] for name in LIMITED} == {"1"}
    assert set(sizing(drive()).figures) == set(SIZING_UNITS)


def test_regions_meet_the_ratings():
    sized = sized_drive(
        read_scenario(parse_document(SCENARIO.replace("bldc-12n14p", "HDS6A-0104A"), Path("servo.yaml")), CATALOG,
                      seed=1), CATALOG)  # fmt: skip
    regions = speed_torque(sized)
    assert regions.continuous[0] == pytest.approx([1.4, 1.4])  # T0 and Tn of Table VII
    rated = np.array([3000 * pi / 30])
    assert continuous_torque(rated, 1.4, 1.27, rated[0], 2 * rated[0]) == pytest.approx([1.27])
    assert continuous_torque(2 * rated, 1.4, 1.27, rated[0], 2 * rated[0]) == pytest.approx([1.27 / 2])
    assert (regions.intermittent[:, 0] <= regions.intermittent[:, 1]).all()
    assert regions.intermittent[0, 1] == pytest.approx(4.46)


def test_voltage_limit_of_a_motor_without_inductance():
    """Without inductance: V = E + sqrt(3) R I."""
    speed, constant, resistance, supply = np.array([100.0, 1e4]), 0.5, 2.0, 230.0
    found = voltage_torque(speed, supply=supply, constant=constant, resistance=resistance, reactance=0.0)
    assert found[0] == pytest.approx(constant * (supply - constant * 100 / sqrt(3)) / (sqrt(3) * resistance))
    assert found[1] == 0  # the back-EMF alone is above the supply


def test_a_rig_without_a_speed_is_refused():
    still = SCENARIO.replace("profile: duty_cycle", "profile: steady")
    with pytest.raises(InputError, match="nothing can be sized"):
        drive(still)
