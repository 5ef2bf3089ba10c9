"""``torquerig differ``: sentences, table, JSON and picture of what changed; bad pairs in one sentence."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.cli.json_calls import WEAR_RIG
from torquerig.cli import main
from torquerig.recordings.files import read_recording, write_recording

ADDED = 0.08  # [N m]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("differ")
    for seed in (1, 2):
        main(["simulate", WEAR_RIG, "--duration", "5 s", "--rate", "5 kHz", "--seed", str(seed),
              "--out", str(made / f"run{seed}.parquet")])  # fmt: skip
    read = read_recording(made / "run2.parquet")
    name = read.torque_name()
    line = ADDED * np.cos(2 * np.pi * 613.0 * np.arange(read.samples) / read.sample_rate)
    channel = read.channels[name]
    changed = replace(channel, values=channel.values + line / channel.si_per_unit)
    write_recording(replace(read, channels={**read.channels, name: changed}), made / "worn.parquet")
    write_recording(replace(read, run=replace(read.run, motor="HDS6A-0104A")), made / "other_motor.parquet")
    write_recording(replace(read, run=replace(read.run, gear_ratio=20.0)), made / "other_ratio.parquet")
    return made


@pytest.fixture(autouse=True)
def _there(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)


def test_a_new_line_is_the_first_sentence_and_in_the_json(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    call = ["differ", "run1.parquet", "worn.parquet", "--scenario", WEAR_RIG]
    main([*call, "--picture", "changes.svg", "--force", "--json", "changes.json"])
    said = capsys.readouterr().out
    assert said.startswith("The largest change: the line at 613.0")
    assert "N m; 95 % interval +0.0" in " ".join(said.split())
    assert "would be seen" in said
    first = json.loads((folder / "changes.json").read_text(encoding="utf-8"))["changed"][0]
    assert first["kind"] == "frequency"
    assert first["change"]["unit"] == "N*m"
    assert first["change"]["low"] <= ADDED <= first["change"]["high"]
    assert first["change_percent"] is None
    assert (folder / "changes.svg").read_text(encoding="utf-8").count("run1.parquet") >= 1


def test_without_a_change_the_smallest_one_that_would_be_seen_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    main(["differ", "run1.parquet", "run2.parquet", "--scenario", WEAR_RIG])
    said = capsys.readouterr().out
    assert said.startswith("Nothing changed that these two recordings can show.")
    for kind in ("order lines: no change.", "frequency bands: no change.", "The mean: no change."):
        assert kind in said
    assert said.count("N m would be seen.") == 4


def test_a_recording_compared_with_itself_has_no_difference(capsys: pytest.CaptureFixture[str]) -> None:
    main(["differ", "run1.parquet", "run1.parquet", "--json", "-"])
    found = json.loads(capsys.readouterr().out)
    assert found["changed"] == []
    assert {one["change"]["value"] for one in found["tested"]} == {0.0}


BAD: dict[str, tuple[tuple[str, ...], str]] = {
    "missing file": (("run1.parquet", "nope.parquet"), "nope.parquet: there is no such file"),
    "one file": (("run1.parquet",), "missing argument 'after'"),
    "two motors": (("run1.parquet", "other_motor.parquet"), "compare two recordings of one rig"),
    "two ratios": (("run1.parquet", "other_ratio.parquet"), "a gear ratio of 5, other_ratio.parquet of 20"),
    "mains": (("run1.parquet", "run2.parquet", "--mains", "0 Hz"), "is not more than 0"),
    "json over input": (("run1.parquet", "run2.parquet", "--json", "run2.parquet"), "is one of the inputs"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_pairs_are_one_sentence(case: str, capsys: pytest.CaptureFixture[str]) -> None:
    arguments, sentence = BAD[case]
    with pytest.raises(SystemExit) as left:
        main(["differ", *arguments])
    said = capsys.readouterr()
    assert left.value.code == 2
    assert sentence.lower() in said.err.lower()
    assert said.err.count("\n") == 1
