"""``torquerig batch``: a row per file, failures with reasons, nothing overwritten, resumed where it was."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pandas as pd
import pytest

from tests.cli.json_calls import WEAR_RIG
from torquerig.cli import main
from torquerig.recordings.files import read_recording

CHAIN = "report_filter_code"


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("batch") / "runs"
    folder.mkdir()
    for seed in (1, 2):
        main(["simulate", WEAR_RIG, "--duration", "3 s", "--rate", "5 kHz", "--seed", str(seed),
              "--out", str(folder / f"run{seed}.parquet")])  # fmt: skip
    (folder / "broken.parquet").write_bytes(b"no table")
    return folder


@pytest.fixture
def folder(runs: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(runs, tmp_path / "runs")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def batch(*arguments: str) -> int:
    """Return the exit code of a call."""
    try:
        main(["batch", *arguments])
    except SystemExit as left:
        return int(left.code or 0)
    return 0


@pytest.mark.parametrize("name", ["filter", "ordermap", "info"])
def test_each_file_is_a_row_and_the_failed_one_has_its_reason(
    name: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert batch(name, "runs") == 2
    said = capsys.readouterr()
    assert "1 of 3 files failed; runs-" in said.err.splitlines()[-1]
    table = pd.read_csv(folder / f"runs-{name}.csv", index_col="file")
    assert table["status"].to_dict() == {
        "broken.parquet": "failed", "run1.parquet": "computed", "run2.parquet": "computed"
    }  # fmt: skip
    assert "broken.parquet" in table.loc["broken.parquet", "reason"]
    document = json.loads((folder / "runs" / f"run1.parquet.{name}.json").read_text(encoding="utf-8"))
    assert document["schema"] == f"torquerig.{name}/1"


def test_the_rows_hold_the_figures_of_single_calls(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    batch("filter", "runs", "--table", "rows.parquet", "--", "--chain", CHAIN)
    table = pd.read_parquet(folder / "rows.parquet").set_index("file")
    main(["filter", "runs/run2.parquet", "--chain", CHAIN, "--json", "one.json"])
    one = json.loads((folder / "one.json").read_text(encoding="utf-8"))
    row = table.loc["run2.parquet"]
    assert row["std [N*m]"] == one["std"]["value"]
    assert row[f"{CHAIN}: std cut [%]"] == one["chains"][0]["std_cut_percent"]
    filtered = read_recording(folder / "runs" / f"run2.{CHAIN}.parquet")
    assert filtered.torque().std() == pytest.approx(one["chains"][0]["std"]["value"], rel=1e-9)


def test_a_second_call_takes_over_what_is_there_and_adds_what_is_new(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    call = ("filter", "runs", "--", "--chain", CHAIN)
    (folder / "runs" / "broken.parquet").unlink()
    assert batch(*call) == 0
    kept = {path.name: path.stat().st_mtime_ns for path in (folder / "runs").iterdir()}
    (folder / "runs" / "run2.parquet.filter.json").unlink()
    (folder / "runs" / f"run2.{CHAIN}.parquet").unlink()
    (folder / "runs" / f"run2.{CHAIN}.yaml").unlink()
    capsys.readouterr()
    assert batch(*call) == 0
    assert "2 files: 1 computed, 1 taken over, 0 failed" in capsys.readouterr().out
    now = {path.name: path.stat().st_mtime_ns for path in (folder / "runs").iterdir()}
    assert set(now) == set(kept)  # filtered recordings are not filtered again
    assert {name for name in now if now[name] == kept[name]} == {name for name in kept if not name.startswith("run2.")
                                                                 or name in ("run2.parquet", "run2.yaml")}  # fmt: skip


def test_results_of_other_options_or_input_are_not_overwritten(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "runs" / "broken.parquet").unlink()
    batch("ordermap", "runs")
    before = (folder / "runs" / "run1.parquet.ordermap.json").read_bytes()
    assert batch("ordermap", "runs", "--", "--harmonics", "2") == 2
    assert "of other input, options or version" in capsys.readouterr().out
    assert (folder / "runs" / "run1.parquet.ordermap.json").read_bytes() == before


def test_several_processes_give_the_same_table(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "runs" / "broken.parquet").unlink()
    shutil.copytree(folder / "runs", folder / "again")
    batch("info", "runs", "--table", "one.csv")
    batch("info", "again", "--table", "two.csv", "--workers", "2")
    one, two = ((folder / name).read_text(encoding="utf-8") for name in ("one.csv", "two.csv"))
    assert one == two


BAD: dict[str, tuple[tuple[str, ...], str]] = {
    "no folder": (("info", "nowhere"), "nowhere: there is no such folder"),
    "unknown command": (("compare", "runs"), "'compare' is not one of"),
    "unknown option": (("info", "runs", "--", "--chain", "x"), "No such option '--chain'"),
    "output of one file": (("filter", "runs", "--", "--out", "x.csv"), "names one file, and batch runs over many"),
    "its JSON": (("filter", "runs", "--", "--json", "x.json"), "batch writes the JSON of each file itself"),
    "table over a stranger": (
        ("info", "runs", "--table", "notes.csv"),
        "is there already and no table of torquerig batch",
    ),
    "table of another form": (("info", "runs", "--table", "rows.txt"), "a table ends in .csv or .parquet"),
    "empty folder": (("info", "empty"), "there is no recording in this folder"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_calls_are_one_sentence_and_write_nothing(
    case: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments, sentence = BAD[case]
    (folder / "empty").mkdir()
    (folder / "notes.csv").write_text("my notes\n", encoding="utf-8")
    before = sorted(str(path) for path in folder.rglob("*"))
    capsys.readouterr()
    assert batch(*arguments) == 2
    said = capsys.readouterr().err
    assert sentence.lower() in said.lower()
    assert said.count("\n") == 1
    assert sorted(str(path) for path in folder.rglob("*")) == before
