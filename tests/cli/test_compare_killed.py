"""``torquerig compare`` stopped by Ctrl-C or kill -9 keeps what is measured, and goes on to the same bytes."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cases.test_killed import wait_until
from torquerig.catalog.shipped import shipped_scenarios

ROOT = Path(__file__).resolve().parents[2]
EDITED = {
    "duration: 10 s\n  seed": "duration: 1 s\n  seed", "draws: 4 ": "draws: 0 ",
    "motors: all ": "motors: [bldc-12n14p, GP-71M, HDS6A-0104A, ESM06X-201-302, HDS60-0102A] ",
}  # fmt: skip
pytestmark = [pytest.mark.skipif(os.name == "nt", reason="Windows has no kill -9"), pytest.mark.long]


def command(folder: Path, name: str, *options: str) -> list[str]:
    return [sys.executable, "-m", "torquerig", "compare", str(folder / "wear_rig.yaml"),
            "--out", str(folder / name), *options]  # fmt: skip


def rows(cache: Path) -> int:
    return sum(1 for _ in cache.glob("results/*/*"))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("wear_rig.yaml", "filters.yaml"):
        text = (shipped_scenarios() / name).read_text()
        if name == "wear_rig.yaml":
            for before, after in EDITED.items():
                assert text.count(before) == 1
                text = text.replace(before, after)
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_a_stopped_comparison_goes_on(folder: Path, number: signal.Signals) -> None:
    cache = folder / "cache"
    stopped = subprocess.Popen(
        command(folder, "stopped", "--cache", str(cache), "--workers", "1"), cwd=ROOT, stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    wait_until(lambda: rows(cache) > 3 or stopped.poll() is not None)  # the catalog, the list of drives, two drives
    stopped.send_signal(number)
    said = stopped.communicate()[1]
    assert not (folder / "stopped").exists()
    if number == signal.SIGINT:
        assert stopped.returncode == 130
        assert re.search(r"interrupted; \d+ drives of the study are kept in .*, and the same command goes on", said)
    again = subprocess.run(
        command(folder, "again", "--cache", str(cache)), cwd=ROOT, check=True, capture_output=True, text=True
    )
    found = re.search(r"study: (\d+) of 15 drives from the cache", again.stderr)
    assert found is not None
    assert 2 <= int(found[1]) < 15
    alone = subprocess.run(command(folder, "alone", "--no-cache"), cwd=ROOT, check=True, capture_output=True, text=True)
    assert "from the cache" not in alone.stderr
    for name in ("index.html", "combinations.csv", "matrices.xlsx"):
        assert (folder / "again" / name).read_bytes() == (folder / "alone" / name).read_bytes()
