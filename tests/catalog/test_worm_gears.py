"""A worm gear of the catalog: its numbers, its class, its part in a scenario, and its exchange in a study."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.part_class import PartClass
from torquerig.catalog.reading import Catalog, load_catalog, read_classes, read_entry
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.rig.parts.worm_gear import WormGear
from torquerig.scenario.reading import read_scenario
from torquerig.study.definition import open_study
from torquerig.study.exchanged_data import document_of

ENTRY = """
name: W50-20
title: "a worm of a test"
kind: worm
ratio: 20
starts: 2
wheel_teeth: 40
like: worm-50mm
lead_angle: {value: 9 deg, evidence: DOC, source: "sheet"}
efficiency: {value: 0.75, evidence: DOC, source: "sheet"}
nominal_torque: {value: 30 N*m, evidence: DOC, source: "sheet"}
"""
TEETH = "teeth: {one_of: [{pinion: 2, wheel: 40}], evidence: DOC, source: sheet}"
RIG = """
operating_point: {output_speed: 60 rpm}
measured: sensor
rig:
  motor: {kind: motor, catalog: HDS6A-0104A}
  gear: {kind: KIND, catalog: NAME}
  sensor: {kind: torque_sensor, catalog: reference-10nm}
  drum: {kind: body, inertia: 0.01 kg*m^2, viscous: 0.5 N*m*s/rad}
  load: {kind: particle_load, at: drum, mean_by_occupancy_percent: {0: 1 N*m, 10: 2 N*m}}
  controller: {kind: speed_controller, motor: motor, kp: 0.05 N*m*s/rad, ki: 0.2 N*m/rad}
"""
STUDY = """
study:
  present: {motor: HDS6A-0104A, gearbox: NAME, filter: none}
  motors: [HDS6A-0104A]
  gearboxes: [reference-5-1, W50-20]
  filters: {file: filters.yaml, names: [none]}
  speed_loop: {crossover: 20 Hz, integral_corner: 1 Hz}
  sensor_limit: 10 N*m
  requirements:
    reserve: {metric: torque_reserve, unit: "1", min: 1.0, purpose: torque}
  criteria:
    error: {metric: truth_error, unit: N*m, better: less, weight: 1.0, same_within: {relative: 0.1},
            points: {0.0: 5, 1.0: 1}, purpose: error}
"""


@pytest.fixture(scope="module")
def classes() -> dict[str, PartClass]:
    return read_classes(shipped_folder())


@pytest.fixture
def catalog(tmp_path: Path) -> Catalog:
    (tmp_path / "gearboxes").mkdir()
    (tmp_path / "gearboxes" / "W50-20.yaml").write_text(ENTRY)
    return load_catalog(shipped_folder(), tmp_path)


def entry(folder: Path, classes: dict[str, PartClass], text: str) -> Gearbox:
    (folder / "gearboxes").mkdir(exist_ok=True)
    (folder / "gearboxes" / "one.yaml").write_text(text)
    return read_entry(folder / "gearboxes" / "one.yaml", Gearbox, classes)


def test_a_class_fills_what_a_sheet_does_not_state(tmp_path: Path, classes: dict[str, PartClass]) -> None:
    made = entry(tmp_path, classes, ENTRY)
    assert made.stiffness.evidence == "CLASS"
    assert "worm-50mm" in made.stiffness.source
    assert made.lead_angle.value == pytest.approx(9 * pi / 180)
    worm = made.worm()
    assert worm is not None
    assert worm.ratio == 20


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        ("starts: 2\n", "", "a worm needs starts"),
        ("wheel_teeth: 40", "wheel_teeth: 50", "gives a ratio of 25, but ratio is 20"),
        ("wheel_teeth: 40", "wheel_teeth: 1", "does not exist"),
        ("kind: worm", "kind: spur", "is a class of gearboxes of kind worm"),
        (
            "starts: 2\n",
            f"starts: 2\n{TEETH}\n",
            "no teeth:",
        ),
    ],
)
def test_numbers_that_are_no_worm_are_refused(
    tmp_path: Path, classes: dict[str, PartClass], before: str, after: str, said: str
) -> None:
    with pytest.raises(InputError, match=said):
        entry(tmp_path, classes, ENTRY.replace(before, after))


def test_a_scenario_takes_a_worm_gear_from_the_catalog(catalog: Catalog) -> None:
    text = RIG.replace("KIND", "worm_gear").replace("NAME", "W50-20")
    made = read_scenario(parse_document(text, Path("rig.yaml")), catalog, seed=1)
    gear = made.rig.part("gear")
    assert isinstance(gear, WormGear)
    assert (gear.starts, gear.wheel_teeth) == (2, 40)
    assert gear.efficiency == pytest.approx(0.75)
    assert gear.lead == pytest.approx(9 * pi / 180)
    assert not gear.is_self_locking
    assert made.rig.run.gear_ratio == 20
    assert any("stiffness" in key for key in made.assumed)


@pytest.mark.parametrize(
    ("kind", "name", "said"),
    [("gear", "W50-20", "write kind: worm_gear"), ("worm_gear", "reference-5-1", "write kind: gear")],
)
def test_the_kind_of_part_must_be_that_of_the_entry(catalog: Catalog, kind: str, name: str, said: str) -> None:
    text = RIG.replace("KIND", kind).replace("NAME", name)
    with pytest.raises(InputError, match=said):
        read_scenario(parse_document(text, Path("rig.yaml")), catalog, seed=1)


def test_a_study_exchanges_a_gearbox_and_a_worm(catalog: Catalog) -> None:
    for kind, name in (("gear", "reference-5-1"), ("worm_gear", "W50-20")):
        text = (RIG + STUDY).replace("KIND", kind).replace("NAME", name)
        study = open_study(parse_document(text, shipped_scenarios() / "rig.yaml"), catalog)
        kinds = {
            box: document_of("HDS6A-0104A", box, study).data["rig"]["gear"]["kind"]
            for box in ("reference-5-1", "W50-20")
        }
        assert kinds == {"reference-5-1": "gear", "W50-20": "worm_gear"}


def test_a_sizing_knows_the_ratings_of_a_worm(catalog: Catalog) -> None:
    from torquerig.metrics.sizing.drive_sizing import sizing
    from torquerig.metrics.sizing.sized_drive import sized_drive

    text = RIG.replace("KIND", "worm_gear").replace("NAME", "W50-20")
    made = sizing(sized_drive(read_scenario(parse_document(text, Path("rig.yaml")), catalog, seed=1), catalog))
    use = made.figures["gearbox_life_use"]
    assert use.value is not None or (use.low is not None and use.high is not None)
