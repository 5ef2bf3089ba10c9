"""Independent fits on several processors: the same answers, sooner."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from contextvars import ContextVar
from multiprocessing import get_context
from typing import Any, TypeVar

from torquerig.errors import InputError

One = TypeVar("One")
Answer = TypeVar("Answer")

_PROCESSES: ContextVar[int] = ContextVar("processes", default=1)
_work: list[Callable[[int], Any]] = []  # of a child: what it was born with


@contextmanager
def parallel_processes(processes: int) -> Iterator[None]:
    """Let ``parallel_map`` use so many processes inside, where the system can fork one that shares this one's memory.

    What comes out does not depend on how many: linear algebra has one thread in each.
    """
    from threadpoolctl import threadpool_limits

    before = _PROCESSES.set(processes if sys.platform == "linux" else 1)
    try:
        with threadpool_limits(limits=1, user_api="blas"):  # threads below processes only spin, and round otherwise
            yield
    finally:
        _PROCESSES.reset(before)


def processes() -> int:
    """Return how many processes may work."""
    return _PROCESSES.get()


def parallel_map(work: Callable[[One], Answer], items: Sequence[One]) -> list[Answer]:
    """Return ``work`` of every item, in their order.

    The processes are forked, so that nothing but the answers is copied; what ``work`` keeps for later is lost. One
    process works where ``parallel_processes`` allows no more, and inside of ``work``. An exception of the first item
    that raises one is raised.
    """
    count = min(_PROCESSES.get(), len(items))
    if count < 2:
        return [work(item) for item in items]
    with warnings.catch_warnings():
        # the other threads of this process, of a progress bar or of linear algebra, hold nothing that a child asks for
        warnings.filterwarnings("ignore", message=".*multi-threaded.*fork", category=DeprecationWarning)
        with ProcessPoolExecutor(
            count, mp_context=get_context("fork"), initializer=_born, initargs=(lambda row: work(items[row]),)
        ) as pool:
            try:
                return list(pool.map(_done, range(len(items))))
            except BrokenProcessPool as gone:
                raise InputError(
                    "a worker process was killed, probably because memory ran out; run again with --workers 1"
                ) from gone


def _born(work: Callable[[int], Any]) -> None:
    _PROCESSES.set(1)
    _work[:] = [work]


def _done(row: int) -> Any:
    return _work[0](row)
