"""The command line as a user meets it: every command once, the same bytes, and no scipy to show a help page."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import COMMANDS, main
from torquerig.recordings.files import read_recording

# ruff: noqa: E501 (a table: one case in a row)
WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")
SHORT = ("--duration", "0.2 s")
HEAVY = ("scipy", "pandas", "numba", "matplotlib", "control", "pyarrow")


def run(*arguments: str) -> int:
    """Run the command line in this process and return its exit code."""
    try:
        main(arguments)
    except SystemExit as stopped:
        return int(stopped.code or 0)
    return 0


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def recording() -> str:
    assert run("simulate", WEAR_RIG, "--duration", "1.2 s", "--out", "run1.parquet", "--truth") == 0
    return "run1.parquet"


@pytest.mark.parametrize(
    "command", [(), *((name,) for name in COMMANDS)], ids=lambda words: " ".join(words) or "torquerig"
)
def test_every_command_has_a_help_page(command: Sequence[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(*command, "--help") == 0
    told = capsys.readouterr()
    assert told.out.startswith("Usage: torquerig")
    assert not told.err


def test_the_help_page_lists_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    run("--help")
    out = capsys.readouterr().out
    assert [name for name in COMMANDS if f"\n  {name} " not in out] == []


@pytest.mark.parametrize("what", ["import torquerig", "from torquerig.cli import main; main(['--help'])"])
def test_nothing_heavy_is_imported_for_the_package_or_its_help(what: str) -> None:
    code = f"import sys\ntry:\n    {what}\nexcept SystemExit: pass\nprint('loaded:', *[n for n in {HEAVY!r} if n in sys.modules])"
    told = subprocess.run(
        [sys.executable, "-c", code.replace("; main", "\n    main")], capture_output=True, text=True, check=True
    )
    assert told.stdout.splitlines()[-1] == "loaded:"


def test_the_module_runs_as_the_command_does() -> None:
    told = subprocess.run([sys.executable, "-m", "torquerig", "--version"], capture_output=True, text=True, check=False)
    assert (told.returncode, told.stderr) == (0, "")
    assert told.stdout.startswith("torquerig, version ")


def test_init_copies_what_a_study_needs(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("init", "mine") == 0
    assert Path("mine/scenarios/wear_rig.yaml").is_file()
    assert len(list(Path("mine/catalogs/motors").glob("*.yaml"))) >= 10
    Path("mine/scenarios/wear_rig.yaml").write_text("changed")
    assert run("init", "mine") == 2
    assert "is there already and was not changed; choose another folder" in capsys.readouterr().err
    assert Path("mine/scenarios/wear_rig.yaml").read_text() == "changed"


def test_catalog_shows_all_and_one(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("catalog") == 0
    assert "bldc-12n14p" in capsys.readouterr().out
    assert run("catalog", "HDS5C-102A") == 0
    assert "stands for" in capsys.readouterr().out


def test_orders_shows_the_lines_of_the_reference_report(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("orders", "--ratio", "5", "--speed", "1000 rpm") == 0
    out = capsys.readouterr().out
    assert all(frequency in out for frequency in ("3.33", "16.67", "100", "116.67", "1400"))


def test_simulate_writes_a_recording_as_the_contract_has_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("simulate", WEAR_RIG, *SHORT) == 0
    out = capsys.readouterr().out
    assert "wrote simulated.parquet and simulated.yaml" in out
    assert "bldc-12n14p at 1000 rpm, 5:1, 5 % occupancy" in out
    made = read_recording(Path("simulated.parquet"))
    assert (made.sample_rate, made.samples) == (25_000.0, 5000)
    assert made.run.gear_ratio == 5.0
    assert not any(name.startswith("true_") for name in made.channels)


@pytest.mark.parametrize("ending", ["parquet", "csv"])
def test_the_same_seed_gives_the_same_bytes_and_another_others(ending: str) -> None:
    for name, seed in (("a", "1"), ("b", "1"), ("c", "2")):
        Path(name).mkdir()
        assert run("simulate", WEAR_RIG, *SHORT, "--seed", seed, "--out", f"{name}/run.{ending}") == 0
    a, b, c = (Path(f"{name}/run.{ending}").read_bytes() for name in "abc")
    assert a == b
    assert a != c
    assert Path("a/run.yaml").read_bytes() == Path("b/run.yaml").read_bytes()


def test_simulate_takes_a_candidate_as_compare_would(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("simulate", WEAR_RIG, *SHORT, "--motor", "HDS5C-102A", "--gearbox", "spur-2.5-1") == 0
    out = capsys.readouterr().out
    assert "HDS5C-102A at 500 rpm, 2.5:1" in out
    assert "assumed, because no document states these values:" in out


def test_info_and_filter_tell_what_is_in_a_recording(recording: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("info", recording) == 0
    assert "30000 samples at 25000 Hz, 1.2 s" in capsys.readouterr().out
    assert run("filter", recording) == 0
    out = capsys.readouterr().out
    assert "report_filter_code" in out
    assert "report_filter_text" in out
    assert "error to true load" in out
    assert run("filter", recording, "--chain", "low_pass_20Hz", "--out", "after.csv", "--picture", "after.png") == 0
    assert read_recording(Path("after.csv")).samples == 30_000
    assert Path("after.png").read_bytes().startswith(b"\x89PNG")


def test_matrix_recomputes_the_reference_report(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("matrix", str(shipped_scenarios() / "reference_tables.yaml")) == 0
    assert "4.25" in capsys.readouterr().out


def test_a_study_of_ones_own_is_compared_and_reported(capsys: pytest.CaptureFixture[str]) -> None:
    study = Path("small/tiny.yaml")
    study.parent.mkdir()
    text = Path(WEAR_RIG).read_text(encoding="utf-8")
    for old, new in (
        ("duration: 10 s", "duration: 1 s"), ("draws: 4", "draws: 0"), ("motors: all", "motors: [bldc-12n14p]"),
        ("[spur-2.5-1, reference-5-1, economy-20-1]", "[reference-5-1]"),
    ):  # fmt: skip
        assert old in text
        text = text.replace(old, new)
    study.write_text(text, encoding="utf-8")
    (study.parent / "filters.yaml").write_bytes((shipped_scenarios() / "filters.yaml").read_bytes())
    assert run("compare", str(study), "--workers", "1") == 0
    told = capsys.readouterr()
    assert "bldc-12n14p 5:1" in told.out
    assert "report: " in told.out
    assert "Traceback" not in told.err
    assert Path("reports/tiny/index.html").stat().st_size > 10_000
