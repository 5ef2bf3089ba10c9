"""Ratio, teeth and torque gain of chains: all stages in any order, with and without teeth, from either end."""

from __future__ import annotations

from itertools import permutations
from math import prod
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import gears_to_sensor, kinematics_of, torque_gain, turns_to
from torquerig.scenario.reading import read_scenario

CATALOG = load_catalog(shipped_folder())
SPRING = "stiffness: 5 kN*m/rad, damping: 2 N*m*s/rad, output_inertia: 1 kg*cm^2"
STRAND = "belt_stiffness: 100 kN, strand_damping: 1 N*s/m, pinion_inertia: 1 kg*cm^2, wheel_inertia: 1 kg*cm^2"
STAGES = {
    "box": ("{kind: gear, catalog: reference-5-1}", 5.0, None),
    "toothed": (
        f"{{kind: belt, pinion_teeth: 20, wheel_teeth: 50, belt_teeth: 120, pitch: 5 mm, efficiency: 0.96, {STRAND}}}",
        2.5,
        50.0,
    ),
    "smooth": (
        f"{{kind: belt, pinion_diameter: 50 mm, wheel_diameter: 60 mm, belt_length: 1 m, {STRAND}}}", 1.2, None
    ),
    "pair": (f"{{kind: fixed_axis_gear, teeth: {{pinion: 21, wheel: 63}}, efficiency: 0.98, {SPRING}}}", -3.0, 63.0),
    "stated": (f"{{kind: gear, ratio: 1.5, {SPRING}}}", 1.5, None),
}  # fmt: skip


def rig_of(*parts: str, speed: str = "motor_speed: 1000 rpm") -> Rig:
    listed = "\n".join(f"  {one}" for one in parts)
    text = f"measured: torque_sensor\noperating_point: {{{speed}}}\nrig:\n{listed}\n"
    return read_scenario(parse_document(text, Path("bench.yaml")), CATALOG, seed=1).rig


MOTOR = "motor: {kind: motor, catalog: HDS6A-0104A}"
SENSOR = "torque_sensor: {kind: torque_sensor, catalog: reference-10nm}"
DRUM = "drum: {kind: body, inertia: 20 kg*cm^2}"
LOOP = "loop: {kind: speed_controller, motor: motor, kp: 0.05 N*m*s/rad, ki: 1 N*m/rad}"


@pytest.mark.parametrize("names", [*permutations(["box", "toothed", "pair"]), ("smooth", "stated", "toothed")])
def test_ratios_multiply_in_any_order_and_each_mesh_turns_with_its_own_shaft(names: tuple[str, ...]) -> None:
    """A mesh of z teeth on the output of a stage has the order z times the ratios behind it at the last shaft."""
    rig = rig_of(MOTOR, *(f"{name}: {STAGES[name][0]}" for name in names), SENSOR, DRUM, LOOP)
    ratios = [abs(STAGES[name][1]) for name in names]
    kinematics = kinematics_of(rig)
    assert kinematics.ratio == pytest.approx(prod(ratios))
    assert [gear.name for gear in gears_to_sensor(rig)] == list(names)
    meshes = {line.output_order for line in kinematics.lines(1) if line.family == "gear_mesh"}
    expected = {
        teeth * prod(ratios[place + 1 :])
        for place, name in enumerate(names) if (teeth := STAGES[name][2]) is not None
    }  # fmt: skip
    assert sorted(meshes) == pytest.approx(sorted(expected))
    assert kinematics.left_out["gear_mesh"].startswith("tooth counts of ")
    assert 1 / abs(rig.speed_ratios("motor")[rig.node("torque_sensor")]) == pytest.approx(kinematics.ratio)


def test_a_chain_without_any_known_teeth_has_none() -> None:
    rig = rig_of(MOTOR, f"box: {STAGES['box'][0]}", f"smooth: {STAGES['smooth'][0]}", SENSOR, DRUM, LOOP)
    assert kinematics_of(rig).teeth == ()
    assert kinematics_of(rig).ratio == pytest.approx(6.0)
    assert kinematics_of(rig).left_out["gear_mesh"] == "tooth counts unknown"


def test_teeth_give_the_exact_ratio_of_a_rounded_one() -> None:
    """25/7 = 3.5714, which a maker prints as 3.57."""
    stated = f"box: {{kind: gear, ratio: -3.57, teeth: {{pinion: 21, wheel: 75}}, {SPRING}}}"
    rig = rig_of(MOTOR, stated, SENSOR, DRUM, LOOP)
    assert kinematics_of(rig).ratio == pytest.approx(25 / 7, rel=1e-15)
    assert rig.speed_ratios("motor")["box"] == pytest.approx(-7 / 25, rel=1e-15)


def test_a_rig_listed_from_its_load_to_its_motor_is_the_same_machine() -> None:
    """Ratio, gain and orders do not depend on the end at which the list begins."""
    forth = rig_of(MOTOR, f"pair: {STAGES['pair'][0]}", SENSOR, DRUM, LOOP)
    turned = f"pair: {{kind: fixed_axis_gear, teeth: {{pinion: 63, wheel: 21}}, efficiency: 0.98, {SPRING}}}"
    back = rig_of(DRUM, SENSOR, turned, "motor: {kind: motor, catalog: HDS6A-0104A, after: pair}", LOOP)
    assert turns_to(forth, "torque_sensor") == turns_to(back, "torque_sensor") == pytest.approx(3.0)
    assert torque_gain(back) == pytest.approx(torque_gain(forth)) == pytest.approx(3 * 0.98)
    lines = [
        {line.output_order for line in kinematics_of(rig).lines(1) if line.family == "gear_mesh"}
        for rig in (forth, back)
    ]
    assert lines[0] == lines[1] == {63.0}


def test_a_sensor_on_another_branch_counts_the_stages_on_both_sides_of_the_fork() -> None:
    """The motor drives a fork over 3:1 backwards; the sensor is behind 2.5:1 on another branch."""
    rig = rig_of(
        "hub: {kind: body, inertia: 5 kg*cm^2}",
        f"toothed: {STAGES['toothed'][0]}", SENSOR, DRUM,
        f"pair: {{kind: fixed_axis_gear, after: hub, teeth: {{pinion: 63, wheel: 21}}, {SPRING}}}",
        "motor: {kind: motor, catalog: HDS6A-0104A, after: pair}", LOOP,
    )  # fmt: skip
    assert kinematics_of(rig).ratio == pytest.approx(7.5)
    assert 1 / abs(rig.speed_ratios(rig.node("motor"))[rig.node("torque_sensor")]) == pytest.approx(7.5)
    assert torque_gain(rig) == pytest.approx(7.5 * 0.96)
