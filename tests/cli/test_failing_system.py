"""A full disk, a closed output, a folder that cannot be written to: one sentence, exit code 2, nothing damaged."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main
from torquerig.reporting.replaced_folder import replaced_folder

MATRIX = str(shipped_scenarios() / "matrix_example.yaml")
COMMAND = [sys.executable, "-m", "torquerig"]
pytestmark = pytest.mark.skipif(os.name == "nt", reason="sizes of files are limited by the shell")


def _limited(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a command whose files may have 4 kB."""
    return subprocess.run(
        ["/bin/bash", "-c", f"ulimit -f 4; exec {sys.executable} -m torquerig {command}"],
        cwd=folder, check=False, capture_output=True, text=True,
    )  # fmt: skip


@pytest.mark.long
def test_a_full_disk_keeps_the_old_file(tmp_path: Path) -> None:
    main(("matrix", MATRIX))  # compiles what the limited command would else write into numba's cache
    for name in ("m.xlsx", "m.html", "m.md"):
        (tmp_path / name).write_text("old")
        ended = _limited(f"matrix {MATRIX} --out {name} --force", tmp_path)
        assert ended.returncode == 2
        assert ended.stderr.startswith(f"torquerig: {name}: file too large; free space")
        assert ended.stderr.count("\n") == 1
        assert (tmp_path / name).read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["m.html", "m.md", "m.xlsx"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no full device")
def test_a_full_output_is_one_sentence() -> None:
    with Path("/dev/full").open("w") as full:
        ended = subprocess.run([*COMMAND, "catalog"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert ended.returncode == 2
    assert ended.stderr.startswith("torquerig: the output: no space left on device; free space")
    assert ended.stderr.count("\n") == 1


def test_an_output_that_nobody_reads_is_one_sentence() -> None:
    reads, writes = os.pipe()
    os.close(reads)
    ended = subprocess.run([*COMMAND, "catalog"], stdout=writes, stderr=subprocess.PIPE, text=True, check=False)
    os.close(writes)
    assert ended.returncode == 2
    assert ended.stderr.startswith("torquerig: the program that reads the output ended before")
    assert ended.stderr.count("\n") == 1


@pytest.mark.parametrize("target", ["m.html", "m.xlsx", "m.yaml"])
def test_a_place_that_is_a_file_is_named_before_the_calculation(
    target: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as stopped:
        main(["matrix", MATRIX, "--out", f"{'x' * 260}{target}"])
    told = capsys.readouterr()
    assert stopped.value.code == 2
    assert "file name too long; choose a shorter name" in told.err
    assert told.out == ""


@pytest.mark.parametrize("at_once", [True, False])
def test_a_report_is_exchanged_with_all_that_was_beside_it(
    at_once: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not at_once:
        monkeypatch.setattr("torquerig.reporting.replaced_folder._exchanged_at_once", lambda *_: False)
    report = tmp_path / "report"
    (report / "mine").mkdir(parents=True)
    (report / "mine" / "notes.txt").write_text("kept")
    (report / "index.html").write_text("old")
    left = tmp_path / ".report.999999999.partial"
    left.mkdir()
    (left / "index.html").write_text("half")
    with replaced_folder(report) as fresh:
        (fresh / "index.html").write_text("new")
        assert (report / "index.html").read_text() == "old"
    assert (report / "index.html").read_text() == "new"
    assert (report / "mine" / "notes.txt").read_text() == "kept"
    assert [path.name for path in tmp_path.iterdir()] == ["report"]
