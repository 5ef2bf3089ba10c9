"""JSON Schemas: every shipped and written file is valid, what the reader refuses is not, editors find them offline."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.document import read_document
from torquerig.reporting.file_schemas.named import FILES, OUTPUTS, schema_named
from torquerig.scenario.kinds import KINDS
from torquerig.schema_comment import schema_comment

COMMENT = re.compile(r"# yaml-language-server: \$schema=(\S+)")
SHIPPED = sorted([*shipped_folder().rglob("*.yaml"), *shipped_scenarios().glob("*.yaml")])


def with_text_keys(value: Any) -> Any:
    """Return YAML data as JSON has it: keys are texts."""
    if isinstance(value, dict):
        return {str(key): with_text_keys(one) for key, one in value.items()}
    return [with_text_keys(one) for one in value] if isinstance(value, list) else value


def problems(name: str, data: Any) -> list[str]:
    """Return what a schema finds in the data of a file."""
    return [one.message for one in Draft202012Validator(schema_named(name)).iter_errors(with_text_keys(data))]


def named_in(path: Path) -> str:
    """Return the path of the schema that the first line of a file names."""
    match = COMMENT.fullmatch(path.read_text(encoding="utf-8").splitlines()[0])
    assert match is not None, path
    return match[1]


@pytest.mark.parametrize("name", [*FILES, *OUTPUTS])
def test_every_schema_is_a_json_schema(name: str) -> None:
    schema = schema_named(name)
    Draft202012Validator.check_schema(schema)
    json.dumps(schema, allow_nan=False)
    assert schema["title"]
    assert schema == schema_named(name)


def test_there_are_many_shipped_files() -> None:
    assert len(SHIPPED) > 60


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.name)
def test_every_shipped_file_is_valid_by_the_schema_that_it_names(path: Path) -> None:
    name = Path(named_in(path)).stem
    assert name in FILES
    assert problems(name, read_document(path).data) == []


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("filled") / "rig"
    main(["init", str(folder)])
    return folder


def test_init_writes_the_schemas_where_its_files_look_for_them(filled: Path) -> None:
    files = [*(filled / "catalogs").rglob("*.yaml"), *(filled / "scenarios").glob("*.yaml")]
    assert len(files) == len(SHIPPED)
    for path in files:
        schema = (path.parent / named_in(path)).resolve()
        assert json.loads(schema.read_text(encoding="utf-8")) == schema_named(schema.stem)


def test_files_that_commands_write_name_their_schema(filled: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(filled)
    main(["simulate", "scenarios/wear_rig.yaml", "--duration", "1 s", "--out", "run.parquet"])
    main(["synth", "control", "--duration", "1 s", "--out", "control.csv"])
    main(["catalog", "new", "catalogs/motors/mine.yaml"])
    main(["matrix", "scenarios/matrix_example.yaml", "--out", "mine.yaml"])
    Path("bare.csv").write_text("time_s,torque_Nm\n0,1\n1,2\n2,3\n", encoding="utf-8")
    main(["sheet", "bare.csv"])
    written = {
        "run.yaml": "sidecar", "control.yaml": "sidecar", "bare.yaml": "sidecar", "mine.yaml": "matrix",
        "catalogs/motors/mine.yaml": "motor",
    }  # fmt: skip
    for path, name in written.items():
        assert (Path(path).parent / named_in(Path(path))).resolve() == (filled / "schemas" / f"{name}.json").resolve()
        if name != "motor":  # that has blanks
            assert problems(name, read_document(Path(path)).data) == []


def test_no_schema_is_named_where_there_is_none(tmp_path: Path) -> None:
    assert schema_comment(tmp_path / "run.yaml", "sidecar") == ""


MOTOR = read_document(shipped_folder() / "motors" / "HDS6A-0104A.yaml").data
RIG = read_document(shipped_scenarios() / "wear_rig.yaml").data
SIDECAR = {"channels": {"torque": {"quantity": "torque", "unit": "V", "Nm_per_V": 5.0}}}


def scenario_with(name: str, **part: Any) -> dict[str, Any]:
    return {**RIG, "rig": {**RIG["rig"], name: {**RIG["rig"].get(name, {}), **part}}}


GOOD: dict[str, tuple[str, Any]] = {
    "scale": ("sidecar", SIDECAR),
    "uncertain number": ("scenario", scenario_with("motor", inertia={"value": "1e-5 kg*m^2", "rel_sd": 0.1})),
    "tolerance": ("scenario", scenario_with("motor", inertia="1e-5 kg*m^2 ± 10 %")),
    "like": ("motor", {"name": "x", "title": "x", "kind": "pmsm", "like": "servo-60mm-400W"}),
}
BAD: dict[str, tuple[str, Any]] = {
    "misspelt key of a motor": ("motor", {**MOTOR, "rated_torqe": MOTOR["rated_torque"]}),
    "number without unit": ("motor", {**MOTOR, "rated_torque": 1.27}),
    "value without evidence": ("motor", {**MOTOR, "rated_torque": {"value": "1.27 N*m"}}),
    "missing value": ("motor", {key: one for key, one in MOTOR.items() if key != "rated_torque" and key != "like"}),
    "unknown section": ("scenario", {**RIG, "rigg": {}}),
    "unknown kind": ("scenario", scenario_with("motor", kind="moter")),
    "part without kind": ("scenario", {**RIG, "rig": {"motor": {"catalog": "bldc-12n14p"}}}),
    "unknown key of a part": ("scenario", scenario_with("motor", inerta="1e-5 kg*m^2")),
    "bare number of a part": ("scenario", scenario_with("motor", inertia=1e-5)),
    "unknown metric": ("scenario", {**RIG, "study": {**RIG["study"], "criteria": {"x": {"metric": 3}}}}),
    "unknown key of a channel": ("sidecar", {"channels": {"torque": {"quantity": "torque", "scale": 5}}}),
    "criterion without a name": ("matrix", {"criteria": [], "alternatives": {}}),
}  # fmt: skip


@pytest.mark.parametrize("case", GOOD)
def test_what_the_reader_takes_is_valid(case: str) -> None:
    assert problems(*GOOD[case]) == []


@pytest.mark.parametrize("case", BAD)
def test_what_the_reader_refuses_is_not_valid(case: str) -> None:
    assert problems(*BAD[case])


def test_the_schema_of_a_scenario_has_every_kind() -> None:
    schema = schema_named("scenario")
    assert schema["$defs"]["part"]["properties"]["kind"]["enum"] == sorted(KINDS)
    for kind in KINDS:
        assert schema["$defs"][f"part_{kind}"]["properties"]["kind"] == {"const": kind}


def test_the_command_prints_lists_and_refuses(capsys: pytest.CaptureFixture[str]) -> None:
    main(["schema", "motor"])
    assert json.loads(capsys.readouterr().out) == schema_named("motor")
    main(["schema"])
    listed = capsys.readouterr().out
    assert all(name in listed for name in ("motor", "scenario", "sidecar", "orders-json"))
    with pytest.raises(SystemExit) as left:
        main(["schema", "moter"])
    assert left.value.code == 2
    assert "there is no schema 'moter'; did you mean 'motor'?" in capsys.readouterr().err
