"""``torquerig study`` killed with -9, or on a full disk, goes on to the rows of a study that nothing disturbed."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.cases.test_killed import wait_until
from tests.cases.test_running import bytes_of
from torquerig.cases import read_rows
from torquerig.catalog.shipped import shipped_scenarios

ROOT = Path(__file__).resolve().parents[2]
DRAWS = 96
# blocks of a case each and a part for each, so that a study of seconds has many moments to be killed at
COMMAND = """
import sys
from torquerig.cases import running
from torquerig.cli import main
from torquerig.study.monte_carlo import running as draws
running.run_cases.__kwdefaults__["save_every"] = 0.0
draws.LARGEST_BLOCK = 4
main(sys.argv[1:])
"""
EDITS = (
    "study.motors=[bldc-12n14p]", "study.gearboxes=[reference-5-1]", "study.duration=0.2 s",
    "study.filters.names=[none, low_pass_20Hz]", "study.present.filter=none",
)  # fmt: skip
pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows has neither kill -9 nor limits of the shell")


def arguments(store: Path) -> list[str]:
    """Return the command line of a study of one drive."""
    given = ["study", str(shipped_scenarios() / "wear_rig.yaml"), "--draws", str(DRAWS), "--store", str(store)]
    return [*given, "--workers", "2", *(word for edit in EDITS for word in ("--set", edit))]


def started(store: Path) -> subprocess.Popen[bytes]:
    """Start the command as a process of its own."""
    return subprocess.Popen(
        [sys.executable, "-c", COMMAND, *arguments(store)], cwd=ROOT, start_new_session=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The store of a study that nothing disturbed."""
    store = tmp_path_factory.mktemp("study") / "whole"
    assert started(store).wait() == 0
    return store


def _parts(store: Path) -> int:
    return len(list((store / "rows").glob("part*")))


@pytest.mark.long
def test_a_killed_study_goes_on_to_the_same_bytes(tmp_path: Path, whole: Path) -> None:
    store, moments, killed = tmp_path / "killed", random.Random(5), 0
    for _ in range(3):
        study, before = started(store), _parts(store)
        wait_until(lambda study=study, before=before: study.poll() is not None or _parts(store) > before)
        time.sleep(moments.uniform(0.0, 0.2))
        study.kill()
        killed += study.wait() == -signal.SIGKILL
    assert killed > 0
    rows = read_rows(store)
    assert 0 < len(rows) < DRAWS
    assert started(store).wait() == 0
    assert bytes_of(store) == bytes_of(whole)
    assert sorted(read_rows(store)["draw"]) == list(range(DRAWS))


@pytest.mark.long
def test_a_full_disk_is_one_sentence_and_the_study_goes_on(tmp_path: Path, whole: Path) -> None:
    store = tmp_path / "full"
    limited = ["/bin/bash", "-c", 'ulimit -f 4; exec "$@"', "-", sys.executable, "-c", COMMAND, *arguments(store)]
    ended = subprocess.run(limited, cwd=ROOT, check=False, capture_output=True, text=True)
    assert ended.returncode == 2
    sentences = [line for line in ended.stderr.splitlines() if line.startswith("torquerig:")]
    assert len(sentences) == 1
    assert "free space" in sentences[0]
    assert "Traceback" not in ended.stderr
    assert started(store).wait() == 0
    assert bytes_of(store) == bytes_of(whole)
