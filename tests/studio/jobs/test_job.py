"""Long work in a separate process: progress, result, faults as sentences, and an end that leaves nothing running."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from torquerig.studio.jobs import job as jobs
from torquerig.studio.jobs.job import Progress, start

TIME = 60.0  # [s] a start of Python on a busy machine


@pytest.fixture(autouse=True)
def importable(monkeypatch):
    """The functions of this file are imported in the process of the job."""
    here = str(Path(__file__).parent)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([here, *filter(None, [os.environ.get("PYTHONPATH")])]))
    monkeypatch.syspath_prepend(here)


def started(name, *arguments):
    function = getattr(__import__("job_functions"), name)
    return start(function, *arguments)


def test_progress_and_result_arrive():
    job = started("counted", 3)
    assert job.wait(TIME)
    assert (job.state, job.result) == ("done", [0, 1, 2])
    assert (job.progress.done, job.progress.total, job.progress.stage) == (3, 3, "step 3")


def test_an_error_is_its_sentence_and_a_fault_is_one_too(capfd):
    wrong = started("refused")
    assert wrong.wait(TIME)
    assert (wrong.state, wrong.sentence) == ("failed", "run.csv: has no torque; name one")
    broken = started("broken")
    assert broken.wait(TIME)
    assert "KeyError" in broken.sentence
    assert "fault of torquerig" in broken.sentence
    assert "Traceback" not in broken.sentence
    ended = started("ended")
    assert ended.wait(TIME)
    assert "exit code 3" in ended.sentence


@pytest.mark.skipif(os.name == "nt", reason="process groups are those of POSIX")
def test_cancel_ends_the_work_and_what_it_started(tmp_path):
    job = started("with_a_child", str(tmp_path / "pid"))
    while not (tmp_path / "pid").exists() and job.is_running:
        time.sleep(0.05)
    child = int((tmp_path / "pid").read_text())
    job.cancel()
    assert job.state == "cancelled"
    assert job.process.poll() is not None
    assert gone(child)
    job.cancel()  # nothing happens


@pytest.mark.skipif(os.name == "nt", reason="process groups are those of POSIX")
def test_the_work_ends_when_the_studio_dies(tmp_path):
    text = (
        "import job_functions, sys, time; from torquerig.studio.jobs.job import start; "
        "start(job_functions.with_a_child, sys.argv[1]); time.sleep(600)"
    )
    studio = subprocess.Popen([sys.executable, "-c", text, str(tmp_path / "pid")])
    while not (tmp_path / "pid").exists():
        assert studio.poll() is None
        time.sleep(0.05)
    studio.kill()
    studio.wait()
    assert gone(int((tmp_path / "pid").read_text()))


def gone(process):
    for _ in range(200):
        state = Path(f"/proc/{process}/stat")
        if not state.exists() or state.read_text().rpartition(")")[2].split()[0] == "Z":
            return True
        time.sleep(0.05)
    return False


@pytest.mark.skipif(os.name == "nt", reason="Windows does not fork")
def test_work_may_fork_and_what_it_leaves_running_is_not_waited_for():
    job = started("with_forked_workers")
    assert job.wait(TIME)
    assert job.result == [1, 2]
    killed = started("killed_with_a_forked_worker")
    assert killed.wait(TIME)
    assert "signal 9" in killed.sentence
    killed.process.stdout.close()


def test_the_remaining_time_leaves_out_what_was_stored(monkeypatch):
    times = iter([0.0, 10.0, 20.0, 30.0])
    monkeypatch.setattr(jobs.time, "monotonic", lambda: next(times))
    job = jobs.Job(None)
    job._count({"done": 5, "total": 10, "name": ""})
    assert job.progress.remaining is None
    job._count({"done": 6, "total": 10, "name": "a"})
    assert job.progress.remaining == 40.0  # one drive took 10 s, four remain
    assert Progress("a", 6, 10, 40.0).text() == "6 of 10, some 40 s remain: a"
    assert Progress("a", 6, 10, 240.0).text() == "6 of 10, some 4 min remain: a"
    assert Progress("fitting").text() == "fitting"
