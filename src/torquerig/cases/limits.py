"""What a case may take, and what a worker may use: time, tries, one thread."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass

from torquerig.errors import InputError

# read by OpenMP, OpenBLAS, MKL, Apple's library and numba when they are loaded
ONE_THREAD: Mapping[str, str] = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS", "NUMBA_NUM_THREADS"), "1"
)


@dataclass(frozen=True)
class Limits:
    """How long a case may take and how often it is tried.

    Parameters
    ----------
    seconds : float, optional
        Wall-clock time [s] of one case; a block of n cases has n times as long. None: as long as it takes.
    compiling : float
        Additional time [s] of a block until a pool of workers has answered its first: kernels are compiled then. The
        batch kernel took 150 s on two busy processors; later starts take it from the disk.
    tries : int
        How often a case is started alone whose worker died or which took longer, before it is given up.

    Raises
    ------
    InputError
        For a time or a number of tries that leaves none.
    """

    seconds: float | None = None
    compiling: float = 300.0
    tries: int = 2

    def __post_init__(self) -> None:
        if self.seconds is not None and not self.seconds > 0:
            raise InputError(f"a limit of {self.seconds} s for a case leaves no time; give more than 0 s, or none")
        if not self.compiling >= 0:
            raise InputError(f"{self.compiling} s for compiling cannot be; give 0 s or more")
        if self.tries < 1:
            raise InputError(f"{self.tries} tries of a case are none; give 1 or more")

    def of_block(self, cases: int, *, has_compiled: bool) -> float | None:
        """Return the time [s] that a block of so many cases has."""
        return None if self.seconds is None else self.seconds * cases + (0.0 if has_compiled else self.compiling)


@contextmanager
def environment(variables: Mapping[str, str]) -> Iterator[None]:
    """Set variables of this process's environment, which processes started inside inherit."""
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
