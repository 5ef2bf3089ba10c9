"""Cases distributed over worker processes, with progress; linear algebra is single-threaded."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from typing import Any, TypeVar

Job = TypeVar("Job")
Progress = Callable[[int, int, str], None]


def no_progress(_done: int, _total: int, _name: str) -> None:
    """Show nothing."""


def run_jobs(
    work: Callable[[Job], str], jobs: Sequence[Job], *, workers: int, progress: Progress = no_progress
) -> None:
    """Run ``work`` on every job; it returns the name for the progress. One worker runs in this process."""
    if not jobs:
        return
    progress(0, len(jobs), "")
    if workers == 1 or len(jobs) < 2:
        with _one_thread():
            for done, job in enumerate(jobs, start=1):
                progress(done, len(jobs), work(job))
        return
    # spawn, not fork: a fork would copy compiled code and threads of the parent
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn"), initializer=_one_thread) as pool:
        futures = [pool.submit(work, job) for job in jobs]
        try:
            for done, future in enumerate(as_completed(futures), start=1):
                progress(done, len(jobs), future.result())
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _one_thread() -> Any:  # in a worker it holds until the worker ends
    # the limit applies to loaded libraries only, so scipy.linalg is loaded first
    import scipy.linalg  # noqa: F401
    from threadpoolctl import threadpool_limits

    return threadpool_limits(limits=1)
