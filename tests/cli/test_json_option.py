"""``--json`` of every command: the same bytes from the same inputs, whole or not at all, nothing else printed."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from tests.cli.every_command import every_command
from tests.cli.json_calls import CALLS, FULL, QUICK, SLOW, WEAR_RIG, make_inputs
from torquerig.cli import COMMANDS, group, main
from torquerig.reporting.file_schemas.named import schema_named
from torquerig.reporting.json_results.registry import RESULTS


@pytest.fixture(scope="module")
def inputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("inputs")
    make_inputs(made)
    return made


@pytest.fixture
def folder(inputs: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    here = tmp_path / "here"
    shutil.copytree(inputs, here)
    monkeypatch.chdir(here)
    return here


def nulls(value: Any, at: str = "") -> list[str]:
    """Return the JSON pointers of all nulls."""
    if isinstance(value, dict):
        escaped = {key.replace("~", "~0").replace("/", "~1"): one for key, one in value.items()}
        return [place for key, one in escaped.items() for place in nulls(one, f"{at}/{key}")]
    if isinstance(value, list):
        return [place for number, one in enumerate(value) for place in nulls(one, f"{at}/{number}")]
    return [at] if value is None else []


WITHOUT_JSON = {("schema",), ("completion",), ("studio",)}  # a file for other programs, a page


def test_every_command_has_json_and_a_call_in_these_tests() -> None:
    commands = every_command(group)
    assert len(commands) > len(COMMANDS)
    lack = {path for path, one in commands.items() if not any("--json" in option.opts for option in one.params)}
    assert lack == WITHOUT_JSON & set(commands)
    assert set(RESULTS) == ({*QUICK, *SLOW, *FULL} - {"diagnosis"})


@pytest.mark.parametrize(("name", "call"), CALLS)
def test_json_alone_is_printed_and_the_file_is_the_same(
    name: str, call: tuple[str, ...], folder: Path, inputs: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    main([*call, "--json", "-"])
    printed = capsys.readouterr().out
    document = json.loads(printed)
    assert document["schema"] == f"torquerig.{name}/1"
    assert len(document["provenance"]["source_sha256"]) == 64
    Draft202012Validator(schema_named(f"{name}-json")).validate(document)
    if name != "diagnosis":
        assert sorted(nulls(document)) == sorted(one["at"] for one in document["missing"])
        assert all(one["reason"] for one in document["missing"])
    for path in folder.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    shutil.copytree(inputs, folder, dirs_exist_ok=True)
    main([*call, "--json", "out.json"])
    assert capsys.readouterr().out.strip()
    written = (folder / "out.json").read_text(encoding="utf-8")
    assert written == printed or name == "diagnosis"  # the file of the completed model has another name
    assert json.loads(written)["provenance"] == document["provenance"]


def test_provenance_hashes_recording_and_sidecar(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    seen = []
    for _ in range(2):
        main(["ordermap", "run.parquet", "--json", "-"])
        seen.append(json.loads(capsys.readouterr().out)["provenance"]["inputs_sha256"])
        with (folder / "run.yaml").open("a", encoding="utf-8") as sidecar:
            sidecar.write("# a remark\n")
    assert set(seen[0]) == {"run.parquet", "run.yaml", "catalogs"}
    assert seen[0]["run.parquet"] == seen[1]["run.parquet"]
    assert seen[0]["run.yaml"] != seen[1]["run.yaml"]


REFUSED = {
    "run.parquet": "is one of the inputs",
    "run.yaml": "is one of the inputs",
    "bare.csv": "is there already and no JSON of torquerig filter",
    "other.json": "is there already and no JSON of torquerig filter",
    "nowhere/out.json": "there is no folder nowhere",
    "new.parquet": "two outputs have this path",
}


@pytest.mark.parametrize("out", REFUSED)
def test_json_overwrites_only_json_of_the_same_command(
    out: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "other.json").write_text('{"schema": "torquerig.orders/1"}', encoding="utf-8")
    before = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
    capsys.readouterr()
    with pytest.raises(SystemExit) as left:
        main(["filter", "run.parquet", "--chain", "report_filter_code", "--out", "new.parquet", "--json", out])
    said = capsys.readouterr()
    assert left.value.code == 2
    assert REFUSED[out] in said.err
    assert said.err.count("\n") == 1
    assert {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()} == before


def test_a_failing_command_leaves_the_old_json(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["modes", WEAR_RIG, "--json", "modes.json"])
    before = (folder / "modes.json").read_bytes()
    with pytest.raises(SystemExit):
        main(["modes", WEAR_RIG, "--set", "load.occupancy=nonsense", "--json", "modes.json"])
    assert (folder / "modes.json").read_bytes() == before
    capsys.readouterr()
    with pytest.raises(SystemExit):
        main(["modes", "nowhere.yaml", "--json", "-"])
    assert capsys.readouterr().out == ""


def test_a_file_that_cannot_be_read_is_in_the_json_of_info(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "broken.parquet").write_bytes(b"no table")
    capsys.readouterr()
    with pytest.raises(SystemExit) as left:
        main(["info", "run.parquet", "broken.parquet", "--json", "-"])
    said = capsys.readouterr()
    assert left.value.code == 2
    good, broken = json.loads(said.out)["recordings"]
    assert not good["problem"]
    assert "broken.parquet" in broken["problem"]
    assert "the JSON says why" in said.err


def test_options_without_a_result_refuse_json(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    with pytest.raises(SystemExit):
        main(["matrix", "new.xlsx", "--template", "pugh", "--json", "-"])
    assert "computes nothing; remove --json" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["catalog", "--json", "out.json", "show", "bldc-12n14p"])
    assert "--json belongs after show" in capsys.readouterr().err
    assert not (folder / "new.xlsx").exists()
    assert not (folder / "out.json").exists()
