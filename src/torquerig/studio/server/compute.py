"""A second process that computes: it starts while the page does, and the page answers while it works."""

from __future__ import annotations

import asyncio
import os
import signal
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import active_children, get_context, parent_process
from multiprocessing.connection import wait
from threading import Thread
from typing import ParamSpec, TypeVar

from torquerig.errors import InputError, TorquerigError

Given = ParamSpec("Given")
Result = TypeVar("Result")


class Compute:
    """One process for work of some seconds at most, one piece after the other, for all tabs."""

    def __init__(self) -> None:
        self._pool = _new_pool()

    def begin(self, function: Callable[Given, object], *args: Given.args, **named: Given.kwargs) -> None:
        """Start a piece of work whose result nobody waits for, such as loading what is needed first."""
        self._pool.submit(function, *args, **named)

    async def run(self, function: Callable[Given, Result], *args: Given.args, **named: Given.kwargs) -> Result:
        """Return what a function of a module returns; it and its arguments must be picklable.

        Raises
        ------
        TorquerigError
            As the function raises it.
        InputError
            Where the process ended, such as for lack of memory (the next call has a new one), and for an error of
            torquerig itself.
        """
        try:
            return await asyncio.wrap_future(self._pool.submit(function, *args, **named))
        except TorquerigError:
            raise
        except BrokenProcessPool:
            self._pool = _new_pool()
            raise InputError("the computing process ended, perhaps for lack of memory; close other programs and "
                             "change a value to compute again") from None  # fmt: skip
        except Exception as error:
            raise InputError(f"an error in torquerig itself ({type(error).__name__}: {error}); please report it with "
                             "the scenario") from error  # fmt: skip

    def close(self) -> None:
        """End the process, also in the middle of its work."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        for process in active_children():
            process.terminate()


def _new_pool() -> ProcessPoolExecutor:
    return ProcessPoolExecutor(max_workers=1, mp_context=get_context("spawn"), initializer=_begin)


def _begin() -> None:
    """Leave Ctrl-C to the server, which ends this process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """End this process where the server was killed and could not end it."""
    parent = parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)
