"""A study on a Dask scheduler with two workers of this machine has the same rows, also when one is killed."""

from __future__ import annotations

import json
import os
import random
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from tests.cases import work_functions as work
from tests.cases.test_answers import all_of
from tests.cases.test_running import bytes_of, run
from torquerig.cases import Cluster, Limits, ThisProcess, read_rows
from torquerig.errors import InputError

distributed = pytest.importorskip("distributed", reason="Dask is not installed")
ROOT = Path(__file__).resolve().parents[2]
pytestmark = [pytest.mark.long, pytest.mark.filterwarnings("ignore")]  # libraries of the cluster warn of each other


@contextmanager
def dask(*arguments: str) -> Iterator[subprocess.Popen[bytes]]:
    """Run a command of Dask as a process of its own."""
    command = [sys.executable, "-m", "dask", *arguments, "--host", "127.0.0.1", "--no-dashboard"]
    place = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "src")])}
    process = subprocess.Popen(
        command, cwd=ROOT, env=place, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
    )
    try:
        yield process
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


@contextmanager
def scheduler(folder: Path) -> Iterator[str]:
    """Run a scheduler and yield its address."""
    file = folder / "scheduler.json"
    with dask("scheduler", "--port", "0", "--scheduler-file", str(file)):
        while not file.exists() or not file.read_text():
            time.sleep(0.05)
        yield str(json.loads(file.read_text())["address"])


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Return the address of a scheduler with two workers of one thread."""
    folder = tmp_path_factory.mktemp("dask")
    with scheduler(folder) as at, ExitStack() as workers:
        for number in range(2):
            local = str(folder / f"worker {number}")
            workers.enter_context(dask("worker", at, "--nthreads", "1", "--local-directory", local))
        yield at


def test_a_study_on_a_cluster_has_the_same_bytes(address: str, tmp_path: Path) -> None:
    there = run(tmp_path / "there", 60, engine=Cluster(address))
    run(tmp_path / "here", 60)
    assert (there.computed, there.failed, there.unfinished) == (60, 0, 0)
    assert bytes_of(tmp_path / "there") == bytes_of(tmp_path / "here")


def test_inputs_travel_to_each_worker_once(address: str, tmp_path: Path) -> None:
    all_of(work.with_counted, work.Counted(tmp_path), work.cases(40), engine=Cluster(address), block_size=1)
    assert len(list(tmp_path.iterdir())) == 2


def test_a_worker_that_is_killed_costs_no_case(address: str, tmp_path: Path) -> None:
    (tmp_path / "marks").mkdir()
    ended, killed = threading.Event(), []

    def killer() -> None:
        with distributed.Client(address, set_as_default=False) as client:
            client.wait_for_workers(2)
            workers = client.run(os.getpid)
            while not list((tmp_path / "marks").iterdir()):
                time.sleep(0.02)
            time.sleep(random.Random(1).uniform(0.0, 0.5))
            os.kill(next(iter(workers.values())), signal.SIGKILL)
            killed.append(not ended.is_set())

    thread = threading.Thread(target=killer)
    thread.start()
    named: dict[str, Any] = {"function": work.signed_reading, "inputs": str(tmp_path / "marks")}
    there = run(tmp_path / "there", 600, engine=Cluster(address), block_size=4, **named)
    ended.set()
    thread.join()
    run(tmp_path / "here", 600)
    assert killed == [True]
    assert there.computed == 600
    assert bytes_of(tmp_path / "there") == bytes_of(tmp_path / "here")


def test_cases_that_never_end_or_kill_are_given_up_there_too(address: str) -> None:
    limits = Limits(seconds=0.5, tries=1, compiling=0.0)
    found = all_of(work.endless_at_3, 2.0, work.cases(8), engine=Cluster(address), block_size=4, limits=limits)
    assert {n: one.error for n, one in found.items() if one.state == "unfinished"} == {
        3: "given up after 1 tries: it took longer than 0.5 s"
    }
    found = all_of(work.deadly_at_2, 2.0, work.cases(8), engine=Cluster(address), block_size=4, limits=limits)
    assert [n for n, one in found.items() if one.state == "unfinished"] == [2]


def test_inputs_that_a_worker_cannot_load_are_one_sentence_there_too(address: str) -> None:
    with pytest.raises(InputError, match="a worker cannot load the work function or its inputs: OSError: lost"):
        all_of(work.reading, work.Unloadable(), work.cases(1), engine=Cluster(address))


def test_workers_of_other_versions_are_refused(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from torquerig.cases import cluster, identity

    other = {**identity.code_here(), "numpy": "1.0"}
    monkeypatch.setattr(cluster, "code_here", _Mine(other))
    with pytest.raises(
        InputError, match=r"the (worker|scheduler) at tcp://.* has numpy 2\..*, and here is 1.0; install the same"
    ):
        all_of(work.reading, 2.0, work.cases(1), engine=Cluster(address))


def test_a_cluster_without_the_study_is_one_sentence(address: str) -> None:
    with pytest.raises(InputError, match="a worker cannot load the work function or its inputs: ModuleNotFoundError"):
        all_of(work.reading, work.OnlyHere(), work.cases(9), engine=Cluster(address))


class _Mine:
    """Other versions here, the true ones where it is sent to."""

    def __init__(self, code: dict[str, str]) -> None:
        self.code = code

    def __call__(self) -> dict[str, str]:
        return self.code

    def __reduce__(self) -> Any:
        return _truth, ()


def _truth() -> Any:
    from torquerig.cases.identity import code_here

    return code_here


@pytest.fixture(params=["closed", "mute", "ssh"])
def other_server(request: pytest.FixtureRequest) -> Iterator[str]:
    """Return the address of what is no scheduler: nothing, a server that says nothing, one that says something else."""

    def greet() -> None:
        with suppress(OSError):
            while True:
                caller, _ = server.accept()
                callers.append(caller)
                if request.param == "ssh":
                    caller.sendall(b"SSH-2.0-OpenSSH_9.6\r\n")

    callers: list[socket.socket] = []
    with ExitStack() as open_sockets:
        server = open_sockets.enter_context(socket.create_server(("127.0.0.1", 0)))
        place = f"tcp://127.0.0.1:{server.getsockname()[1]}"
        if request.param == "closed":
            server.close()
        else:
            threading.Thread(target=greet, daemon=True).start()
        yield place
        server.close()
        for caller in callers:
            caller.close()


def test_an_address_that_does_not_answer_is_one_sentence(other_server: str, tmp_path: Path) -> None:
    start = time.monotonic()
    with pytest.raises(InputError, match=r"no scheduler answers at 'tcp://.*' within 1 s; give the address"):
        run(tmp_path / "store", engine=Cluster(other_server, patience=1.0))
    assert time.monotonic() - start < 8  # with the import of Dask, on a busy machine
    assert run(tmp_path / "store").computed == 20


@pytest.mark.parametrize("wrong", ["nowhere", "tcp://127.0.0.1:port", "http:/x", ""])
def test_what_is_no_address_is_one_sentence(wrong: str) -> None:
    with pytest.raises(InputError, match=f"no scheduler answers at '{wrong}' within 30 s; give the address"):
        all_of(work.reading, 2.0, work.cases(1), engine=Cluster(wrong))


def test_a_scheduler_without_workers_is_one_sentence(tmp_path: Path) -> None:
    with (
        scheduler(tmp_path) as at,
        pytest.raises(InputError, match="had no worker within 3 s; start some with: dask"),
    ):
        all_of(work.reading, 2.0, work.cases(1), engine=Cluster(at, patience=3.0))


def test_a_scheduler_that_is_gone_costs_only_what_was_not_stored(tmp_path: Path) -> None:
    with ExitStack() as all_gone:
        at = all_gone.enter_context(scheduler(tmp_path))
        all_gone.enter_context(dask("worker", at, "--nthreads", "1", "--local-directory", str(tmp_path / "worker")))
        seen: list[int] = []

        def gone(progress: Any) -> None:
            seen.append(progress.done)
            if len(seen) == 24:
                all_gone.close()

        with pytest.raises(
            InputError, match=r"the scheduler at .* is gone.*; start it again, and then the same command"
        ):
            run(tmp_path / "store", 200, engine=Cluster(at, patience=5.0), save_every=0.0, progress=gone)
    assert 24 <= len(read_rows(tmp_path / "store")) < 200
    run(tmp_path / "store", 200, engine=ThisProcess())
    run(tmp_path / "whole", 200)
    assert bytes_of(tmp_path / "store") == bytes_of(tmp_path / "whole")
