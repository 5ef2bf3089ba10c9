"""--set path=value: what it finds, what it refuses, and that its faults name the --set."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import Document, read_document
from torquerig.errors import InputError, TorquerigError
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario

# ruff: noqa: E501 (tables: one setting in a row)
WEAR_RIG = shipped_scenarios() / "wear_rig.yaml"


@pytest.fixture(scope="module")
def catalog() -> Catalog:
    return load_catalog(shipped_folder())


@pytest.fixture
def document() -> Document:
    return read_document(WEAR_RIG)


def test_the_end_of_a_path_is_enough_where_it_is_unique(document: Document) -> None:
    edited = overridden(document, ["load.occupancy=21", "wear_part.inertia.value=3.0e-3 kg*m^2"])
    assert edited.data["operating_point"]["load"]["occupancy"] == 21
    assert edited.data["rig"]["wear_part"]["inertia"] == {"value": "3.0e-3 kg*m^2", "rel_sd": 0.1}
    assert document.data["operating_point"]["load"]["occupancy"] == "5 %", "the document itself stays as it was"


def test_a_key_that_is_not_stated_yet_is_set_where_its_mapping_stands(document: Document) -> None:
    edited = overridden(document, ["gearbox.ratio=10", "rig.gap={kind: backlash, gap: 4 arcmin}"])
    assert edited.data["rig"]["gearbox"]["ratio"] == 10
    assert edited.data["rig"]["gap"] == {"kind": "backlash", "gap": "4 arcmin"}


def test_of_two_settings_of_one_path_the_last_counts(document: Document, catalog: Catalog) -> None:
    edited = overridden(document, ["gearbox.ratio=abc", "gearbox.ratio=10"])
    assert read_scenario(edited, catalog, seed=1).rig.run.gear_ratio == 10.0


def test_no_setting_leaves_the_document(document: Document) -> None:
    assert overridden(document, []) is document


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("foo", r"^--set foo: not of the form path=value; write for example --set gearbox\.ratio=10$"),
        ("=5", r"^--set =5: not of the form path=value"),
        ("gearbox.ratio=", r"^--set gearbox\.ratio=: not of the form path=value"),
        ("gearbox.ratio=[1", r"^--set gearbox\.ratio=\[1: '\[1' is no YAML value; close every bracket"),
        ("particle_size=1 mm", r"^--set particle_size=1 mm: this could be operating_point\.load\.particle_size and study\.all_points\.particle_size; write more"),
        ("measured.first=1", r"the scenario has no such path"),
        ("wear_prt.inertia=1", r"^--set wear_prt\.inertia=1: the scenario has no such path; did you mean 'wear_part\.inertia'"),
        ("occupanzy=5", r"no such path; did you mean .*occupancy'"),
    ],
)  # fmt: skip
def test_a_setting_that_means_nothing_is_refused(setting: str, said: str, document: Document) -> None:
    with pytest.raises(InputError, match=said):
        overridden(document, [setting])
    with pytest.raises(InputError, match=said.replace("--set", "sweep")):
        overridden(document, [setting], option="sweep")


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("wear_part.inertia=3 N", r"^--set wear_part\.inertia=3 N: rig\.wear_part\.inertia: '3 N' is a force; .*write '3 kg\*m\^2'"),
        ("wear_part.inertia.value=-1 kg*m^2", r"^--set wear_part\.inertia\.value=-1 kg\*m\^2: rig\.wear_part\.inertia: .* more than 0"),
        ("wear_part.inertia=3", r"^--set wear_part\.inertia=3: rig\.wear_part\.inertia: 3 has no unit"),
        ("load.occupancy=abc", r"^--set load\.occupancy=abc: operating_point\.load\.occupancy: 'abc'"),
        ("load.occupancy=30", r"rig\.load: occupancy 30 % is outside 0\.\.21 %.*read with --set 'load\.occupancy=30'"),
        ("gearbox.ratio=0", r"rig\.gearbox: a gear of ratio 0 .*read with --set 'gearbox\.ratio=0'"),
        ("measured=wear_part", r"^--set measured=wear_part: measured: 'wear_part' has no spring"),
        ("motor.catalog=HDS6A-0104B", r"no motor 'HDS6A-0104B'.*did you mean"),
        ("rig.gap={kind: backlash, gap: 4}", r"^--set rig\.gap=.*: rig\.gap\.gap: 4 has no unit; write '4 deg' or '4 rad'"),
        ("rig.gap={kind: backlash}", r"^--set rig\.gap=\{kind: backlash\}: rig\.gap.*: the key 'gap' is missing; add it"),
        ("rig.gap={kind: backlash, gear: x, gap: 4 arcmin}", r"^--set rig\.gap=.*: rig\.gap: the rig has no part 'x'"),
        ("rig={}", r"^--set rig=\{\}: rig: a scenario needs a mapping named rig"),
        ("gearbox.stifness=1 N*m/rad", r"^--set gearbox\.stifness=1 N\*m/rad: rig\.gearbox\.stifness: unknown key; did you mean 'stiffness'"),
    ],
)  # fmt: skip
def test_a_fault_of_a_setting_names_the_setting(setting: str, said: str, document: Document, catalog: Catalog) -> None:
    with pytest.raises(TorquerigError, match=said) as told:
        read_scenario(overridden(document, [setting]), catalog, seed=1)
    assert "--set" in str(told.value)


def test_a_fault_of_the_file_still_names_its_line(tmp_path: Path, catalog: Catalog) -> None:
    path = tmp_path / "rig.yaml"
    path.write_text(WEAR_RIG.read_text().replace("viscous: {value: 0.010 N*m*s/rad", "viscous: {value: 0.010 N*m"))
    with pytest.raises(InputError, match=r"^.*rig\.yaml:\d+: rig\.wear_part\.viscous: '0\.010 N\*m' is a torque"):
        read_scenario(overridden(read_document(path), ["load.occupancy=11"]), catalog, seed=1)


def test_a_setting_of_a_section_that_is_not_there_names_the_section() -> None:
    shaft_line = read_document(shipped_scenarios() / "shaft_line.yaml")
    with pytest.raises(InputError, match=r"^--set study\.duration=0\.3s: the scenario has no section study:"):
        overridden(shaft_line, ["study.duration=0.3s"])


def test_a_misspelled_key_that_fits_two_places_gets_the_close_match(document: Document) -> None:
    with pytest.raises(InputError, match="did you mean 'occupancy'"):
        overridden(document, ["load.ocupancy=5 %"])
    with pytest.raises(InputError, match="write more of the path"):
        overridden(document, ["load.nonsense=5"])
