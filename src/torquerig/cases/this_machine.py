"""Work in processes of this machine, which may die or be ended without harm to the study."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from multiprocessing.connection import wait
from typing import Any

from torquerig.cases.block import Block, Outcome
from torquerig.cases.case import Work
from torquerig.cases.limits import Limits
from torquerig.cases.worker import Worker, packed, started_worker
from torquerig.errors import InputError

LONGEST_WAIT = 1.0  # s, between looks at whether a process that keeps its pipe open is still alive
DEAD_STARTS = 3  # workers in a row that die before they have their inputs: then there is memory for fewer only


@dataclass(frozen=True)
class ThisMachine:
    """The engine for studies on one machine.

    Parameters
    ----------
    workers : int, optional
        Processes, each with one thread; one for each processor that this process may use when not given.

    Raises
    ------
    InputError
        For less than one worker.
    """

    workers: int | None = None

    def __post_init__(self) -> None:
        if self.workers is not None and self.workers < 1:
            raise InputError(f"{self.workers} workers do nothing; give 1 or more")

    @contextmanager
    def started(self, work: Work, inputs: Any, *, limits: Limits) -> Iterator[ProcessPool]:
        """Yield a pool of worker processes; they are ended with the context."""
        pool = ProcessPool(packed(work, inputs), limits)
        try:
            for _ in range(self.workers or _processors()):
                pool.start_one()
            yield pool
        finally:
            pool.end()


@dataclass
class ProcessPool:
    """Worker processes with the same work function and inputs, each with one block at a time."""

    content: bytes
    limits: Limits
    idle: float | None = None  # s without a block after which a worker ends
    workers: list[Worker] = field(default_factory=list)
    dead_starts: int = 0
    has_compiled: bool = False

    def start_one(self) -> None:
        """Start one more worker."""
        self.workers.append(started_worker(self.content, idle=self.idle))

    def end(self) -> None:
        """End all workers at once."""
        while self.workers:
            self.workers.pop().end()

    def room(self) -> int:
        """Return how many workers wait for a block."""
        return sum(worker.is_ready and worker.block is None for worker in self.workers)

    def submit(self, block: Block, /) -> None:
        """Give a block to a worker that waits for one."""
        free = next(worker for worker in self.workers if worker.is_ready and worker.block is None)
        free.submit(block, seconds=self.limits.of_block(len(block.cases), has_compiled=self.has_compiled))

    def finished(self) -> list[Outcome]:
        """Wait until there is room or an outcome, and return the outcomes.

        Raises
        ------
        InputError
            When workers cannot load the work function and its inputs, or die while they do.
        """
        nearest = min(worker.deadline for worker in self.workers) - time.monotonic()
        news = wait([worker.connection for worker in self.workers], max(0.0, min(nearest, LONGEST_WAIT)))
        found = [self._news(worker, has_spoken=worker.connection in news) for worker in tuple(self.workers)]
        return [outcome for outcome in found if outcome is not None]

    def _news(self, worker: Worker, *, has_spoken: bool) -> Outcome | None:
        """Return what became of a worker's block; a worker that is dead or too late is replaced."""
        if has_spoken:
            try:
                outcome = worker.heard()
            except EOFError:
                return self._replaced(worker, _death_of(worker))
            self.dead_starts *= not worker.is_ready
            self.has_compiled = self.has_compiled or outcome is not None
            return outcome
        if time.monotonic() > worker.deadline and worker.block is not None:
            return self._replaced(worker, f"it took longer than {worker.seconds:g} s")
        if not worker.process.is_alive():
            return self._replaced(worker, _death_of(worker))
        return None

    def _replaced(self, worker: Worker, error: str) -> Outcome | None:
        """Start another worker in place of one, but where new ones die at once; the others go on then."""
        self.workers.remove(worker)
        worker.end()
        self.dead_starts += not worker.is_ready
        if self.dead_starts < DEAD_STARTS:
            self.start_one()
        elif not self.workers:
            raise InputError(
                f"worker processes end before they have their inputs ({error}); free memory or use fewer workers, "
                "and in a script call this below: if __name__ == '__main__'"
            )
        return None if worker.block is None else Outcome(worker.block, "lost", error=error)


def _death_of(worker: Worker) -> str:
    worker.process.join(LONGEST_WAIT)
    code = worker.process.exitcode
    how = f"by signal {-code}" if code is not None and code < 0 else f"with exit code {code}"
    return f"the worker process ended {how}; memory may have run out"


def _processors() -> int:
    """Return how many processors this process may use, where the system says."""
    allowed = getattr(os, "sched_getaffinity", None)
    return len(allowed(0)) if allowed else os.cpu_count() or 1
