"""Words, tables and page of a diagnosis."""

from __future__ import annotations

import copy
import json
import re

import pytest
from click.testing import CliRunner
from jsonschema import Draft202012Validator

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.cli.diagnose import command
from torquerig.recordings.files.writing import write_recording
from torquerig.reporting.diagnosis.answer_text import answer_lines
from torquerig.reporting.diagnosis.likelihood import tables
from torquerig.reporting.diagnosis.likelihood.first_screen import first_screen
from torquerig.reporting.diagnosis.likelihood.sentences import remarks_of, verdict_of
from torquerig.reporting.file_schemas.named import schema_named

FINDING = {
    "mechanism": "gear_mesh", "part": "gear", "explanation": "The model lacks a mesh.", "confidence": 0.93,
    "parameters": {"order_output": {"value": 72.0, "ci95": [72.0, 72.0], "unit": "1/rev"}},
    "equivalent_to": ["commutation_ripple"], "next_experiment": "Record a steady run at 640 rpm, 12 s long.",
    "size": {"value": 0.21, "unit": "N*m"},
    "alternatives": [
        {"hypothesis": "a ripple of motor", "mechanism": "commutation_ripple", "nats_behind": 1.2},
        {"hypothesis": "a torque at order 360", "mechanism": None, "nats_behind": 9.0},
    ],
}  # fmt: skip
UNNAMED = {
    "kind": "line_family", "axis": "motor_shaft", "at": 9.0, "harmonics": [1, 2], "acts_as": "torque at pump",
    "size": {"value": 0.12, "ci95": [0.11, 0.13], "unit": "N*m"}, "in_model": True, "minor": False,
    "confidence": 0.99, "equivalent_to": [], "alternatives": [],
    "explanation": "The recordings show a torque at order 9 of pump. No mechanism of the library explains it.",
}  # fmt: skip
DATA = {
    "verdict": "unexplained", "findings": [FINDING], "unnamed": [UNNAMED], "setup": [], "mismatch": [],
    "upper_limits": [],
    "fit": {"before": {"heldout_misfit": 5.0, "nominal": 9.0}, "after": {"heldout_misfit": 1.1}},
    "rms": {"unit": "N*m", "before": 1.69, "after": 0.44, "after_named_only": 0.9, "true_model": 0.3,
            "recordings": [{"file": "run1.parquet", "before": 1.69, "after": 0.44}]},
}  # fmt: skip


def changed(**keys):
    return {**copy.deepcopy(DATA), **keys}


def test_the_answer_says_name_size_class_error_and_next_run():
    text = "\n".join(answer_lines(DATA, verdict=verdict_of(DATA), remarks=remarks_of(DATA)))
    joined = re.sub(r"\s+", " ", text)
    assert "gear mesh (0.21 N m rms, not distinguished from commutation ripple)" in joined
    assert "1.69 N m before, 0.44 N m after" in joined
    assert "1.2 nats less likely" in joined
    assert "line family at order 9 of the motor shaft" in joined
    assert joined.endswith("Next: Record a steady run at 640 rpm, 12 s long.")


@pytest.mark.parametrize("verdict", ["adequate", "missing_physics", "setup_error", "unexplained"])
def test_every_verdict_has_its_sentences(verdict):
    fact = {"kind": "sensor_scale", "of": "sensor", "stated": 1.0, "confidence": 0.99, "equivalent_to": [],
            "estimated": {"value": 2.0, "ci95": [1.9, 2.1], "unit": "1"}}  # fmt: skip
    data = changed(verdict=verdict, setup=[fact] if verdict == "setup_error" else [])
    if verdict in ("adequate", "setup_error"):
        data = {**data, "findings": [], "unnamed": []}
    said = verdict_of(data)
    assert said.endswith(".")
    assert ("sensor scale of sensor" in said) == (verdict == "setup_error")
    shown = first_screen(data)
    assert "1.69 to 0.44 N m rms" in " ".join(shown.sentences)
    assert all(len(one.split()) < 40 for one in shown.sentences)


def test_what_nothing_explains_is_located_in_words():
    row = {"domain": "order", "axis": "motor_shaft", "at": 3.0, "width": 0.01, "recordings": ["run1.parquet"],
           "excess_dB": 12.0, "share_of_misfit": 0.4, "p_value": 1e-9}  # fmt: skip
    said = verdict_of(changed(findings=[], unnamed=[], mismatch=[{**row, "at": 9.0, "share_of_misfit": 0.1}, row]))
    assert "The largest residual is at order 3 of the motor shaft, in run1.parquet." in said


def test_an_adequate_answer_lists_what_would_have_been_seen():
    limits = [
        {"mechanism": "blade_pass", "parameter": "amplitude_Nm", "value": 0.02, "unit": "N*m", "grows": "up"},
        {"mechanism": "sensor_bandwidth", "parameter": "cutoff_Hz", "value": 300.0, "unit": "Hz", "grows": "down"},
    ]
    data = changed(verdict="adequate", findings=[], unnamed=[], upper_limits=limits)
    (said,) = remarks_of(data)
    assert "blade pass (amplitude_Nm) from 0.02 N m, sensor bandwidth (cutoff_Hz) below 300 Hz." in said


def test_alternatives_are_judged_by_class():
    table = tables.alternatives_table(FINDING)
    assert [row[-1].text for row in table.rows] == [
        "not distinguished by these recordings", "rejected: less likely"
    ]  # fmt: skip


def test_the_table_of_facts_says_what_each_means():
    value = {"value": -4096.0, "ci95": [-4096.0, -4096.0], "unit": "1/rev"}
    fact = {"kind": "counts_per_rev", "of": "encoder", "stated": 4096.0, "estimated": value, "confidence": 0.99,
            "equivalent_to": ["sensor_sign"], "explanation": "The encoder counts backwards."}  # fmt: skip
    table = tables.setup_table([fact])
    assert table.note == "The encoder counts backwards."
    assert [cell.text for cell in table.rows[0]][2:4] == ["4096", "-4096"]


def test_empty_lists_make_no_tables():
    assert tables.unnamed_table([]) is None
    assert tables.setup_table([]) is None
    assert tables.limits_table([]) is None


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pump")
    hum = mechanisms.MainsInterference(name="hum", frequency=50.0, amplitudes=(0.02,))
    paths = []
    for run in recorded(pump_scenario(folder), hum):
        paths.append(folder / run.name)
        write_recording(run, paths[-1])
    out, page = folder / "out.json", folder / "out.html"
    result = CliRunner().invoke(
        command,
        [*map(str, paths), "--scenario", str(folder / "scenario.yaml"), "--json", str(out),
         "--report", str(page)],
    )  # fmt: skip
    assert result.exit_code == 0, result.output
    return folder, json.loads(out.read_text()), page.read_text(), result.output


@pytest.mark.long
def test_page_and_json_say_the_same(written):
    _, data, page, output = written
    assert data["verdict"] == "missing_physics"
    stated = round(100 * data["findings"][0]["confidence"])
    assert f"mains interference, confidence {stated} %" in page
    assert "The model lacks mains interference" in page
    assert page.count("data:image/svg+xml") == 3  # two runs, and the shares of the places
    assert "http://" not in re.sub(r"xmlns[^ >]*", "", page)
    assert data["rms"]["before"] > data["rms"]["after"]
    assert "wrote" in output.splitlines()[-1]


@pytest.mark.long
def test_the_json_follows_its_schema(written):
    problems = Draft202012Validator(schema_named("diagnosis-json")).iter_errors(written[1])
    assert [one.message for one in problems] == []


@pytest.mark.long
def test_the_written_model_is_adequate_again(written):
    folder, data, _, _ = written
    again = folder / "again.json"
    runs = [str(folder / each["file"]) for each in data["recordings"]]
    result = CliRunner().invoke(command, [*runs, "--scenario", data["model"], "--json", str(again)])
    assert result.exit_code == 0, result.output
    assert json.loads(again.read_text())["verdict"] == "adequate"


@pytest.mark.long
def test_the_page_is_written_last(written, monkeypatch):
    folder, data, _, _ = written
    from torquerig.reporting.diagnosis.likelihood import page as pages

    def broken(*_, **__):
        raise RuntimeError("no page")

    monkeypatch.setattr(pages, "likelihood_page", broken)
    out = folder / "first.json"
    runs = [str(folder / each["file"]) for each in data["recordings"]]
    arguments = [*runs, "--scenario", str(folder / "scenario.yaml"), "--json", str(out)]
    result = CliRunner().invoke(command, [*arguments, "--report", str(folder / "first.html")])
    assert isinstance(result.exception, RuntimeError)
    assert json.loads(out.read_text())["verdict"] == "missing_physics"
