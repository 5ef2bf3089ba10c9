"""Work functions that worker processes can import."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from torquerig.cases import Case, Column, Failed, Identity
from torquerig.errors import SimulationError

VALUES = (Column("load", "N*m"), Column("motor", kind="str"))
RESULTS = (Column("reading", "N*m"), Column("hits", kind="int"))


def identity(**study: str) -> Identity:
    """Return the identity of the study of these tests."""
    return Identity(study={"scenario": "wear rig", **study}, values=VALUES, results=RESULTS)


def cases(count: int) -> list[Case]:
    """Return so many cases."""
    return [Case(n, {"load": n / 8, "motor": f"motor {n % 3}"}, seed=1000 + n) for n in range(count)]


def reading(scale: float, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Return what depends on values, seed and inputs."""
    return [row_of(scale, case) for case in block]


def row_of(scale: float, case: Case) -> Mapping[str, Any]:
    """Return the row of one case."""
    drawn = np.random.default_rng(case.seed).normal(size=50)
    return {"reading": scale * float(case.values["load"] or 0) + drawn.mean(), "hits": np.count_nonzero(drawn > 1)}


def slow_reading(seconds: float, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Return the same after some time for each case [s]."""
    time.sleep(seconds * len(block))
    return reading(2.0, block)


def with_a_fault(scale: float, block: Sequence[Case]) -> list[Any]:
    """Raise in a block with case 5, and return a failure for case 7."""
    if any(case.number == 5 for case in block):
        raise SimulationError("case 5: node 'drum' is not finite at 0.3 s")
    return [Failed("it cannot be") if case.number == 7 else row_of(scale, case) for case in block]


def endless_at_3(scale: float, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Never return for case 3."""
    while any(case.number == 3 for case in block):
        time.sleep(0.05)
    return reading(scale, block)


def rows_in(part: Path) -> int:
    """Return how many rows a part has."""
    import pyarrow.parquet as pq

    return int(pq.read_metadata(part).num_rows)


def deadly_once(folder: str, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """End the process at case 11 when it is worked on for the first time."""
    mark = Path(folder) / "was here"
    if any(case.number == 11 for case in block) and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return reading(2.0, block)


def deadly_at_2(scale: float, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """End the process at case 2."""
    if any(case.number == 2 for case in block):
        os.kill(os.getpid(), signal.SIGKILL)
    return reading(scale, block)


def threads_here(inputs: None, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Return how many threads libraries would use."""
    import numba
    from threadpoolctl import threadpool_info

    blas = max(one["num_threads"] for one in threadpool_info())
    return [{"blas": blas, "numba": numba.get_num_threads()} for _ in block]


class Unloadable:
    """Inputs that can be sent and not be loaded."""

    def __reduce__(self) -> Any:
        return _lost, ()


class OnlyHere:
    """Inputs whose module other machines do not have."""

    def __reduce__(self) -> Any:
        return _imported, ("a_module_of_this_machine",)


def _imported(name: str) -> Any:
    return __import__(name)


def _lost() -> None:
    raise OSError("lost")


def signed_reading(folder: str, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Return the same after 5 ms for each case, and leave the number of this process in a folder."""
    (Path(folder) / str(os.getpid())).touch()
    time.sleep(0.005 * len(block))
    return reading(2.0, block)


class Counted:
    """Inputs that leave a file in a folder for each time that they are loaded."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __reduce__(self) -> Any:
        return _counted, (self.folder,)


def _counted(folder: Path) -> Path:
    (folder / f"{os.getpid()} {time.monotonic_ns()}").touch()
    return folder


def with_counted(folder: Path, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Return a reading after some time, so that each worker gets blocks."""
    time.sleep(0.05)
    return reading(2.0, block)


def waits_for_others(folder: Path, block: Sequence[Case]) -> list[Mapping[str, Any]]:
    """Work on case 3 until the rows of all others are in the store."""
    end = time.monotonic() + 20.0
    while block[0].number == 3 and sum(map(rows_in, folder.glob("rows/part*"))) < 3:
        if time.monotonic() > end:
            raise SimulationError("the others were not stored in 20 s")
        time.sleep(0.05)
    return reading(2.0, block)
