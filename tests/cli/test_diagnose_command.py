"""``torquerig diagnose``: files in, one JSON out; bad input in one sentence with exit code 2, and nothing written."""

from __future__ import annotations

import json
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

from tests.moved_rigs import CARRIAGE
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.document import read_document
from torquerig.mechanisms import Quantization
from torquerig.recordings.files import write_recording
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")
STEP = 0.0231  # [V]


def read(path: Path) -> Scenario:
    return read_scenario(read_document(path), load_catalog(shipped_folder()), seed=1)


def write(name: str, rig: Rig, *, duration: float = 2.5, encoder: bool = True, **sheet: object) -> None:
    speed = 1000 * pi / 30
    made = simulate(rig.at(replace(rig.run, speed=speed)), duration=duration, seed=3, sample_rate=5000.0, settling=0.5)
    made = made.without_truth()
    channels = {key: one for key, one in made.channels.items() if encoder or one.quantity == "torque"}
    write_recording(replace(made, channels=channels, run=replace(made.run, **sheet)), Path(name))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made, rig = tmp_path_factory.mktemp("runs"), read(Path(WEAR_RIG)).rig
    write(str(made / "good.parquet"), rig)
    write(str(made / "codes.parquet"), rig + Quantization(name="coarse", step=STEP), duration=4.0)
    write(str(made / "ratio.parquet"), rig, gear_ratio=20.0)
    write(str(made / "long.parquet"), rig, duration=12.0)
    write(str(made / "motor.parquet"), rig, motor="HDS6A-0104A")
    write(str(made / "short.parquet"), rig, duration=0.4)
    write(str(made / "no_speed.parquet"), rig, encoder=False, speed=None)
    rows = "\n".join(f"{index / 1000},0" for index in range(3000))
    (made / "theirs.pdf").write_text("%PDF-1.7 of another program")
    (made / "pressure.csv").write_text(f"time_s,pressure_Pa\n{rows}\n")
    return made


@pytest.fixture(autouse=True)
def _there(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)


BAD: dict[str, tuple[tuple[str, ...], str]] = {
    "no recording": ((), "missing argument 'RECORDINGS...'"),
    "missing file": (("nope.parquet",), "nope.parquet: there is no such file"),
    "two ratios": (("good.parquet", "ratio.parquet"), "of different rigs: their sidecars state the gear ratio"),
    "two motors": (("good.parquet", "motor.parquet"), "of different rigs: their sidecars state the motor"),
    "wrong ratio": (
        ("ratio.parquet",),
        "ratio.parquet: its sidecar states a gear ratio of 20, but the scenario's rig has 5; correct the sidecar",
    ),
    "too short": (("short.parquet",), "short.parquet: 0.40 s are too short for a diagnosis; record at least 2 s"),
    "no speed": (("no_speed.parquet",), "no_speed.parquet: the run states no motor speed"),
    "unknown channel": (("pressure.csv",), "pressure.csv"),
    "the same twice": (("good.parquet", "good.parquet"), "two recordings have the same file name"),
    "over an input": (
        ("good.parquet", "--model", "good.parquet"),
        "good.parquet: is one of the inputs; choose another",
    ),
    "over a sidecar": (
        ("good.parquet", "--model", "good.yaml"),
        "good.yaml: is one of the inputs; choose another name",
    ),
    "over a stranger": (("good.parquet", "--model", "pressure.csv"), "pressure.csv: is there already and no diagnosis"),
    "twice the same": (("good.parquet", "--report", "out.json"), "out.json: two outputs have this path"),
    "pdf of no page": (("good.parquet", "--pdf"), "--pdf prints the page of --report; name one"),
    "pdf of a stranger": (("good.parquet", "--report", "theirs.html", "--pdf"), "theirs.pdf: is there already"),
    "no such folder": (("good.parquet", "--model", "no/model.yaml"), "there is no folder no; make it first"),
}


@pytest.mark.long
@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_one_sentence(case: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments, sentence = BAD[case]
    before = sorted(path.name for path in folder.iterdir())
    with pytest.raises(SystemExit) as left:
        main(("diagnose", *arguments, "--scenario", WEAR_RIG, "--json", "out.json"))
    told = capsys.readouterr()
    assert left.value.code == 2
    assert sentence in told.err
    assert told.err.strip().count("\n") == 0
    assert told.out == ""
    assert sorted(path.name for path in folder.iterdir()) == before


def test_a_missing_scenario_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(("diagnose", "good.parquet", "--scenario", "nope.yaml", "--json", "-"))
    assert left.value.code == 2
    assert "nope.yaml: there is no such file" in capsys.readouterr().err


@pytest.mark.long
def test_a_fault_of_the_samples_is_named_and_its_model_written(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    main(("diagnose", "codes.parquet", "--scenario", WEAR_RIG, "--json", "codes.json"))
    told = capsys.readouterr().out.splitlines()
    assert told[0].startswith("The model lacks quantization (0.00")
    assert "N m rms). With what was found, the mean squared standardised residual on held-out" in told[0]
    assert told[-2:] == ["wrote codes.json", "wrote codes.model.yaml"]
    assert any(line.startswith("Rms residual on held-out data: ") and "N m" in line for line in told)
    assert any(line.startswith("- quantization, ") and " % sure: step_V 0.0231" in line for line in told)
    assert any(line.startswith("Next: ") for line in told)
    assert len(told) <= 17
    data = json.loads((folder / "codes.json").read_text(encoding="utf-8"))
    assert [finding["mechanism"] for finding in data["findings"]] == ["quantization"]
    assert data["findings"][0]["parameters"]["step_V"]["value"] == pytest.approx(STEP, rel=1e-3)
    assert data["model"] == "codes.model.yaml"
    main(("diagnose", "codes.parquet", "--scenario", WEAR_RIG, "--json", "codes.json"))  # its own results it replaces
    assert json.loads((folder / "codes.json").read_text(encoding="utf-8")) == data
    written = read(folder / data["model"]).rig
    assert written.part("quantization").step == pytest.approx(STEP, rel=1e-3)  # type: ignore[attr-defined]
    again = simulate(written, duration=0.5, seed=1, settling=0.2)
    volts = again.channels["torque_V"].values / STEP
    assert abs(volts - volts.round()).max() < 0.1


def test_to_standard_output_goes_the_json_alone_and_the_number_of_workers_changes_nothing(
    capsys: pytest.CaptureFixture[str],
) -> None:
    told = []
    for workers in ("1", "2"):
        main(("diagnose", "good.parquet", "--scenario", WEAR_RIG, "--json", "-", "--workers", workers))
        told.append(capsys.readouterr().out)
    assert told[0] == told[1]
    data = json.loads(told[0])
    assert data["schema"] == "torquerig.diagnosis/1"
    assert data["verdict"] == "adequate"
    assert data["model"] is None


def test_check_says_what_would_be_compared_and_writes_nothing(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = sorted(path.name for path in folder.iterdir())
    main(("diagnose", "good.parquet", "long.parquet", "--scenario", WEAR_RIG, "--check"))
    out = capsys.readouterr().out
    assert "good.parquet" in out
    assert "steady, 1000 rpm, 5 % occupancy, encoder_count" in out
    assert "motor.inertia" in out
    assert out.rstrip().endswith("no diagnosis was made")
    with pytest.raises(SystemExit) as stopped:
        main(("diagnose", "pressure.csv", "--scenario", WEAR_RIG, "--check"))
    assert stopped.value.code == 2
    assert "there is no torque channel among pressure_Pa" in capsys.readouterr().err
    assert sorted(path.name for path in folder.iterdir()) == before


def test_check_of_a_measured_motion_tells_effort_and_stroke_in_si(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    time = np.arange(2000) / 500
    rows = np.column_stack([time, 0.2 * np.sin(4 * time), np.round(0.1 * np.sin(4 * time) / 1e-6)])
    np.savetxt(tmp_path / "run.csv", rows, delimiter=",", header="time_s,force_V,scale_count", comments="", fmt="%.8g")
    (tmp_path / "run.yaml").write_text(
        "channels:\n  force_V: {quantity: force, unit: V, N_per_V: 50}\n"
        "  scale_count: {quantity: position, unit: count, m_per_count: 1.0e-6}\n"
    )
    (tmp_path / "table.yaml").write_text(CARRIAGE)
    main(("diagnose", str(tmp_path / "run.csv"), "--scenario", str(tmp_path / "table.yaml"), "--check"))
    out = capsys.readouterr().out
    assert "force_V, below 50 Hz" in out
    assert "7.0" in out  # N rms: 50 N/V times 0.2 V over sqrt(2)
    assert "travel 0.2 m, up to 0.40" in out
    assert "carriage.mass" in out
