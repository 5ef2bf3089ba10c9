"""Torques along a chain of stages against closed forms: a constant load and a trapezoid through box, belt and worm."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.metrics.sizing.drive_sizing import sizing
from torquerig.metrics.sizing.gearbox_use import before_sensor, behind_stage
from torquerig.metrics.sizing.open_data import exact_value
from torquerig.metrics.sizing.sized_drive import SizedDrive, sized_drive
from torquerig.scenario.reading import read_scenario

SHIPPED = load_catalog(shipped_folder())
FASTEST = 600.0  # rad/s, which no shipped gearbox states
NPT005 = SHIPPED.gearbox("NPT005-5").model_copy(update={"max_input_speed": exact_value(FASTEST)})
CATALOG = replace(SHIPPED, gearboxes={**SHIPPED.gearboxes, "NPT005-5": NPT005})
PEAK = 22.0  # N m, T2a of NPT005-5
MOTOR = "motor: {kind: motor, catalog: bldc-12n14p, coulomb: 0 N*m, viscous: 0 N*m*s/rad}"
BOX = "box: {kind: gear, catalog: NPT005-5, efficiency: 0.9, input_inertia: 2e-5 kg*m^2}"
PULLEY = "hub: {kind: body, inertia: 4e-4 kg*m^2, viscous: 0.01 N*m*s/rad}"
BELT = (
    "belt: {kind: belt, pinion_teeth: 20, wheel_teeth: 50, belt_teeth: 120, pitch: 5 mm, belt_stiffness: 100 kN, "
    "strand_damping: 1 N*s/m, efficiency: 0.96, pinion_inertia: 1e-4 kg*m^2, wheel_inertia: 2e-3 kg*m^2}"
)
REST = (
    "torque_sensor: {kind: torque_sensor, catalog: reference-10nm, inertia: 0.001 kg*m^2}",
    "wear_part: {kind: body, inertia: 0.05 kg*m^2}",
    "loop: {kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}",
)
STEADY = "operating_point: {output_speed: 60 rpm, load: {occupancy: 5 %}}"
LOAD = "load: {kind: particle_load, at: wear_part, mean_by_occupancy_percent: {0: 0 N*m, 5: 2 N*m}}"
RAMPS = """\
operating_point:
  profile: duty_cycle
  duty_cycle:
    segments:
      - {duration: 1 s, output_speed: 10 rad/s, ramp: true}
      - {duration: 1 s, output_speed: 0 rad/s, ramp: true}"""


def drive(*parts: str, point: str = STEADY) -> SizedDrive:
    listed = "\n".join(f"  {one}" for one in parts)
    document = parse_document(f"{point}\nmeasured: torque_sensor\nrig:\n{listed}\n", Path("chain.yaml"))
    return sized_drive(read_scenario(document, CATALOG, seed=1), CATALOG)


def test_a_constant_load_is_found_at_every_stage_with_the_friction_between() -> None:
    """2 N m at the sensor; 2 / (2.5 x 0.96) + 0.01 w at the box; the motor gives that over 5 x 0.9."""
    sized = drive(MOTOR, BOX, PULLEY, BELT, *REST, LOAD)
    hub = 0.01 * 2 * pi * 2.5
    behind_box = 2.0 / (2.5 * 0.96) + hub
    assert before_sensor(sized, {}).peak == pytest.approx(2.0, rel=1e-9)
    assert behind_stage(sized, {}, "belt").peak == pytest.approx(2.0, rel=1e-9)
    assert behind_stage(sized, {}, "box").peak == pytest.approx(behind_box, rel=1e-9)
    assert sized.requirement().rms_torque == pytest.approx(behind_box / (5 * 0.9), rel=1e-9)
    figures = sizing(sized, names=("gearbox_peak_use", "gearbox_speed_use")).figures
    assert figures["gearbox_peak_use"].value == pytest.approx(behind_box / PEAK, rel=1e-9)
    assert figures["gearbox_speed_use"].value == pytest.approx(2 * pi * 12.5 / FASTEST, rel=1e-9)


def test_accelerating_bodies_between_the_stages_take_their_share() -> None:
    """Forwards, without friction: each shaft transmits what the inertias behind it need; a ramp of 10 rad/s^2."""
    hub = PULLEY.replace(", viscous: 0.01 N*m*s/rad", "")
    sized = drive(MOTOR, BOX.replace("0.9", "1.0"), hub, BELT.replace("0.96", "1.0"), *REST, point=RAMPS)
    behind_belt = 0.051 * 10.0
    before_belt = (behind_belt + 2e-3 * 10.0) / 2.5 + (1e-4 + 4e-4) * 25.0
    assert behind_stage(sized, {}, "belt").peak == pytest.approx(behind_belt, rel=1e-9)
    assert before_sensor(sized, {}).peak == pytest.approx(behind_belt, rel=1e-9)
    assert behind_stage(sized, {}, "box").peak == pytest.approx(before_belt, rel=1e-9)


def test_a_gearbox_behind_a_belt_counts_from_its_own_input() -> None:
    sized = drive(MOTOR, BELT, BOX, *REST, LOAD)
    assert behind_stage(sized, {}, "box").peak == pytest.approx(2.0, rel=1e-9)
    assert behind_stage(sized, {}, "belt").peak == pytest.approx(2.0 / (5 * 0.9), rel=1e-9)
    figures = sizing(sized, names=("gearbox_speed_use", "gearbox_jam_use")).figures
    assert figures["gearbox_speed_use"].value == pytest.approx(2 * pi * 5 / FASTEST, rel=1e-9)
    jam = sized.part.torque_limit * 12.5 * 0.9 * 0.96 / PEAK
    assert figures["gearbox_jam_use"].value == pytest.approx(jam, rel=1e-9)


def test_of_two_gearboxes_the_one_that_is_used_more_counts() -> None:
    """The second of two equal boxes transmits more torque, the first turns faster."""
    sized = drive(MOTOR, BOX, BOX.replace("box", "second"), *REST, LOAD)
    figures = sizing(sized, names=("gearbox_peak_use", "gearbox_speed_use")).figures
    assert figures["gearbox_peak_use"].value == pytest.approx(2.0 / PEAK, rel=1e-9)
    assert figures["gearbox_speed_use"].value == pytest.approx(2 * pi * 25 / FASTEST, rel=1e-9)


def test_a_worm_is_sized_by_its_forward_efficiency_and_a_locked_one_brakes_itself() -> None:
    worm = (
        "worm: {kind: worm_gear, starts: 2, wheel_teeth: 60, lead_angle: 4 deg, friction: 0.08, stiffness: 5 kN*m/rad, "
        "damping: 2 N*m*s/rad, wheel_inertia: 2e-3 kg*m^2}"
    )
    sized = drive(MOTOR, worm, *REST, LOAD)
    part = sized.rig.part("worm")
    efficiency = float(part.efficiency)  # type: ignore[attr-defined]
    assert sized.requirement().rms_torque == pytest.approx(2.0 / (30 * efficiency), rel=1e-9)
    assert before_sensor(sized, {}).peak == pytest.approx(2.0, rel=1e-9)
    assert "gearbox_life_use" not in sizing(sized, names=("gearbox_life_use",)).figures


HUB_LOAD = "hub_load: {kind: particle_load, at: hub, mean_by_occupancy_percent: {0: 0 N*m, 5: 0.3 N*m}}"
PLAIN = (MOTOR, BOX, PULLEY.replace(", viscous: 0.01 N*m*s/rad", ""), BELT, *REST)


def test_a_load_before_a_stage_is_not_in_the_torque_of_that_stage() -> None:
    """0.3 N m at the hub, 2 N m at the sensor: the belt transmits 2 N m, the box 2 / (2.5 x 0.96) + 0.3."""
    sized = drive(*PLAIN, LOAD, HUB_LOAD)
    assert behind_stage(sized, {}, "belt").peak == pytest.approx(2.0, rel=1e-9)
    assert before_sensor(sized, {}).peak == pytest.approx(2.0, rel=1e-9)
    assert behind_stage(sized, {}, "box").peak == pytest.approx(2.0 / (2.5 * 0.96) + 0.3, rel=1e-9)


@pytest.mark.parametrize("other", ["", LOAD], ids=["alone", "beside a load at the end"])
@pytest.mark.parametrize("way", [1, -1])
def test_a_load_on_a_branch_before_a_stage_by_the_torque_of_a_cycle(way: int, other: str) -> None:
    """The cycle states 1.15 N m; it is shared as the rig's own means of 2 and 0.3 N m are, or all at the hub."""
    point = f"""\
operating_point:
  load: {{occupancy: 5 %}}
  profile: duty_cycle
  duty_cycle:
    segments:
      - {{duration: 1 s, output_speed: {10 * way} rad/s, load_torque: 1.15 N*m}}"""
    sized = drive(*PLAIN, *([other] if other else []), HUB_LOAD, point=point)
    end, hub = (1.0, 0.15) if other else (0.0, 1.15)
    assert behind_stage(sized, {}, "belt").peak == pytest.approx(end, abs=1e-9)
    assert before_sensor(sized, {}).peak == pytest.approx(end, abs=1e-9)
    assert behind_stage(sized, {}, "box").peak == pytest.approx(end / (2.5 * 0.96) + hub, rel=1e-9)


def test_a_held_load_before_a_stage_is_not_in_it_at_rest() -> None:
    """A rig without loads of a mean: the stated 1.2 N m acts at the hub, also while it stands."""
    point = """\
operating_point:
  profile: duty_cycle
  duty_cycle:
    segments:
      - {duration: 1 s, output_speed: 10 rad/s, load_torque: 1.2 N*m}
      - {duration: 1 s, output_speed: 0 rad/s, load_torque: 1.2 N*m}"""
    sized = drive(*PLAIN, HUB_LOAD.replace("0.3", "0"), point=point)
    belt = behind_stage(sized, {}, "belt").torque
    still = ~sized.requirement().step
    assert abs(belt[still]).max() == pytest.approx(0.0, abs=1e-9)


def test_a_sensor_at_the_foot_reads_the_motor_s_torque_without_its_friction() -> None:
    """A ramp of 10 rad/s^2 at the output: rotor and all behind it; 0.02 N m of friction is not read."""
    foot = "{kind: reaction_torque_sensor, stiffness: 30 kN*m/rad, damping: 0 N*m*s/rad, housing_inertia: 30 kg*cm^2"
    rubbing = "motor: {kind: motor, catalog: bldc-12n14p, coulomb: 0.02 N*m, viscous: 0 N*m*s/rad}"
    parts = (rubbing, f"foot: {foot}, bandwidth: 1 kHz}}", "drum: {kind: body, inertia: 0.05 kg*m^2}", REST[-1])
    listed = "\n".join(f"  {one}" for one in parts)
    document = parse_document(f"{RAMPS}\nmeasured: foot\nrig:\n{listed}\n", Path("foot.yaml"))
    sized = sized_drive(read_scenario(document, CATALOG, seed=1), CATALOG)
    expected = (0.05 + sized.part.inertia) * 10.0
    assert before_sensor(sized, {}).peak == pytest.approx(expected, rel=1e-9)
    assert sized.requirement().at_worst()[0] == pytest.approx(expected + 0.02, rel=1e-9)
