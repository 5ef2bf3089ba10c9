"""A piece of long work that runs in a separate process."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Literal

State = Literal["running", "done", "failed", "cancelled"]
PATIENCE = 3.0  # [s] for a process to end by itself before it is ended by force
STEP = 0.05  # [s] between two looks at a process
MINUTE = 120.0  # [s] from here on the remaining time is in minutes


@dataclass(frozen=True)
class Progress:
    """How far a job is.

    Parameters
    ----------
    stage : str
        What it does now.
    done, total : int
        Steps; ``total`` is 0 where the work knows no number.
    remaining : float or None
        [s] at the mean pace so far; None where it is not known.
    """

    stage: str = ""
    done: int = 0
    total: int = 0
    remaining: float | None = None

    def text(self) -> str:
        """Return it as one line: ``3 of 12, some 40 s remain: HDS6A``."""
        count = f"{self.done} of {self.total}" if self.total else ""
        left = ""
        if self.remaining is not None:
            long = self.remaining >= MINUTE
            left = f"some {self.remaining / 60:.0f} min remain" if long else f"some {self.remaining:.0f} s remain"
        head = ", ".join(one for one in (count, left) if one)
        return f"{head}: {self.stage}" if head and self.stage else head or self.stage


@dataclass
class Job:
    """Work in a process: ``state`` and ``progress`` may be read at any time, from any thread.

    Parameters
    ----------
    state : str
        ``running``, ``done``, ``failed`` or ``cancelled``.
    progress : Progress
    result : object
        What the function returned, once it is done.
    sentence : str
        Why it failed, or that it was cancelled.
    """

    process: subprocess.Popen[bytes] = field(repr=False)
    state: State = "running"
    progress: Progress = field(default_factory=Progress)
    result: Any = None
    sentence: str = ""
    started: float = field(default_factory=time.monotonic)
    _counted_from: tuple[float, int] | None = field(default=None, repr=False)
    _lock: threading.Lock = field(default_factory=threading.Lock, repr=False)

    @property
    def is_running(self) -> bool:
        """Whether it has not ended yet."""
        return self.state == "running"

    def cancel(self) -> None:
        """End the work and the processes that it started; nothing where it has ended."""
        with self._lock:
            if self.state != "running":
                return
            self.state, self.sentence = "cancelled", "cancelled"
        _end(self.process)

    def wait(self, seconds: float) -> bool:
        """Wait for the end, at most so long [s]; return whether it has ended."""
        end = time.monotonic() + seconds
        while self.is_running and time.monotonic() < end:
            time.sleep(STEP)
        return not self.is_running

    def _listen(self) -> None:
        assert self.process.stdout is not None
        with suppress(EOFError, pickle.UnpicklingError, OSError):
            while True:
                kind, content = pickle.load(self.process.stdout)  # noqa: S301 (from the process that was started)
                if kind == "progress":
                    self._count(content)
                else:
                    self._ended(kind, content)

    def _watch(self) -> None:
        """Listen until the process ends, and end what it has left running; a result that is under way still counts."""
        listener = threading.Thread(target=self._listen, daemon=True)
        listener.start()
        code = self.process.wait()
        _signal(self.process, "SIGKILL")
        listener.join(PATIENCE)  # a worker that was left running may hold the pipe open
        self._ended("failed", f"the process of this work ended unexpectedly ({_reason(code)}); start it again")
        _close(self.process)
        if not listener.is_alive() and self.process.stdout is not None:
            self.process.stdout.close()

    def _ended(self, kind: State, content: Any) -> None:
        with self._lock:
            if self.state != "running":
                return
            if kind == "done":
                self.result = content
            else:
                self.sentence = str(content)
            self.state = kind

    def _count(self, what: Mapping[str, Any]) -> None:
        now, done, total = time.monotonic(), int(what.get("done", 0)), int(what.get("total", 0))
        if self._counted_from is None or done < self._counted_from[1]:
            self._counted_from = (now, done)  # what was stored before took no time
        begin, before = self._counted_from
        made = done - before
        remaining = (now - begin) / made * (total - done) if made > 0 and total > done else None
        stage = str(what.get("stage", what.get("name", self.progress.stage)))
        self.progress = Progress(stage, done, total, remaining)


def start(function: Callable[..., Any], *arguments: Any) -> Job:
    """Start ``function(*arguments, report)`` in a separate process, and return the running job.

    Parameters
    ----------
    function : callable
        At the top level of a module.
    arguments : objects
        That can be pickled.
    """
    # the interpreter of this process runs a module of this package
    process = subprocess.Popen(
        [sys.executable, "-m", "torquerig.studio.jobs.child"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=os.name != "nt",
    )  # fmt: skip
    assert process.stdin is not None
    with suppress(BrokenPipeError):  # it ended at once; the listener states it
        pickle.dump((function.__module__, function.__qualname__, arguments), process.stdin)
        process.stdin.flush()
    job = Job(process)
    threading.Thread(target=job._watch, daemon=True).start()
    return job


def _end(process: subprocess.Popen[bytes]) -> None:
    _signal(process, "SIGTERM")
    try:
        process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        _signal(process, "SIGKILL")
        process.wait()
    _close(process)


def _signal(process: subprocess.Popen[bytes], name: str) -> None:
    with suppress(ProcessLookupError, PermissionError):
        if os.name == "nt":
            process.kill()
        else:
            os.killpg(process.pid, getattr(signal, name))


def _close(process: subprocess.Popen[bytes]) -> None:
    if process.stdin is not None:
        with suppress(OSError):
            process.stdin.close()


def _reason(code: int) -> str:
    if code >= 0:
        return f"exit code {code}"
    return f"signal {-code}" + (", as a machine without free memory sends it" if -code == 9 else "")
