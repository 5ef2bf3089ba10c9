"""Fits on several processors: in their order, the same as one after the other, and what goes wrong is said."""

from __future__ import annotations

import os
import signal
import sys

import numpy as np
import pytest

from torquerig.errors import InputError, SimulationError
from torquerig.parallel import parallel_map, parallel_processes

forked = pytest.mark.skipif(sys.platform != "linux", reason="processes are forked on Linux alone")


def test_alone_everything_is_done_in_this_process() -> None:
    assert parallel_map(lambda _: os.getpid(), range(3)) == [os.getpid()] * 3


@forked
def test_each_is_done_beside_this_process_and_comes_back_in_order() -> None:
    large = np.arange(200_000.0)
    with parallel_processes(2):
        done = parallel_map(lambda row: (row, os.getpid(), large[row:].sum()), range(5))
    assert [row for row, _, _ in done] == list(range(5))
    assert [total for _, _, total in done] == [large[row:].sum() for row in range(5)]
    assert os.getpid() not in {process for _, process, _ in done}


@forked
def test_what_is_done_beside_is_not_divided_again() -> None:
    with parallel_processes(2):
        within = parallel_map(lambda _: (os.getpid(), parallel_map(lambda _: os.getpid(), range(2))), range(2))
    assert all(inner == [outer, outer] for outer, inner in within)


@forked
def test_afterwards_one_process_works_again() -> None:
    with parallel_processes(2):
        pass
    assert parallel_map(lambda _: os.getpid(), range(2)) == [os.getpid()] * 2


@pytest.mark.parametrize("processes", [1, 2])
def test_what_goes_wrong_beside_goes_wrong_here(processes: int) -> None:
    def work(row: int) -> int:
        if row == 1:
            raise SimulationError("the shaft stands still")
        return row

    with parallel_processes(processes), pytest.raises(SimulationError, match="the shaft stands still"):
        parallel_map(work, range(3))


@forked
def test_a_process_that_is_ended_from_outside_is_said_with_a_remedy() -> None:
    with parallel_processes(2), pytest.raises(InputError, match="memory ran out; run again with --workers 1"):
        parallel_map(lambda _: os.kill(os.getpid(), signal.SIGKILL), range(2))
