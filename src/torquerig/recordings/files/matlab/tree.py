"""The variables of a MATLAB file as a tree."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import prod

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True)
class Numbers:
    """An array of numbers.

    Parameters
    ----------
    shape : tuple of int
        As in MATLAB: rows, columns, further dimensions.
    read : callable
        Returns the numbers ``[first, last)`` along the longest of the first two dimensions, shape (samples, columns),
        float64; a row vector is turned.
    is_logical : bool
        Whether MATLAB holds them as true and false.
    unit : str
        The unit that a table states for its column.
    """

    shape: tuple[int, ...]
    read: Callable[[int, int], NDArray[np.float64]]
    is_logical: bool = False
    unit: str = ""

    @property
    def size(self) -> int:
        """The number of elements."""
        return prod(self.shape)

    @property
    def samples(self) -> int:
        """The longest of the dimensions."""
        return max(self.shape, default=0)

    @property
    def width(self) -> int:
        """The number of columns; more than one for a matrix."""
        return self.size // max(self.samples, 1)

    def scalar(self) -> float | None:
        """Return the number where there is only one."""
        return float(self.read(0, 1)[0, 0]) if self.size == 1 else None


@dataclass(frozen=True)
class Unread:
    """A variable that is not read, with the reason; ``kind`` is the class of an object of MATLAB."""

    reason: str
    kind: str = ""


Struct = list[dict[str, "Node"]]
"""A struct array: the fields of each element."""

Node = Numbers | str | Unread | Struct
Variables = Mapping[str, Node]


def numbers(array: NDArray[np.generic], *, is_logical: bool = False) -> Numbers:
    """Return an array in memory as a leaf of the tree."""

    def read(first: int, last: int) -> NDArray[np.float64]:
        upright = array if array.ndim < 2 or array.shape[0] >= array.shape[1] else array.T
        with np.errstate(invalid="ignore"):  # a damaged float may be a signalling NaN
            samples = np.asarray(upright[first:last], dtype=np.float64)
        return samples.reshape(samples.shape[0], -1)

    return Numbers(shape=array.shape, read=read, is_logical=is_logical)


EXPORTS = {
    "table": "in MATLAB, s = table2struct(T, 'ToScalar', true) and save('run.mat', '-struct', 's')",
    "timetable": "in MATLAB, writetimetable(T, 'run.csv')",
    "timeseries": "in MATLAB, save x.Time and x.Data as vectors",
}
"""Objects of MATLAB that hold channels, and how to save them otherwise."""


def object_reason(kind: str) -> str:
    """Return why an object is not read, and the export that helps."""
    if kind in EXPORTS:
        reader = "" if kind == "timeseries" else "pip install 'torquerig[mat]', or "
        return f"a MATLAB {kind}; {reader}{EXPORTS[kind]}"
    return f"a MATLAB object of the class {kind or 'unknown'}"
