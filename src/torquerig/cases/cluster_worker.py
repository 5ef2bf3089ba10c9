"""What runs on a cluster: in each Dask worker a plugin with a worker process for each of its threads.

The work itself is in further processes, as on one machine, so that a case that dies or never ends is found there,
and compiled code cannot keep Dask from answering its scheduler.
"""

from __future__ import annotations

import multiprocessing
import queue
from collections.abc import Mapping, Sequence
from typing import Any

from distributed import Worker, get_worker
from distributed.diagnostics.plugin import WorkerPlugin

from torquerig.cases.block import Block
from torquerig.cases.identity import code_here
from torquerig.cases.limits import Limits
from torquerig.cases.this_machine import ProcessPool
from torquerig.errors import InputError

IDLE = 300.0  # s without a block after which a process ends: its study may have been killed; another start takes 1 s


class CaseWorker(WorkerPlugin):  # type: ignore[misc]
    """The work function and inputs of a study on one worker; Dask brings it to those that join later too.

    Parameters
    ----------
    name : str
        By which the tasks of the study find it.
    content : bytes
        The packed work function and inputs.
    limits : Limits
        Of a case.
    code : mapping of str to str
        Versions that this worker must have.
    """

    def __init__(self, name: str, *, content: bytes, limits: Limits, code: Mapping[str, str]) -> None:
        self.name = name
        self._content, self._limits, self._code = content, limits, code

    def setup(self, worker: Worker) -> None:
        """Make room for the processes, which start with the first blocks."""
        # Dask's worker is a daemon to its nanny, and Python lets daemons have no children; ours end with their parent
        multiprocessing.current_process()._config["daemon"] = False  # type: ignore[attr-defined]
        self._free: queue.SimpleQueue[ProcessPool] = queue.SimpleQueue()
        self._pools = [ProcessPool(self._content, self._limits, idle=IDLE) for _ in range(worker.state.nthreads)]
        for pool in self._pools:
            self._free.put(pool)

    def teardown(self, worker: Worker) -> None:
        """End the processes."""
        for pool in self._pools:
            pool.end()

    def worked_on(self, block: Block) -> tuple[str, Sequence[Any], str, float]:
        """Return what became of a block: kind, answers, error, seconds [s].

        Raises
        ------
        InputError
            When this worker has other code, or cannot load the work function and its inputs.
        """
        refuse_other_code(code_here(), self._code, where=f"the worker at {get_worker().address}")
        pool = self._free.get()
        try:
            if not any(
                worker.process.is_alive() for worker in pool.workers
            ):  # the first block, or it was idle too long
                pool.end()
                pool.start_one()
            while not pool.room():
                pool.finished()
            pool.submit(block)
            while not (found := pool.finished()):
                pass
        finally:
            self._free.put(pool)
        (outcome,) = found
        return outcome.kind, outcome.answers, outcome.error, outcome.seconds


def work_on(name: str, block: Block) -> tuple[str, Sequence[Any], str, float]:
    """Return what became of a block; called by Dask on one of its workers."""
    plugin: CaseWorker = get_worker().plugins[name]
    return plugin.worked_on(block)


def refuse_other_code(there: Mapping[str, str], here: Mapping[str, str], *, where: str) -> None:
    """Refuse a worker whose rows could differ.

    Raises
    ------
    InputError
        With the first library that has another version.
    """
    for name, version in here.items():
        if there.get(name) != version:
            raise InputError(
                f"{where} has {name} {there.get(name, 'none')}, and here is {version}; install the same "
                "versions on all machines of the cluster"
            )
