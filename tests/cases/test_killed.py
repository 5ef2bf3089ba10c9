"""A study that is killed with -9 at any moment goes on, and a worker that is killed is replaced."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from tests.cases import work_functions as work
from tests.cases.test_answers import all_of
from tests.cases.test_running import bytes_of, run
from torquerig.cases import ThisMachine, ThisProcess, read_rows

ROOT = Path(__file__).resolve().parents[2]
CASES = 160
STUDY = f"""
import sys
from pathlib import Path
from tests.cases import work_functions as work
from torquerig.cases import ThisMachine, run_cases, running
running.MERGE_FROM = 10  # so that some moments are in a merge
run_cases(work.signed_reading, sys.argv[2], work.cases({CASES}), folder=Path(sys.argv[1]), identity=work.identity(),
          engine=ThisMachine(2), block_size=4, save_every=0.0)
"""
pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows has no kill -9")


def started(folder: Path, marks: Path) -> subprocess.Popen[bytes]:
    """Start the study as a process of its own; its workers leave their process numbers in ``marks``."""
    marks.mkdir(exist_ok=True)
    return subprocess.Popen([sys.executable, "-c", STUDY, str(folder), str(marks)], cwd=ROOT, start_new_session=True)


def wait_until(seen: object, seconds: float = 60.0) -> None:
    """Wait until a function returns something true."""
    end = time.monotonic() + seconds
    while not seen():  # type: ignore[operator]
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.005)


def is_running(process: int) -> bool:
    """Whether a process runs; one that has ended and is not yet collected does not."""
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    status = Path(f"/proc/{process}/stat")
    return not status.exists() or status.read_text().rpartition(")")[2].split()[0] != "Z"


def killed_study(folder: Path, marks: Path, *, kills: int, seed: int) -> int:
    """Kill the study again and again at random moments, then let it end; return how often it was."""
    moments, count = random.Random(seed), 0
    for _ in range(kills):
        study = started(folder, marks)
        before = _parts(folder)
        wait_until(lambda study=study, before=before: study.poll() is not None or _parts(folder) != before)
        time.sleep(moments.uniform(0.0, 0.25))
        study.kill()
        count += study.wait() == -signal.SIGKILL
        wait_until(lambda: not any(is_running(int(mark.name)) for mark in marks.iterdir()), 10.0)
        for mark in marks.iterdir():
            mark.unlink()
    assert started(folder, marks).wait() == 0
    return count


def _parts(folder: Path) -> int:
    return len(list((folder / "rows").glob("part*")))


@pytest.mark.long
def test_a_study_killed_at_three_moments_has_the_same_bytes(tmp_path: Path) -> None:
    assert killed_study(tmp_path / "killed", tmp_path / "marks", kills=3, seed=1) > 0
    run(tmp_path / "whole", CASES, engine=ThisProcess())
    assert bytes_of(tmp_path / "killed") == bytes_of(tmp_path / "whole")


@pytest.mark.full
def test_a_study_killed_at_twenty_moments_has_the_same_bytes(tmp_path: Path) -> None:
    run(tmp_path / "whole", CASES, engine=ThisProcess())
    killed = 0
    for seed in range(7):  # a study is complete after some kills
        killed += killed_study(tmp_path / f"killed {seed}", tmp_path / "marks", kills=4, seed=seed)
        assert bytes_of(tmp_path / f"killed {seed}") == bytes_of(tmp_path / "whole")
    assert killed >= 20


@pytest.mark.long
def test_workers_end_with_a_parent_that_is_killed(tmp_path: Path) -> None:
    study = started(tmp_path / "store", tmp_path / "marks")
    wait_until(lambda: len(list((tmp_path / "marks").iterdir())) == 2)
    workers = [int(mark.name) for mark in (tmp_path / "marks").iterdir()]
    study.kill()
    study.wait()
    wait_until(lambda: not any(map(is_running, workers)), 10.0)


@pytest.mark.long
def test_ctrl_c_ends_workers_and_keeps_what_was_done(tmp_path: Path) -> None:
    study = started(tmp_path / "store", tmp_path / "marks")
    wait_until(lambda: _parts(tmp_path / "store") > 2)
    os.killpg(study.pid, signal.SIGINT)  # as a terminal does: to the workers too
    assert study.wait() != 0
    workers = [int(mark.name) for mark in (tmp_path / "marks").iterdir()]
    assert not any(map(is_running, workers))
    assert 0 < len(read_rows(tmp_path / "store")) < CASES


@pytest.mark.long
def test_workers_killed_at_random_cost_no_case(tmp_path: Path) -> None:
    moments, ended = random.Random(2), threading.Event()
    killed: list[Path] = []

    def killer() -> None:
        while len(killed) < 4 and not ended.wait(moments.uniform(0.05, 0.2)):
            for mark in sorted(tmp_path.iterdir())[:1]:
                os.kill(int(mark.name), signal.SIGKILL)
                killed.append(mark)
                mark.unlink()

    thread = threading.Thread(target=killer)
    thread.start()
    try:
        found = all_of(work.signed_reading, str(tmp_path), work.cases(600), engine=ThisMachine(2), block_size=4)
    finally:
        ended.set()
        thread.join()
    here = all_of(work.reading, 2.0, work.cases(600), engine=ThisProcess())
    assert killed
    assert {n: one.value for n, one in found.items()} == {n: one.value for n, one in here.items()}
