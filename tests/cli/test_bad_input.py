"""Bad input: exit code 2, one sentence on standard error, nothing on standard output, nothing overwritten."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main

# ruff: noqa: E501 (a table: one case in a row)
WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")
SIDECAR = "sample_rate_Hz: 1000\nchannels: {torque_V: {quantity: torque, unit: V, Nm_per_V: 1.0}}\n"


@pytest.fixture(autouse=True)
def _in_a_folder_with_bad_recordings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    rows = {"nan": "0.1\nnan\n0.2\n", "none": "", "text": "0.1\n0.2x\n0.3\n", "short": "0.1\n"}
    for name, text in rows.items():
        Path(f"{name}.csv").write_text(f"torque_V\n{text}")
        Path(f"{name}.yaml").write_text(SIDECAR)
    Path("wrong.csv").write_text("time_s,pressure_Pa\n0,1\n0.1,2\n")
    Path("good.csv").write_text("torque_V\n" + "\n".join(map(str, np.sin(np.arange(3000)))) + "\n")
    Path("good.yaml").write_text(SIDECAR)
    Path("broken.yaml").write_text("rig: [\n")
    Path("file").write_text("kept")
    Path("file.svg").write_text("kept")
    Path("there.parquet").write_text("kept")


CASES: dict[str, tuple[tuple[str, ...], str]] = {
    "unknown command": (("simulat",), "there is no command 'simulat'; did you mean 'simulate'?"),
    "unknown option": (("simulate", WEAR_RIG, "--durations", "1 s"), "--durations"),
    "missing argument": (("filter",), "missing argument 'RECORDING'"),
    "option out of range": (("simulate", WEAR_RIG, "--seed", "-1"), "'--seed'"),
    "missing scenario": (("simulate", "nope.yaml"), "nope.yaml: there is no such file"),
    "folder as scenario": (("simulate", "."), "cannot be read"),
    "no YAML": (("simulate", "broken.yaml"), "broken.yaml:2: not YAML"),
    "duration without unit": (("simulate", WEAR_RIG, "--duration", "2"), "--duration: '2' has no unit; write '2 s'"),
    "negative duration": (("simulate", WEAR_RIG, "--duration", "-1 s"), "ask for more"),
    "unknown ending": (("simulate", WEAR_RIG, "--out", "x.foo"), "the ending '.foo' cannot be written; use .parquet"),
    "missing folder": (("simulate", WEAR_RIG, "--out", "no/x.csv"), "there is no folder no; make it first"),
    "existing file": (("simulate", WEAR_RIG, "--out", "there.parquet"), "overwrite it with --force"),
    "unknown motor": (("simulate", WEAR_RIG, "--motor", "HDS6A-0104B"), "--motor HDS6A-0104B: there is no motor"),
    "unknown gearbox": (("simulate", WEAR_RIG, "--gearbox", "economy-20"), "did you mean 'economy-20-1'"),
    "motor too slow": (
        ("simulate", WEAR_RIG, "--motor", "GP-71M", "--gearbox", "economy-20-1"), "choose a smaller ratio or output speed",
    ),
    "unknown part of --set": (("simulate", WEAR_RIG, "--set", "gearbocks.ratio=10"), "--set gearbocks.ratio=10: the"),
    "unknown catalog folder": (("catalog", "--catalog", "nope"), "there is no such catalog folder"),
    "unknown entry": (("catalog", "HDS6A-0104B"), "or 'HDS6A-0104A' or"),
    "speed without unit": (("orders", "--speed", "1000"), "--speed: '1000' has no unit; write '1000 rpm' or '1000 rad/s'"),
    "ratio 0": (("orders", "--ratio", "0"), "ratio"),
    "planets without sun": (("orders", "--planets", "3"), "--planets needs --sun and --ring"),
    "ring without sun": (("orders", "--ring", "84"), "--sun and --ring need each other"),
    "not a number": (("filter", "nan.csv", "--motor", "REF", "--ratio", "5"), "nan.csv: torque_V has 1 sample not a finite number, the first at sample 1"),
    "no samples": (("filter", "none.csv"), "none.csv: "),
    "text among numbers": (("info", "text.csv"), "text.csv:3"),
    "wrong columns": (("filter", "wrong.csv", "--motor", "REF", "--ratio", "5"), "wrong.csv: "),
    "a picture of another kind": (("info", "good.csv", "--picture", "x.gif"), "x.gif: a picture is written as .svg or .png"),
    "a picture that is there": (("info", "good.csv", "--picture", "file.svg"), "file.svg: is there already; choose another name, or overwrite it with --force"),
    "no such recording": (("info", "run.csv"), "run.csv: there is no such file"),
    "unknown chain": (("filter", "good.csv", "--chain", "report_filter_cod", "--motor", "REF", "--ratio", "5"), "did you mean 'report_filter_code'"),
    "out of two chains": (("filter", "good.csv", "--out", "x.csv"), "--out and --picture need exactly one --chain"),
    "filter onto itself": (("filter", "good.csv", "--chain", "none", "--out", "good.csv"), "good.csv: is the input; choose another name"),
    "filter onto itself with force": (("filter", "good.csv", "--chain", "none", "--out", "good.csv", "--force"), "good.csv: is the input; choose another name"),
    "a picture of another kind beside a recording": (("filter", "good.csv", "--chain", "none", "--motor", "REF", "--ratio", "5", "--out", "new.csv", "--picture", "x.gif"), "x.gif: a picture is written as .svg or .png"),
    "a picture in no folder": (("filter", "good.csv", "--chain", "none", "--out", "new.csv", "--picture", "no/x.svg"), "there is no folder no; make it first"),
    "a picture without a speed": (("filter", "good.csv", "--chain", "none", "--motor", "REF", "--ratio", "5", "--out", "new.csv", "--picture", "x.svg"), "the order lines of a picture need one; add to the sidecar: run: {speed_rpm: N}"),
    "block without unit": (("filter", "good.csv", "--chain", "none", "--motor", "REF", "--ratio", "5", "--block", "60"), "--block: '60' has no unit"),
    "matrix of a rig": (("matrix", WEAR_RIG), "wear_rig.yaml: is the scenario of a rig, not a matrix; use torquerig compare"),
    "missing matrix": (("matrix", "nope.yaml"), "nope.yaml: there is no such file"),
    "compare without study": (("compare", str(shipped_scenarios() / "filters.yaml")), "there is no study: section"),
    "report onto a file": (("compare", WEAR_RIG, "--out", "file"), "file is a file; name a folder for the report"),
    "compare at a stand": (("compare", WEAR_RIG, "--set", "output_speed=0 rpm"), "a study needs a speed"),
    "motor that is not listed": (("compare", WEAR_RIG, "--set", "study.motors=[GP-71M]"), "the present motor 'bldc-12n14p' is not"),
    "points beyond the scale": (("compare", WEAR_RIG, "--set", "disturbance.points={0: 7, 1: 1}"), "7 points are outside the scale 1..5"),
    "a unit the metric has not": (("compare", WEAR_RIG, "--set", "price.unit=USD"), "price has the unit 'EUR', not 'USD'"),
    "no demand": (("compare", WEAR_RIG, "--set", "requirements={}"), "study.requirements: the list is empty"),
    "ratio that is none": (("compare", WEAR_RIG, "--set", "gearbox.ratio=abc"), "rig.gearbox.ratio: 'abc' is no ratio"),
    "band upside down": (("compare", WEAR_RIG, "--set", "speed use.band=[1.0, 0.3]"), "swap them"),
    "unknown filter": (("compare", WEAR_RIG, "--set", "filters.names=[report_filter_cod]"), "did you mean 'report_filter_code'"),
    "unknown present filter": (("compare", WEAR_RIG, "--set", "present.filter=nil"), "study.present.filter: unknown filter chain"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_bad_input_is_one_sentence_and_exit_code_2(
    case: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    arguments, said = CASES[case]
    there = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    told = capsys.readouterr()
    assert stopped.value.code == 2
    assert said in told.err
    assert told.err.startswith("torquerig: ")
    assert told.err.count("\n") == 1
    assert "Traceback" not in told.err
    assert told.out == ""
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == there


@pytest.mark.long
def test_force_overwrites_an_earlier_recording() -> None:
    main(["simulate", WEAR_RIG, "--duration", "0.1 s", "--out", "there.parquet", "--force"])
    assert Path("there.parquet").read_bytes().startswith(b"PAR1")


def test_no_command_shows_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main([])
    assert stopped.value.code == 2
    assert "Commands:" in capsys.readouterr().err


def test_ctrl_c_leaves_the_old_report_and_no_half_new_one(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from torquerig.cli import compare

    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(compare, "run_study", interrupted)
    Path("reports/wear_rig").mkdir(parents=True)
    Path("reports/wear_rig/index.html").write_text("old")
    with pytest.raises(SystemExit) as stopped:
        main(["compare", WEAR_RIG])
    assert stopped.value.code == 130
    assert "interrupted; no file is incomplete" in capsys.readouterr().err
    assert [path.name for path in Path("reports").rglob("*")] == ["wear_rig", "index.html"]
    assert Path("reports/wear_rig/index.html").read_text() == "old"


def test_ctrl_c_while_the_report_is_written_leaves_none(tmp_path: Path) -> None:
    from torquerig.reporting.replaced_folder import replaced_folder

    def broken_off() -> None:
        with replaced_folder(tmp_path / "reports" / "wear_rig") as fresh:
            (fresh / "index.html").write_text("half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        broken_off()
    assert list((tmp_path / "reports").iterdir()) == []


@pytest.mark.long
@pytest.mark.parametrize("command", ["simulate", "filter"])
def test_ctrl_c_leaves_no_half_recording(command: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("torquerig.recordings.files.writing.sidecar_text", interrupted)
    arguments = {
        "simulate": ["simulate", WEAR_RIG, "--duration", "0.1 s", "--out", "x.csv"],
        "filter": ["filter", "good.csv", "--chain", "none", "--motor", "REF", "--ratio", "5", "--out", "x.csv"],
    }[command]
    before = sorted(tmp_path.iterdir())
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code == 130
    assert sorted(tmp_path.iterdir()) == before


def test_a_recording_of_another_ending_leaves_the_sidecar(tmp_path: Path) -> None:
    before = (tmp_path / "good.yaml").read_bytes()
    main(["simulate", WEAR_RIG, "--duration", "0.02 s", "--out", "good.parquet", "--force"])
    assert (tmp_path / "good.yaml").read_bytes() == before
