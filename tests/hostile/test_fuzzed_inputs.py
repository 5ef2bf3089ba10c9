"""Mutated files of every kind: no traceback, no hang, exit code 2 with a sentence, nothing that acts on a terminal.

The quick tests draw a few inputs of each kind; ``pytest -m full tests/hostile`` draws many.
"""

from __future__ import annotations

import shutil
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from tests.hostile.mutation import mutated_text, mutated_workbook
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main

LONGEST = 10.0  # [s] of one input
QUICK, MANY = 12, 1000  # inputs of each kind
KINDS = {
    "matrix": ("matrix_example.yaml", ("matrix", "input.yaml")),
    "mixture": ("mixture_example.yaml", ("synth", "mixture", "input.yaml", "--out", "made.csv", "--force")),
    "filters": ("filters.yaml", ("filter", "run.csv", "--filters", "input.yaml", "--chain", "report_filter_code")),
    "duty": ("wear_rig.yaml", ("duty", "input.yaml")),
    "modes": ("two_stage_branch.yaml", ("modes", "input.yaml")),
    "simulation": ("wear_rig.yaml", ("simulate", "input.yaml", "--duration", "0.02 s", "--out", "m.csv", "--force")),
}
RUN = """
sample_rate_Hz: 1000
channels: {torque_V: {quantity: torque, unit: V, Nm_per_V: 1.0}}
run: {motor: bldc-12n14p, gear_ratio: 5, speed_rpm: 1000, profile: steady, occupancy_percent: 5, notes: none}
"""


@pytest.fixture(autouse=True)
def _in_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    torque = 1 + 0.1 * np.random.default_rng(0).standard_normal(3000)
    Path("run.csv").write_text("torque_V\n" + "\n".join(f"{value:.6f}" for value in torque) + "\n")
    Path("run.yaml").write_text(RUN)
    for shipped in shipped_scenarios().glob("*.yaml"):
        shutil.copy(shipped, shipped.name)


@pytest.mark.parametrize("kind", KINDS)
def test_mutated_files_are_read_or_refused(kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    _try_texts(kind, QUICK, capsys)


@pytest.mark.full
@pytest.mark.parametrize("kind", KINDS)
def test_many_mutated_files_are_read_or_refused(kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    _try_texts(kind, MANY, capsys)


def test_mutated_sidecars_are_read_or_refused(capsys: pytest.CaptureFixture[str]) -> None:
    for rng in _generators("sidecar", QUICK):
        Path("run.yaml").write_text(mutated_text(RUN, rng), encoding="utf-8")
        _run(("info", "run.csv"), capsys)


def test_mutated_catalog_files_are_read_or_refused(capsys: pytest.CaptureFixture[str]) -> None:
    shipped = sorted(shipped_folder().rglob("*.yaml"))
    for rng in _generators("catalog", QUICK):
        chosen = shipped[int(rng.integers(len(shipped)))]
        folder = Path("mine") / chosen.parent.name
        folder.mkdir(parents=True)
        (folder / chosen.name).write_text(mutated_text(chosen.read_text(encoding="utf-8"), rng), encoding="utf-8")
        _run(("catalog", chosen.stem, "--catalog", "mine"), capsys)
        shutil.rmtree("mine")


def test_mutated_workbooks_are_read_or_refused(capsys: pytest.CaptureFixture[str]) -> None:
    _run(("matrix", "matrix_example.yaml", "--out", "whole.xlsx"), capsys)
    content = Path("whole.xlsx").read_bytes()
    for rng in _generators("workbook", QUICK):
        Path("input.xlsx").write_bytes(mutated_workbook(content, rng))
        _run(("matrix", "input.xlsx"), capsys)


HOSTILE = (
    "\\e[31mred\\e[0m",
    "\\e]0;title\\a",
    "a\\rb",
    "\\u202Egnp.exe",
    "=1+1",
    "<script>alert(1)</script>",
    "$\\\\frac$",
)


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_are_shown_harmless(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    text = Path("matrix_example.yaml").read_text(encoding="utf-8")
    Path("input.yaml").write_text(text.replace("\n  servo A:", f'\n  "{name}":'), encoding="utf-8")
    outs = ["page.html", "page.md", "page.xlsx", "page.yaml"]
    _run(("matrix", "input.yaml", *(word for out in outs for word in ("--out", out))), capsys)
    for out in outs[:2]:
        page = Path(out).read_text(encoding="utf-8")
        assert not any(sign in page for sign in "\x1b\x07\r\u202e")
    assert "<script>alert(1)" not in Path("page.html").read_text(encoding="utf-8")
    _run(("matrix", "page.xlsx"), capsys)
    _run(("matrix", "page.yaml"), capsys)


def _try_texts(kind: str, count: int, capsys: pytest.CaptureFixture[str]) -> None:
    name, arguments = KINDS[kind]
    text = Path(name).read_text(encoding="utf-8")
    for rng in _generators(kind, count):
        Path("input.yaml").write_text(mutated_text(text, rng), encoding="utf-8")
        _run(arguments, capsys)


def _generators(kind: str, count: int) -> Iterator[np.random.Generator]:
    return (np.random.default_rng([number, *kind.encode()]) for number in range(count))


def _run(arguments: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    """Run a command; it must end in time with code 0 or 1, or with code 2 and a sentence."""
    started, code = time.monotonic(), 0
    with _no_longer_than(LONGEST):
        try:
            main(arguments)
        except SystemExit as stopped:
            code = int(stopped.code or 0)
    told = capsys.readouterr()
    assert time.monotonic() - started < LONGEST
    assert code in (0, 1, 2)
    assert code != 2 or "torquerig: " in told.err
    assert all(sign.isprintable() or sign in "\n\t" for sign in told.out + told.err)


@contextmanager
def _no_longer_than(seconds: float) -> Iterator[None]:
    def late(*_: object) -> None:
        raise TimeoutError(f"no end after {seconds} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
