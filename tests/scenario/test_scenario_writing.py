"""A rig written as a scenario file reads back as the same rig: every shipped scenario, every mechanism."""

from __future__ import annotations

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest
import yaml

from torquerig import mechanisms
from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.mechanisms import (
    BearingDefect,
    Cogging,
    GearMesh,
    MainsInterference,
    SensorDrift,
    StribeckFriction,
    TorqueRipple,
)
from torquerig.parameter import Estimate
from torquerig.rig.assembly import Part, Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.scenario.writing import scenario_text, write_scenario, written_part

RIGS = [
    path.name
    for path in sorted(shipped_scenarios().glob("*.yaml"))
    if "rig" in (yaml.safe_load(path.read_text(encoding="utf-8")) or {})
]


def read(path: Path) -> Scenario:
    return read_scenario(read_document(path), load_catalog(shipped_folder()), seed=1)


def back(rig: Rig, folder: Path, *, operating_point: object, **more: object) -> Scenario:
    path = folder / "written.yaml"
    text = scenario_text(rig, title="written", operating_point=operating_point, **more)  # type: ignore[arg-type]
    write_scenario(path, text, overwrite=True)
    return read(path)


def test_there_are_shipped_rigs() -> None:
    assert "wear_rig.yaml" in RIGS


@pytest.mark.long
@pytest.mark.parametrize("name", RIGS)
def test_every_shipped_rig_reads_back_as_itself(name: str, tmp_path: Path) -> None:
    made = read(shipped_scenarios() / name)
    again = back(made.rig, tmp_path, operating_point=made.document.data["operating_point"])
    assert again.rig.parts == made.rig.parts
    assert again.rig.measured == made.rig.measured
    assert again.rig.run.speed == pytest.approx(made.rig.run.speed)


def laws() -> ModuleType:
    """The mechanisms' own table: one effect of each, and a rig that has all that any of them needs."""
    path = Path(__file__).resolve().parents[1] / "mechanisms" / "test_every_mechanism_obeys_its_laws.py"
    spec = spec_from_file_location("laws_of_every_mechanism", path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


LAWS = laws()
EXAMPLES: list[Part] = [row.effect for row in LAWS.ROWS]


def test_the_examples_are_all_mechanisms() -> None:
    assert {type(part).__name__ for part in EXAMPLES} == set(mechanisms.__all__)


FILLED: tuple[Part, ...] = (
    GearMesh(name="part", order_output=84.0, transmission_error=(1e-5, 2e-6), phases=(0.3, 1.0), planet_modulation=0.1),
    Cogging(name="part", slots=12, pole_pairs=7, native=0.01, further={36: 0.002}, phases={84: 0.5}),
    MainsInterference(name="part", frequency=60.02, amplitudes=(0.01, 0.0, 0.003)),
    SensorDrift(name="part", span=-0.2, time_constant=None),
    StribeckFriction(name="part", coulomb=0.3, static=0.7, stribeck_speed=1.1, coulomb_backward=0.2),
    BearingDefect(name="part", order_output=3.58, ring_frequency=812.5, amplitude=0.02),
    TorqueRipple(name="part", at="wear_part", group="mechanical", amplitudes={1.5: 0.1, 2.0: 0.2}),
)


@pytest.mark.parametrize("part", [*EXAMPLES, *FILLED], ids=lambda part: part.kind)
def test_every_mechanism_reads_back_as_itself(part: Part, tmp_path: Path) -> None:
    rig = LAWS.rig(part, speed_rpm=1000.0)
    made = back(rig, tmp_path, operating_point={"motor_speed": "1000 rpm", "load": {"occupancy": "0 %"}})
    assert made.rig.parts == rig.parts


def test_numbers_stand_with_their_units_and_defaults_are_left_out() -> None:
    written = written_part(SensorDrift(name="part", span=-0.2, time_constant=3.0))
    assert written == {"kind": "sensor_drift", "span": "-0.2 V", "time_constant": "3.0 s"}
    assert written_part(SensorDrift(name="part", span=-0.2)) == {"kind": "sensor_drift", "span": "-0.2 V"}


IN_A_LINE = """
operating_point: {}
measured: motion
rig:
  table: {kind: slide, mass: 3 kg}
  contact: {kind: stribeck_friction, at: block, coulomb: 37 N, static: 47 N, stribeck_speed: 12 mm/s, smoothing: 1 mm/s}
  rod: {kind: link, after: table, stiffness: 1.0e6 N/m, damping: 500 N*s/m}
  play: {kind: backlash, gear: rod, gap: 0.2 mm}
  block: {kind: slide, after: rod, mass: 4 kg}
  air: {kind: quadratic_drag, at: block, coefficient: 3 N*s^2/m^2}
  arm: {kind: torsional_mode, after: block, frequency: 30 Hz, inertia: 0.2 kg, damping_ratio: 0.02}
  motion: {kind: imposed_motion, at: table, channel: position}
"""


def test_effects_of_what_moves_in_a_line_are_in_kg_n_and_m(tmp_path: Path) -> None:
    made = read_scenario(parse_document(IN_A_LINE, tmp_path / "line.yaml"), Catalog(), seed=0)
    assert made.rig.part("contact") == StribeckFriction(
        name="contact", at="block", coulomb=37.0, static=47.0, stribeck_speed=0.012, smoothing=1e-3
    )
    written = yaml.safe_load(scenario_text(made.rig, title="line", operating_point={}))["rig"]
    assert written["contact"] == {
        "kind": "stribeck_friction", "at": "block", "coulomb": "37.0 N", "static": "47.0 N",
        "stribeck_speed": "0.012 m/s", "smoothing": "0.001 m/s",
    }  # fmt: skip
    assert written["play"]["gap"] == "0.0002 m"
    assert written["air"]["coefficient"] == "3.0 N*s^2/m^2"
    assert written["arm"]["inertia"] == "0.2 kg"
    assert back(made.rig, tmp_path, operating_point={}).rig.parts == made.rig.parts


@pytest.mark.parametrize(
    ("stated", "wrong", "told"),
    [
        (
            "37 N",
            "37 N*m",
            r"line\.yaml:6: rig\.contact\.coulomb: '37 N\*m' is a torque; a force is wanted, write '37 N'",
        ),
        ("0.2 mm", "3 arcmin", r"rig\.play\.gap: '3 arcmin' is an angle; a length is wanted, write '3 m'"),
        ("0.2 kg", "0.2 kg*m^2", r"rig\.arm\.inertia: .* a mass is wanted"),
    ],
)
def test_a_shafts_unit_in_a_line_is_refused(tmp_path: Path, stated: str, wrong: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        read_scenario(parse_document(IN_A_LINE.replace(stated, wrong, 1), tmp_path / "line.yaml"), Catalog(), seed=0)


def test_spreads_come_back_as_uncertainties(tmp_path: Path) -> None:
    made = read(shipped_scenarios() / "wear_rig.yaml")
    again = back(
        made.rig, tmp_path, operating_point=made.document.data["operating_point"],
        known={"motor.inertia": Estimate(rel_sd=0.021)}, head="first line\nsecond line",
    )  # fmt: skip
    assert again.uncertainties["motor.inertia"].rel_sd == pytest.approx(0.021)
    assert (tmp_path / "written.yaml").read_text(encoding="utf-8").startswith("# first line\n# second line\n")


def test_nothing_is_overwritten_unasked(tmp_path: Path) -> None:
    path = tmp_path / "there.yaml"
    path.write_text("kept", encoding="utf-8")
    with pytest.raises(InputError, match="exists already; choose another name"):
        write_scenario(path, "new", overwrite=False)
    assert path.read_text(encoding="utf-8") == "kept"
    write_scenario(path, "new", overwrite=True)
    assert path.read_text(encoding="utf-8") == "new"
    assert [each.name for each in tmp_path.iterdir()] == ["there.yaml"]
