"""A process that works on one block after the other, and the handle that its parent has of it.

Each has a separate pipe and no lock with anyone, so that it can be killed at any moment without harm to others.
"""

from __future__ import annotations

import os
import pickle
import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any

from torquerig.cases.block import Block, Outcome, sentence_of, worked_on
from torquerig.cases.case import Work
from torquerig.cases.limits import ONE_THREAD, environment
from torquerig.errors import InputError

ASKS, READY = "asks for the inputs", "ready"


@dataclass
class Worker:
    """A running worker process: what it works on, until when, and whether it has got the inputs."""

    process: BaseProcess
    connection: Connection
    content: bytes
    is_ready: bool = False
    block: Block | None = None
    seconds: float | None = None
    deadline: float = float("inf")

    def submit(self, block: Block, *, seconds: float | None) -> None:
        """Give the worker a block, for which it has so many seconds [s]; a dead one is noticed by :meth:`heard`."""
        self.block, self.seconds = block, seconds
        self.deadline = float("inf") if seconds is None else time.monotonic() + seconds
        with suppress(OSError):
            self.connection.send(block)

    def heard(self) -> Outcome | None:
        """Return what became of the block, or None for a message of the worker's start; call it when there is news.

        Raises
        ------
        EOFError
            When the worker is dead.
        InputError
            When it cannot load the work function or the inputs.
        """
        try:
            message = self.connection.recv()
            if message == ASKS:
                self.connection.send_bytes(self.content)
                return None
        except OSError as error:
            raise EOFError from error
        if message == READY:
            self.is_ready = True
            return None
        if isinstance(message, tuple) and self.block is not None:
            block, self.block, self.deadline = self.block, None, float("inf")
            return Outcome(block, *message)
        raise InputError(f"a worker cannot load the work function or its inputs: {message}")

    def end(self) -> None:
        """End the process at once, whatever it does."""
        self.process.kill()
        self.process.join()
        self.connection.close()


def packed(work: Work, inputs: Any) -> bytes:
    """Return the work function and the inputs as bytes, once for all workers.

    Raises
    ------
    InputError
        For a function that other processes cannot import, or inputs that cannot be sent.
    """
    try:
        return pickle.dumps((work, inputs), protocol=5)
    except Exception as error:
        name = getattr(work, "__qualname__", repr(work))
        raise InputError(
            f"{name} and its inputs cannot be sent to worker processes ({sentence_of(error)}); define the function at "
            "the top level of a module, and give inputs that can be pickled"
        ) from error


def started_worker(content: bytes, *, idle: float | None = None) -> Worker:
    """Start a worker process, which will ask for ``content``, the :func:`packed` work function and inputs.

    It ends after ``idle`` seconds [s] without a block.
    """
    here, there = get_context("spawn").Pipe()
    process = get_context("spawn").Process(target=_serve, args=(there, idle), name="torquerig-cases", daemon=True)
    with environment(ONE_THREAD), _no_interrupts():
        process.start()
    there.close()  # so that the end of the process is the end of the pipe
    return Worker(process, here, content)


def _serve(connection: Connection, idle: float | None) -> None:
    """Work on blocks until the parent closes the pipe or ends, or gives none for so long."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's affair
    threading.Thread(target=_end_with_parent, daemon=True).start()
    with suppress(EOFError, OSError):
        try:
            connection.send(ASKS)
            content = connection.recv_bytes()
            work, inputs = pickle.loads(content)  # noqa: S301 (from the parent process)
            del content
            _use_one_thread()
        except Exception as error:
            connection.send(sentence_of(error))
            return
        connection.send(READY)
        while connection.poll(idle):
            outcome = worked_on(connection.recv(), work, inputs)
            connection.send_bytes(_message(outcome))


def _message(outcome: Outcome) -> bytes:
    try:
        return pickle.dumps((outcome.kind, outcome.answers, outcome.error, outcome.seconds), protocol=5)
    except Exception as error:
        return pickle.dumps(("raised", (), f"the answers cannot be sent: {sentence_of(error)}", outcome.seconds))


def _end_with_parent() -> None:
    """End this process when the one that started it has ended, even by kill -9 and while a block is worked on."""
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _use_one_thread() -> None:
    """Limit libraries that were loaded before their variables were read."""
    from threadpoolctl import threadpool_limits

    threadpool_limits(limits=1)


@contextmanager
def _no_interrupts() -> Iterator[None]:
    """Start processes that Ctrl-C does not reach, from their first instruction on."""
    if os.name == "nt":
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
