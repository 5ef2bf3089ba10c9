"""Reading a scenario: each fault is one sentence with file, line, key and remedy."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError, TorquerigError
from torquerig.rig.parts import Gear
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

TEXT = """\
scenario: bench
operating_point:
  output_speed: 60 rpm
  load: {occupancy: 5 %}
measured: sensor
rig:
  motor: {kind: motor, inertia: 1.5e-4 kg*m^2, torque_limit: 2 N*m}
  gearbox:
    kind: gear
    ratio: 5
    stiffness: 11300 N*m/rad
    damping: 2.0 N*m*s/rad
    output_inertia: 7.0 kg*cm^2
  sensor: {kind: torque_sensor, catalog: reference-10nm}
  wear_part: {kind: body, inertia: {value: 20 kg*cm^2, rel_sd: 0.1}}
  loop: {kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}
  load: {kind: particle_load, mean_by_occupancy_percent: {0: 0.1 N*m, 20: 4 N*m}}
"""


@pytest.fixture(scope="module")
def catalog() -> Catalog:
    return load_catalog(shipped_folder())


def read(text: str, catalog: Catalog) -> Scenario:
    return read_scenario(parse_document(text, Path("bench.yaml")), catalog, seed=1)


def test_a_scenario_becomes_a_rig_at_its_operating_point(catalog: Catalog) -> None:
    made = read(TEXT, catalog)
    assert made.title == "bench"
    assert [part.name for part in made.rig.parts][:4] == ["motor", "gearbox", "sensor", "wear_part"]
    assert [part.after for part in made.rig.parts][:4] == [None, "motor", "gearbox", "sensor"]
    assert made.rig.part("gearbox").output_inertia == pytest.approx(7e-4)  # type: ignore[attr-defined]
    assert made.rig.run.speed_rpm == pytest.approx(300)  # 60 rpm at the output, 5:1
    assert made.rig.run.gear_ratio == 5.0
    assert made.rig.run.occupancy_percent == 5.0
    assert made.uncertainties["wear_part.inertia"].rel_sd == 0.1
    assert made.uncertainties["sensor.stiffness"].rel_sd == 0.03


def test_what_stands_beside_catalog_goes_before_it(catalog: Catalog) -> None:
    made = read(TEXT.replace("reference-10nm}", "reference-10nm, stiffness: 900 N*m/rad}"), catalog)
    assert made.rig.part("sensor").stiffness == 900.0  # type: ignore[attr-defined]
    assert "sensor.stiffness" not in made.uncertainties


# ruff: noqa: E501 (a table: one fault in a row reads better than in four)
FAULTS: dict[str, tuple[str, str, str]] = {
    # name: (what stands there, what is written instead, what is said)
    "misspelt part key": (
        "stiffness: 11300", "stifness: 11300", r"bench\.yaml:11: rig\.gearbox\.stifness: unknown key; did you mean 'stiffness'\?",
    ),
    "misspelt section": (
        "operating_point:", "operating_pont:", r"bench\.yaml:2: operating_pont: unknown key; did you mean 'operating_point'\?",
    ),
    "unknown kind": (
        "kind: gear\n", "kind: geer\n", r"bench\.yaml:9: rig\.gearbox\.kind: 'geer' is no kind of part; did you mean 'gear'\?",
    ),
    "kind is a list": ("kind: gear\n", "kind: [gear]\n", r"bench\.yaml:9: rig\.gearbox\.kind: \['gear'\] is no kind of part"),
    "no kind": ("    kind: gear\n", "", r"bench\.yaml:8: rig\.gearbox: a part needs its kind; add kind: with one of"),
    "unknown catalog name": (
        "reference-10nm", "reference-10mn",
        r"bench\.yaml:14: rig\.sensor\.catalog: .*'reference-10mn'.*did you mean 'reference-10nm'",
    ),
    "a kind without catalog": (
        "{kind: body,", "{kind: body, catalog: x,", r"bench\.yaml:15: rig\.wear_part\.catalog: a body has no catalog; state its values",
    ),
    "bare number": (
        "11300 N*m/rad", "11300", r"bench\.yaml:11: rig\.gearbox\.stiffness: 11300 has no unit; write '11300 N\*m/rad'",
    ),
    "wrong unit": (
        "11300 N*m/rad", "11300 N*m", r"bench\.yaml:11: rig\.gearbox\.stiffness: '11300 N\*m' is a torque; .*write '11300 N\*m/rad'",
    ),
    "unknown unit": ("11300 N*m/rad", "11300 N*m/rd", r"bench\.yaml:11: .* has an unknown unit; did you mean 'N\*m/rad'"),
    "decimal comma": ("11300 N*m/rad", "1,3 N*m/rad", r"bench\.yaml:11: .* has a decimal comma; write '1\.3 N\*m/rad'"),
    "negative inertia": (
        "value: 20 kg", "value: -20 kg", r"bench\.yaml:15: rig\.wear_part\.inertia: -0\.002 kg\*m\^2 is out of range: inertia must be more than 0",
    ),
    "missing key": ("    damping: 2.0 N*m*s/rad\n", "", r"bench\.yaml:8: rig\.gearbox: the key 'damping' is missing; add it"),
    "ratio 0": ("ratio: 5", "ratio: 0", r"bench\.yaml:8: rig\.gearbox: a gear of ratio 0 transmits nothing; write"),
    "two speeds": (
        "output_speed: 60 rpm", "output_speed: 60 rpm\n  motor_speed: 300 rpm",
        r"bench\.yaml:2: operating_point: both motor_speed and output_speed are stated; keep one",
    ),
    "occupancy without unit": ("5 %", "'5'", r"bench\.yaml:4: operating_point\.load\.occupancy: '5' has no unit; write '5 %'"),
    "occupancy beyond 100": ("5 %", "105 %", r"bench\.yaml:4: operating_point\.load\.occupancy: 105 % is no occupancy"),
    "occupancy beyond the load's table": (
        "5 %", "21 %", r"bench\.yaml:17: rig\.load: occupancy 21 % is outside 0\.\.20 %, .*add a mean torque for it",
    ),
    "unknown after": (
        "kind: gear\n", "kind: gear\n    after: moter\n",
        r"bench\.yaml:8: rig\.gearbox: after: 'moter' is no part before it; did you mean 'motor'\?",
    ),
    "unknown at": (
        "{kind: particle_load,", "{kind: particle_load, at: wear_prt,",
        r"bench\.yaml:17: rig\.load: the rig has no part 'wear_prt'; did you mean 'wear_part'\?",
    ),
    "key twice": (
        "    ratio: 5\n", "    ratio: 5\n    ratio: 6\n", r"bench\.yaml:11: the key 'ratio' is already in line 10; keep one of them",
    ),
    "measured part without spring": (
        "measured: sensor", "measured: wear_part", r"bench\.yaml:5: measured: 'wear_part' has no spring whose torque could be read",
    ),
    "measured part unknown": (
        "measured: sensor", "measured: senser", r"bench\.yaml:5: measured: the rig has no part 'senser'; did you mean 'sensor'\?",
    ),
    "spring without inertia": (
        "    output_inertia: 7.0 kg*cm^2\n", "", r"bench\.yaml:6: rig: gearbox: the spring of 'gearbox' ends on a shaft without inertia; give",
    ),
    "spring that nothing drives": (
        "  motor: {kind: motor, inertia: 1.5e-4 kg*m^2, torque_limit: 2 N*m}\n", "",
        r"bench\.yaml:7: rig\.gearbox: nothing drives it; name the part before it with after:|no part 'motor'",
    ),
    "controller of no motor": (
        "{kind: speed_controller,", "{kind: speed_controller, motor: gearbox,",
        r"bench\.yaml:16: rig\.loop: motor: 'gearbox' is no motor; name one",
    ),
    "spread that is none": (
        "rel_sd: 0.1", "rel_sd: much", r"bench\.yaml:15: rig\.wear_part\.inertia\.rel_sd: 'much' is no standard deviation; write",
    ),
    "misspelt spread": (
        "rel_sd: 0.1", "rel_ds: 0.1", r"bench\.yaml:15: rig\.wear_part\.inertia.*: unknown key; did you mean 'rel_sd'\?",
    ),
    "no YAML": ("measured: sensor", "measured: [sensor", r"bench\.yaml:\d+: not YAML: .*check the indentation"),
    "no rig": (TEXT[TEXT.index("rig:") :], "", r"bench\.yaml: a scenario needs a mapping named rig:"),
    "rig is a list": (TEXT[TEXT.index("rig:") :], "rig: [motor]", r"bench\.yaml:6: rig: a scenario needs a mapping named rig:"),
    "empty file": (TEXT, "", r"bench\.yaml: the file is empty; copy a shipped one and change it"),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_each_fault_is_told_with_its_place_and_a_remedy(fault: str, catalog: Catalog) -> None:
    right, wrong, said = FAULTS[fault]
    assert TEXT.count(right) == 1, "the fault must be put in at one place"
    with pytest.raises(TorquerigError, match=said) as told:
        read(TEXT.replace(right, wrong), catalog)
    assert "\n" not in str(told.value)


def test_a_missing_file_is_told_with_the_near_ones(tmp_path: Path) -> None:
    (tmp_path / "bench.yaml").write_text(TEXT)
    with pytest.raises(InputError, match=r"bnch\.yaml: there is no such file; did you mean 'bench\.yaml'\?"):
        read_document(tmp_path / "bnch.yaml")


def test_two_stages_and_a_branch_read_as_they_are_written(catalog: Catalog) -> None:
    text = TEXT.replace(
        "  sensor:",
        "  belt: {kind: gear, ratio: 2.5, stiffness: 900 N*m/rad, damping: 1 N*m*s/rad, output_inertia: 3 kg*cm^2}\n  sensor:",
    )
    text += "  fan: {kind: gear, after: motor, ratio: 0.7, stiffness: 90 N*m/rad, damping: 1 N*m*s/rad, output_inertia: 1 g*cm^2}\n"
    rig = read(text, catalog).rig
    assert isinstance(rig.part("fan"), Gear)
    assert rig.run.speed_rpm == pytest.approx(60 * 12.5)
    assert rig.run.gear_ratio == 12.5
    assert rig.speed_ratios("motor")["fan"] == pytest.approx(1 / 0.7)


RIGS = [path for path in sorted(shipped_scenarios().glob("*.yaml")) if "rig" in read_document(path).data]


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.name)
def test_every_shipped_scenario_of_a_rig_reads(path: Path, catalog: Catalog) -> None:
    assert read_scenario(read_document(path), catalog, seed=1).rig.terms()
