"""A store that is killed with -9 at any step on the disk has every row that it called saved, once."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cases import work_functions as work
from tests.cases.test_running import bytes_of
from tests.cases.test_store import rows_of
from torquerig.cases import read_rows
from torquerig.cases.store import opened_store

ROOT = Path(__file__).resolve().parents[2]
BLOCKS = 5
STUDY = """
import os, shutil, signal, sys
from pathlib import Path
from tests.cases import work_functions as work
from tests.cases.test_store import rows_of
from torquerig.cases.store import opened_store

steps = 0

def deadly(step):
    def counted(*arguments, **named):
        global steps
        steps += 1
        if steps == int(sys.argv[2]):
            os.kill(os.getpid(), signal.SIGKILL)
        return step(*arguments, **named)
    return counted

for place, names in {os: ("fsync",), shutil: ("rmtree",), Path: ("replace", "unlink", "mkdir")}.items():
    for name in names:
        setattr(place, name, deadly(getattr(place, name)))
with opened_store(Path(sys.argv[1]), work.identity()) as store:
    for block in range(5):
        store.save(rows_of(range(4 * block, 4 * block + 4)))
        print(4 * block + 4, flush=True)
        if block in (2, 4):
            store.merge()
"""
pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows has no kill -9")


def killed_at(step: int, folder: Path) -> bool:
    """Kill a study at a step, check what is there, and complete it; return whether it had so many steps."""
    command = [sys.executable, "-c", STUDY, str(folder), str(step)]
    ended = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert ended.returncode in {0, -signal.SIGKILL}, ended.stderr
    saved = int((ended.stdout.split() or ["0"])[-1])
    with opened_store(folder, work.identity()) as store:
        there = sorted(store.states)
        assert there in (list(range(saved)), list(range(saved + 4)))
        assert store.notes == []
        store.save(rows_of(range(len(there), 4 * BLOCKS)))
        store.merge()
    assert read_rows(folder)["case"].tolist() == list(range(4 * BLOCKS))
    assert sorted(path.name for path in folder.iterdir()) == [".lock", "rows", "study.json"]
    return ended.returncode != 0


@pytest.mark.long
@pytest.mark.parametrize("step", [2, 12, 25, 33])
def test_a_store_killed_at_a_step_loses_nothing(step: int, tmp_path: Path) -> None:
    assert killed_at(step, tmp_path / "killed")
    assert not killed_at(0, tmp_path / "whole")
    assert bytes_of(tmp_path / "killed") == bytes_of(tmp_path / "whole")


@pytest.mark.full
def test_a_store_killed_at_any_step_loses_nothing(tmp_path: Path) -> None:
    killed_at(0, tmp_path / "whole")
    steps = 1
    while killed_at(steps, tmp_path / str(steps)):
        assert bytes_of(tmp_path / str(steps)) == bytes_of(tmp_path / "whole")
        steps += 1
    assert steps > 33
