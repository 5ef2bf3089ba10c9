"""A rig of bought parts, of which catalogs know intervals alone: what lies within them is no missing physics."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.diagnosis.engine import diagnose
from torquerig.document import read_document
from torquerig.mechanisms import MainsInterference
from torquerig.recordings.recording import Recording
from torquerig.scenario.catalog_values.readings import other_readings
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

pytestmark = pytest.mark.full

PARTS = (("bldc-12n14p, torque_limit: 2.0 N*m", "HDS6A-0104A"), ("reference-5-1", "NPS015-5"))


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int], Scenario]:
    """The wear rig with the reference report's servo motor and a gearbox with a gap; a seed draws a copy of them."""
    text = (shipped_scenarios() / "wear_rig.yaml").read_text(encoding="utf-8").split("study:")[0]
    for old, new in PARTS:
        assert old in text
        text = text.replace(old, new)
    path: Path = tmp_path_factory.mktemp("rig") / "rig.yaml"
    path.write_text(text, encoding="utf-8")
    return lambda seed: read_scenario(read_document(path), load_catalog(shipped_folder()), seed=seed)


@pytest.mark.parametrize("hum", [0.0, 0.15], ids=["nothing hidden", "a hum"])
def test_another_copy_of_the_same_parts(
    hum: float, drawn: Callable[[int], Scenario], record: Callable[..., Recording]
) -> None:
    nominal, real = drawn(0), drawn(7)
    assert [part.name for part in nominal.rig.parts] == [part.name for part in real.rig.parts]  # the same winding
    rig = real.rig + MainsInterference(name="hum", frequency=50.02, amplitudes=(hum,)) if hum else real.rig
    plan = [(1000.0, 5.0, "steady"), (600.0, 5.0, "steady"), (1000.0, 0.0, "steady"), (1400.0, 5.0, "ramp")]
    runs = [
        record(rig, 10 + place, rpm=rpm, occupancy=load, profile=profile, duration=12.0, rate=10_000.0)
        for place, (rpm, load, profile) in enumerate(plan)
    ]
    said = diagnose(nominal, runs).diagnosis
    assert [each.mechanism for each in said.findings] == (["mains_interference"] if hum else [])
    assert said.verdict == ("missing_physics" if hum else "adequate")
    assert any("The stated backlash of" in remark for remark in said.remarks)


def test_a_motor_with_another_number_of_poles_than_was_drawn(tmp_path: Path, record: Callable[..., Recording]) -> None:
    """The catalog knows 4 or 5 pole pairs; lines at the other's orders are no missing physics."""
    text = (shipped_scenarios() / "wear_rig.yaml").read_text(encoding="utf-8").split("study:")[0]
    path = tmp_path / "rig.yaml"
    path.write_text(text.replace(PARTS[0][0], "ESM06X-401-302").replace("reference-5-1", "GB060-5"), encoding="utf-8")
    document, catalog = read_document(path), load_catalog(shipped_folder())
    drawn, real = (read_scenario(document, catalog, seed=seed) for seed in (0, 7))
    assert (drawn.choices()["motor.pole_pairs"], real.choices()["motor.pole_pairs"]) == (5, 4)
    plan = [(1000.0, 5.0, "steady"), (600.0, 5.0, "steady"), (1000.0, 0.0, "steady"), (1400.0, 5.0, "ramp")]
    runs = [
        record(real.rig, 10 + place, rpm=rpm, occupancy=load, profile=profile, duration=12.0, rate=10_000.0)
        for place, (rpm, load, profile) in enumerate(plan)
    ]
    said = diagnose(drawn, runs, others=other_readings(document, catalog, seed=0)).diagnosis
    assert said.verdict == "adequate"
    assert any("motor.pole_pairs = 4 (drawn: 5" in remark for remark in said.remarks)
