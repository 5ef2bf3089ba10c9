"""How a studio ends: by Ctrl-C without a word, and killed without leaving its computing process behind."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="looks up processes in /proc"),
]
LONGEST = 30.0  # [s] on a busy machine


@pytest.fixture
def studio(tmp_path):
    pytest.importorskip("nicegui")
    command = [sys.executable, "-m", "torquerig", "studio", str(tmp_path), "--no-browser"]
    env = {name: one for name, one in os.environ.items() if not name.startswith("PYTEST")} | {"PYTHONUNBUFFERED": "1"}
    started = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env)
    assert "http://127.0.0.1:" in started.stdout.readline()
    yield started
    started.kill()
    started.wait()
    started.stdout.close()
    started.stderr.close()


def children(process):
    return Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()


def all_gone(pids):
    end = time.monotonic() + LONGEST
    while time.monotonic() < end:
        if not any(Path(f"/proc/{one}").exists() for one in pids):
            return True
        time.sleep(0.1)
    return False


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["Ctrl-C", "SIGTERM"])
def test_a_signal_ends_it_without_an_error(studio, number):
    begun = children(studio)
    assert begun
    studio.send_signal(number)
    assert studio.wait(LONGEST) == 0
    assert studio.stderr.read() == ""
    assert all_gone(begun)


def test_nothing_is_left_of_a_studio_that_was_killed(studio):
    begun = children(studio)
    studio.kill()
    assert all_gone(begun)
