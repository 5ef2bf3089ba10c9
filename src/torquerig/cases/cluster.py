"""Work on a cluster, by Dask: the same work function, the same rows."""

from __future__ import annotations

import asyncio
import logging
import queue
import time
import uuid
import warnings
from collections.abc import Iterator
from concurrent.futures import CancelledError, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from torquerig.cases.block import Block, Outcome, sentence_of
from torquerig.cases.case import Work
from torquerig.cases.identity import code_here
from torquerig.cases.limits import Limits
from torquerig.cases.worker import packed
from torquerig.errors import InputError, TorquerigError

if TYPE_CHECKING:
    from distributed import Client, Future

BLOCKS_PER_THREAD = 2  # one that is worked on and one that waits, so that no worker waits for the network
LOOK_EVERY = 2.0  # s, between looks at how many workers there are


@dataclass(frozen=True)
class Cluster:
    """The engine for studies on many machines: a running Dask scheduler and its workers, which have this torquerig.

    Parameters
    ----------
    address : str
        Of the scheduler, as ``tcp://host:8786``.
    patience : float
        How long to wait for the scheduler's answer, and then for its first worker [s].
    """

    address: str
    patience: float = 30.0

    @contextmanager
    def started(self, work: Work, inputs: Any, *, limits: Limits) -> Iterator[TaskPool]:
        """Yield a pool of the cluster's workers, also of those that join later; each gets function and inputs once.

        Raises
        ------
        InputError
            When the scheduler does not answer or has no workers, or a worker has other code.
        """
        content = packed(work, inputs)
        with _connected(self.address, self.patience) as client:
            _wait_for_worker(client, self.address, self.patience)
            from torquerig.cases.cluster_worker import CaseWorker

            name = f"torquerig-cases-{uuid.uuid4().hex}"
            _check_code(client, self.address)
            client.register_plugin(CaseWorker(name, content=content, limits=limits, code=code_here()), name=name)
            pool = TaskPool(client, self.address, name)
            try:
                yield pool
            finally:
                with suppress(Exception):  # the scheduler may be gone, and what it had is gone with it
                    client.cancel(list(pool.futures))
                    client.unregister_worker_plugin(name)


@dataclass
class TaskPool:
    """Blocks as tasks of a scheduler."""

    client: Client
    address: str
    name: str
    futures: dict[Future, Block] = field(default_factory=dict)
    _done: queue.SimpleQueue[Future] = field(default_factory=queue.SimpleQueue)
    _threads: int = 1
    _looked: float = float("-inf")

    def room(self) -> int:
        """Return how many blocks the workers can be given now."""
        if time.monotonic() - self._looked > LOOK_EVERY:
            with self._scheduler_answers():
                self._threads = max(1, sum(self.client.nthreads().values()))
            self._looked = time.monotonic()
        return max(0, BLOCKS_PER_THREAD * self._threads - len(self.futures))

    def submit(self, block: Block, /) -> None:
        """Give a block to the scheduler."""
        from torquerig.cases.cluster_worker import work_on

        with self._scheduler_answers():
            future = self.client.submit(work_on, self.name, block, key=f"{self.name}-{uuid.uuid4().hex}", pure=False)
        self.futures[future] = block
        future.add_done_callback(self._done.put)

    def finished(self) -> list[Outcome]:
        """Wait for a block, and return what became of it; nothing after some time, so that :meth:`room` looks again.

        Raises
        ------
        InputError
            When the scheduler is gone, or a worker cannot load the work function and its inputs.
        """
        from distributed import KilledWorker

        try:
            future = self._done.get(timeout=LOOK_EVERY)
        except queue.Empty:
            return []
        block = self.futures.pop(future)
        with self._scheduler_answers():
            if future.status == "cancelled":
                raise OSError("it does not know the study any more")
            error = future.exception()
            if isinstance(error, TorquerigError):
                raise error
            if isinstance(error, KilledWorker):
                return [Outcome(block, "lost", error="the workers of the cluster that had the case ended")]
            if error is not None:
                raise InputError(f"the cluster at {self.address} cannot work on the study: {sentence_of(error)}")
            return [Outcome(block, *future.result())]

    @contextmanager
    def _scheduler_answers(self) -> Iterator[None]:
        try:
            yield
        except (OSError, CancelledError, RuntimeError) as error:
            why = f" ({error})" if str(error) else ""
            raise InputError(
                f"the scheduler at {self.address} is gone{why}; start it again, and then the same command, which "
                "goes on with the cases that are not stored"
            ) from error


async def _answers(address: str, patience: float) -> None:
    """Raise an error unless a scheduler greets within this time [s], in which a client of Dask waits for ever."""
    from distributed.comm import connect
    from distributed.security import Security

    greeting = connect(address, timeout=patience, **Security().get_connection_args("client"))
    await (await asyncio.wait_for(greeting, patience)).close()


@contextmanager
def _connected(address: str, patience: float) -> Iterator[Client]:
    try:
        from distributed import Client
    except ImportError as error:
        raise InputError("a cluster needs Dask; install it with: pip install 'torquerig[cluster]'") from error
    with _said_here():
        try:
            with ThreadPoolExecutor(1) as aside:  # this thread may have an event loop, as in a notebook
                aside.submit(asyncio.run, _answers(address, patience)).result()
            client = Client(address, timeout=patience, set_as_default=False, name="torquerig")
        except Exception as error:  # whatever a server of another kind has sent
            raise InputError(
                f"no scheduler answers at {address!r} within {patience:g} s; give the address that `dask scheduler` "
                "prints, such as tcp://host:8786, and check that the port can be reached from here"
            ) from error
        try:
            yield client
        finally:
            with suppress(Exception):
                client.close(timeout=patience)


@contextmanager
def _said_here() -> Iterator[None]:
    """Keep Dask's client from printing what is raised here as one sentence: lost connections and other versions."""
    names = [name for name in logging.root.manager.loggerDict if name.startswith("distributed")]
    levels = {name: logging.getLogger(name).level for name in names}
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module="distributed")
        for name in names:
            logging.getLogger(name).setLevel(logging.CRITICAL)
        try:
            yield
        finally:
            for name, level in levels.items():
                logging.getLogger(name).setLevel(level)


def _wait_for_worker(client: Client, address: str, patience: float) -> None:
    try:
        client.wait_for_workers(1, timeout=patience)
    except TimeoutError as error:
        raise InputError(
            f"the scheduler at {address} had no worker within {patience:g} s; start some with: "
            f"dask worker {address} --nthreads 1"
        ) from error


def _check_code(client: Client, address: str) -> None:
    """Refuse a cluster on which torquerig is missing, or that has other versions of what computes.

    The scheduler is one of them, because Dask loads functions there too.
    """
    from torquerig.cases.cluster_worker import refuse_other_code

    try:
        found = {f"the scheduler at {address}": client.run_on_scheduler(code_here)}
        found |= {f"the worker at {worker}": code for worker, code in client.run(code_here).items()}
    except Exception as error:  # of whatever type, as another machine has raised it
        raise InputError(
            f"a machine of the cluster at {address} cannot load torquerig ({sentence_of(error)}); install the same "
            "versions on all its machines, that of the scheduler too"
        ) from error
    for where, code in found.items():
        refuse_other_code(code, code_here(), where=where)
