"""Reading by a library that a damaged file can bring down or keep busy: in a process of its own, with limits."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

_LEAST_SECONDS = 9.0  # the start of Python and the import of asammdf take 2 to 3 s
_SLOWEST = 2e6  # bytes per second; asammdf and mat-io read more than 20 MB/s
# the imports take 0.2 GB; packed data grow by a factor of 20 at most
_LEAST_MEMORY, _GROWTH = 2**30, 20

Found = tuple[list[Any], list[NDArray[Any]]]


class ChildError(Exception):
    """The process ended without a result; the text is the reason."""


def read_in_child(module: str, path: Path, *arguments: str) -> Found:
    """Run ``python -m module PATH TARGET ARGUMENTS`` and return what it passes on with :func:`pass_on`.

    Raises
    ------
    ChildError
        When the process ends with an error, crashes, or exceeds the time that the size of the file allows.
    """
    seconds = _LEAST_SECONDS + path.stat().st_size / _SLOWEST
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "arrays.npz"
        command = [sys.executable, "-m", module, str(path), str(target), *arguments]
        try:
            done = subprocess.run(command, capture_output=True, timeout=seconds, check=False)  # noqa: S603
        except subprocess.TimeoutExpired:
            raise ChildError(f"it was not read within {seconds:.0f} s") from None
        if done.returncode:
            lines = done.stderr.decode("utf-8", errors="replace").strip().splitlines()
            raise ChildError(lines[-1] if lines else f"the reader ended with code {done.returncode}")
        with np.load(target, allow_pickle=False) as arrays:
            index: list[Any] = json.loads(str(arrays["index"]))
            return index, [arrays[str(order)] for order in range(len(index))]


def pass_on(target: str, found: Sequence[tuple[Any, NDArray[Any]]]) -> None:
    """Write the arrays, each with what describes it, for the process that asked for them."""
    index = np.array(json.dumps([description for description, _ in found]))
    arrays: dict[str, Any] = {str(order): array for order, (_, array) in enumerate(found)}
    np.savez(target, index=index, **arrays)


def run_child(read: Callable[..., Sequence[tuple[Any, NDArray[Any]]]]) -> None:
    """Read in the child: limit the memory, and end with one line where that fails."""
    path, target, *arguments = sys.argv[1:]
    _limit_memory(_LEAST_MEMORY + _GROWTH * Path(path).stat().st_size)
    warnings.simplefilter("ignore")
    try:
        pass_on(target, read(path, *arguments))
    except Exception as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        sys.stderr.write(f"\n{reason}\n")
        sys.stderr.flush()
        sys.exit(1)


def _limit_memory(most: int) -> None:
    try:
        import resource
    except ImportError:  # Windows has no such limit
        return
    resource.setrlimit(resource.RLIMIT_DATA, (most, most))
