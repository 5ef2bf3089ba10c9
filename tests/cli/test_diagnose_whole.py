"""Whole diagnoses by the command: practice recordings of another program, and copies of rigs of bought parts.

A minute each, so only .ci/full runs them; ``python -m proof`` runs all practice cases.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.document import read_document
from torquerig.mechanisms import MainsInterference
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

pytestmark = pytest.mark.full

PRACTICE = Path(__file__).resolve().parents[2] / ".." / "shared" / "practice"
PARTS = (("bldc-12n14p, torque_limit: 2.0 N*m", "HDS6A-0104A"), ("reference-5-1", "NPS015-5"))
PLAN = ((1000.0, 5.0, "steady"), (600.0, 5.0, "steady"), (1000.0, 0.0, "steady"), (1400.0, 5.0, "ramp"))
ANSWERS: dict[str, tuple[str | None, dict[str, float]]] = {
    "practice1": ("gear_mesh", {"order_output": 72.0, "transmission_error_rad": 5.028e-5}),
    "practice7": ("blade_pass", {"order_output": 6.0, "amplitude_Nm": 0.498}),
    "practice8": (None, {}),
}


def said(folder: Path, runs: list[Path], scenario: Path) -> dict[str, Any]:
    out, page = folder / "out.json", folder / "out.html"
    main(("diagnose", *map(str, runs), "--scenario", str(scenario), "--json", str(out), "--report", str(page)))
    data: dict[str, Any] = json.loads(out.read_text(encoding="utf-8"))
    assert data["verdict"].replace("_", " ") in page.read_text(encoding="utf-8")
    if data["model"]:
        assert read_scenario(read_document(Path(data["model"])), load_catalog(shipped_folder()), seed=0).rig.parts
    return data


@pytest.mark.skipif(not PRACTICE.exists(), reason="shared/practice is not beside this checkout")
@pytest.mark.parametrize("case", ANSWERS)
def test_a_practice_case_is_named_as_its_answer_says(case: str, tmp_path: Path) -> None:
    name, parameters = ANSWERS[case]
    data = said(tmp_path, sorted((PRACTICE / case).glob("run?.parquet")), shipped_scenarios() / "wear_rig.yaml")
    assert [finding["mechanism"] for finding in data["findings"]] == ([] if name is None else [name])
    assert data["verdict"] == ("adequate" if name is None else "missing_physics")
    for parameter, value in parameters.items():
        # the answer's program and the simulator differ in integrator, contact and load
        assert data["findings"][0]["parameters"][parameter]["value"] == pytest.approx(value, rel=0.1)


@pytest.mark.parametrize("hum", [0.0, 0.15], ids=["nothing hidden", "a hum"])
def test_another_copy_of_the_same_parts(hum: float, record: Callable[..., Recording], tmp_path: Path) -> None:
    """What the catalog knows as an interval is no missing physics within it."""
    text = (shipped_scenarios() / "wear_rig.yaml").read_text(encoding="utf-8").split("study:")[0]
    for old, new in PARTS:
        assert old in text
        text = text.replace(old, new)
    path = tmp_path / "rig.yaml"
    path.write_text(text, encoding="utf-8")
    real = _drawn(path, seed=7)
    rig = real.rig + MainsInterference(name="hum", frequency=50.02, amplitudes=(hum,)) if hum else real.rig
    runs = []
    for place, (rpm, load, profile) in enumerate(PLAN):
        runs.append(tmp_path / f"run{place}.parquet")
        made = record(rig, 10 + place, rpm=rpm, occupancy=load, profile=profile, duration=12.0, rate=10_000.0)
        write_recording(made, runs[-1])
    data = said(tmp_path, runs, path)
    assert [each["mechanism"] for each in data["findings"]] == (["mains_interference"] if hum else [])
    assert data["verdict"] == ("missing_physics" if hum else "adequate")


def _drawn(path: Path, *, seed: int) -> Scenario:
    return read_scenario(read_document(path), load_catalog(shipped_folder()), seed=seed)
