"""The variables of a .mat file of v7.3, which is HDF5 with MATLAB's attributes; the numbers are read piece by piece."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.matlab.tree import Node, Numbers, Struct, Unread, object_reason

_DEEPEST = 40  # structs within structs, as in a v5 file
# elements of a struct array; a scope or a logger has one for each signal
_MOST_ELEMENTS = 10_000
# all variables and fields; references can lead in a circle, which would not end
_MOST_NODES = 100_000
_LONGEST_TEXT = 1_000_000  # characters of a label, a unit or a sidecar


def variables_v73(path: Path) -> dict[str, Node]:
    """Return the variables of a file; what h5py raises where it is damaged.

    Source: MathWorks, "MAT-File Versions": a variable's class is its attribute ``MATLAB_class``; an array of n rows
    and m columns is stored as m x n; the fields of a struct array are references; objects have
    ``MATLAB_object_decode``.
    """
    import h5py

    with h5py.File(path, "r") as file:
        budget = iter(range(_MOST_NODES))
        return {name: _node(path, file[name], 0, budget) for name in file if not name.startswith("#")}


def _node(path: Path, item: Any, depth: int, budget: Iterator[int]) -> Node:
    import h5py

    if next(budget, None) is None:
        raise ValueError(f"more than {_MOST_NODES} variables and fields")
    if not isinstance(item, h5py.Dataset | h5py.Group):
        return Unread("no array")
    kind = item.attrs.get("MATLAB_class", b"")
    kind = kind.decode("latin-1") if isinstance(kind, bytes) else ""
    reason = _reason(item, kind, depth)
    if reason:
        return Unread(reason, kind=kind)
    if isinstance(item, h5py.Group):
        return _struct(path, item, depth, budget)
    if kind == "char":
        return _chars(item)
    shape = tuple(reversed(item.shape)) if item.ndim > 1 else (*item.shape, 1, 1)[:2]
    read = partial(stretch, path, str(item.name), _stored_rows(item))
    return Numbers(shape=shape, read=read, is_logical=kind == "logical" or item.dtype.kind == "b")


def _reason(item: Any, kind: str, depth: int) -> str:
    """Return why a variable is not read, or nothing."""
    import h5py

    if "MATLAB_object_decode" in item.attrs:
        return "a function handle" if kind == "function_handle" else object_reason(kind)
    if not isinstance(item, h5py.Dataset):
        is_deep = depth > _DEEPEST
        return "a sparse matrix" if "MATLAB_sparse" in item.attrs else "structs nested too deep" if is_deep else ""
    if "MATLAB_empty" in item.attrs:
        return "empty"
    if kind == "cell" or item.dtype.kind == "O":
        return "a cell array"
    if item.dtype.names:
        return "complex numbers; save real and imaginary part, or abs, as vectors"
    return "" if item.dtype.kind in "fiub" else "no numbers"


def _struct(path: Path, group: Any, depth: int, budget: Iterator[int]) -> Struct:
    """Return the elements of a struct; a field of a struct array is a dataset of references."""
    import h5py

    arrays = {
        name: field
        for name, field in group.items()
        if isinstance(field, h5py.Dataset)
        and h5py.check_ref_dtype(field.dtype) is h5py.Reference
        and not field.attrs.get("MATLAB_class")
    }
    count = min((field.size for field in arrays.values()), default=1)
    if not arrays or count > _MOST_ELEMENTS or len({field.size for field in arrays.values()}) > 1:
        return [{name: _node(path, field, depth + 1, budget) for name, field in group.items()}]
    columns = {name: list(_referenced(path, field, depth, budget)) for name, field in arrays.items()}
    plain = {name: _node(path, field, depth + 1, budget) for name, field in group.items() if name not in arrays}
    return [{**plain, **{name: column[index] for name, column in columns.items()}} for index in range(count)]


def _referenced(path: Path, field: Any, depth: int, budget: Iterator[int]) -> Iterator[Node]:
    for reference in np.asarray(field[()]).ravel():
        yield _node(path, field.file[reference], depth + 1, budget) if reference else Unread("empty")


def _chars(item: Any) -> Node:
    if item.size > _LONGEST_TEXT or item.dtype.kind not in "iu":
        return Unread("a text")
    if item.ndim > 1 and item.shape[-1] > 1:
        return Unread("a list of texts")
    return "".join(chr(int(sign) & 0xFFFF) for sign in np.asarray(item[()]).ravel())


def _stored_rows(item: Any) -> int:
    """Return the axis of the dataset along which the samples run: the longest, of equal ones MATLAB's rows."""
    return max(range(item.ndim), key=lambda axis: (item.shape[axis], axis)) if item.ndim else 0


def stretch(
    path: Path, place: str, along: int, first: int, last: int, *, field: str | None = None
) -> NDArray[np.float64]:
    """Return the samples ``[first, last)`` of a dataset along an axis, shape (samples, columns)."""
    import h5py

    with h5py.File(path, "r") as file:
        item = file[place]
        if not item.ndim:
            return np.asarray(item[()], dtype=np.float64).reshape(1, 1)
        part = item[tuple(slice(first, last) if axis == along else slice(None) for axis in range(item.ndim))]
    with np.errstate(invalid="ignore"):  # a damaged float may be a signalling NaN
        samples = np.moveaxis(np.asarray(part if field is None else part[field], dtype=np.float64), along, 0)
    return samples.reshape(samples.shape[0], -1)
