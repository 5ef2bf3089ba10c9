"""MATLAB .mat: v5 (and v4, v6, v7) through scipy, v7.3 through h5py; vectors, or the fields of a struct."""

from __future__ import annotations

import re
import struct
import warnings
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces, pieces_of
from torquerig.recordings.recording import Recording

_RATE_NAMES = ("sample_rate_hz", "sample_rate", "samplerate", "fs", "fs_hz")
_BROKEN = (
    ValueError, TypeError, OSError, EOFError, LookupError, NotImplementedError, struct.error, zlib.error, Warning
)  # fmt: skip
# the first 116 bytes of a v5 file are free text, where scipy writes the date
_TITLE_LENGTH = 116


def read_mat(path: Path) -> Table:
    """Read every vector of numbers; a scalar ``fs`` or ``sample_rate_Hz`` is the sample rate.

    A struct's fields count as variables; other scalars and texts are ignored. A single matrix of two columns is the
    bare table of time and volts.

    Raises
    ------
    RecordingError
        When the file is damaged, or holds no vector of numbers.
    """
    import h5py
    from scipy.io.matlab import MatReadError

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            variables = _variables_hdf5(path) if h5py.is_hdf5(path) else _variables_v5(path)
    except (*_BROKEN, MatReadError) as error:
        raise RecordingError(f"{path}: not a whole .mat file ({error}); save it again in MATLAB") from None
    rates = [
        float(value.flat[0]) for name, value in variables.items() if name.lower() in _RATE_NAMES and value.size == 1
    ]
    vectors = {name: value for name, value in variables.items() if value.size > 1}
    columns = {name: value.reshape(-1) for name, value in vectors.items() if max(value.shape) == value.size}
    columns = columns or _bare_columns(list(vectors.values()))
    if not columns:
        listed = ", ".join(variables) or "nothing but text"
        raise RecordingError(
            f"{path}: there is no vector of two or more numbers among its variables ({listed}); save the channels as "
            "vectors, for example save('run1.mat', 'time_s', 'torque_V')"
        )
    exact = {name: np.ascontiguousarray(values, dtype=np.float64) for name, values in columns.items()}
    return Table(columns=exact, rates=dict.fromkeys(exact, rates[0]) if rates and rates[0] > 0 else {})


def mat_pieces(path: Path) -> TablePieces:
    """Return a v7.3 file in pieces; an older one is read at once, because each of its variables is compressed."""
    import h5py

    if not h5py.is_hdf5(path):
        return pieces_of(
            read_mat(path), reason="a .mat file before v7.3 is read whole; save it with -v7.3, or as TDMS or Parquet"
        )
    try:
        with h5py.File(path, "r") as file:
            found = dict(_datasets(file))
            rates = [
                float(item[()].flat[0])
                for name, (item, _) in found.items()
                if name.lower() in _RATE_NAMES and item.size == 1
            ]
            vectors = {
                name: item for name, (item, _) in found.items() if item.size > 1 and max(item.shape) == item.size
            }
            lengths = {name: int(item.size) for name, item in vectors.items()}
            places = {name: found[name][1] for name in vectors}
    except (*_BROKEN, RuntimeError) as error:
        raise RecordingError(f"{path}: not a whole .mat file ({error}); save it again in MATLAB") from None
    if not vectors:
        return pieces_of(read_mat(path), reason="a .mat file of one matrix is read whole; save its columns as vectors")

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        try:
            with h5py.File(path, "r") as file:
                for first in range(0, max((lengths[name] for name in names), default=0), PIECE):
                    yield {name: _stretch(file[places[name]], first) for name in names}
        except (*_BROKEN, RuntimeError) as error:
            raise RecordingError(f"{path}: not a whole .mat file ({error}); save it again in MATLAB") from None

    known = dict.fromkeys(vectors, rates[0]) if rates and rates[0] > 0 else {}
    return TablePieces(names=tuple(vectors), lengths=lengths, pieces=pieces, rates=known)


def write_mat(recording: Recording, path: Path) -> None:
    """Write a v5 file: each channel a column vector, and the scalar ``sample_rate_Hz``; same recording, same bytes.

    Raises
    ------
    InputError
        For a channel whose name is not a valid MATLAB variable, or one of 2 GiB or more (the limit of v5).
    """
    from scipy.io import savemat

    for name, channel in recording.channels.items():
        if channel.values.nbytes >= 2**31:
            raise InputError(f"{path}: {name} is larger than the 2 GiB of a v5 .mat file; write Parquet or TDMS")
    vectors = {name: np.asarray(channel.values, dtype=np.float64) for name, channel in recording.channels.items()}
    savemat(path, {**vectors, "sample_rate_Hz": recording.sample_rate}, appendmat=False, oned_as="column")
    with path.open("r+b") as file:
        file.write(b"MATLAB 5.0 MAT-file, written by torquerig".ljust(_TITLE_LENGTH))


def refuse_variable_names(names: Iterable[str], path: Path) -> None:
    """Raise InputError for a channel whose name is not a valid MATLAB variable."""
    for name in names:
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,30}", name):
            raise InputError(
                f"{path}: {name!r} cannot name a MATLAB variable; rename the channel (letters, digits and _, at most "
                "31, a letter first), or write Parquet"
            )


def _variables_v5(path: Path) -> dict[str, np.ndarray]:
    from scipy.io import loadmat

    content = loadmat(path, struct_as_record=True)
    return dict(_flattened({name: value for name, value in content.items() if not name.startswith("__")}))


def _bare_columns(matrices: list[np.ndarray]) -> dict[str, np.ndarray]:
    """Return time and volts of a single matrix of two columns (in h5py two rows)."""
    if len(matrices) != 1 or matrices[0].ndim != 2 or 2 not in matrices[0].shape:
        return {}
    pair = matrices[0] if matrices[0].shape[0] == 2 else matrices[0].T
    return {"time_s": pair[0], "torque_V": pair[1]}


def _flattened(content: Mapping[str, Any]) -> Iterator[tuple[str, np.ndarray]]:
    for name, value in content.items():
        array = np.asarray(value)
        if array.dtype.names and array.size == 1:
            yield from _flattened({field: array[field].flat[0] for field in array.dtype.names})
        elif array.dtype.kind in "fiu":
            yield name, array


def _variables_hdf5(path: Path) -> dict[str, np.ndarray]:
    import h5py

    with h5py.File(path, "r") as file:
        return {name: np.asarray(item[()]) for name, (item, _) in _datasets(file)}


def _datasets(group: Any) -> Iterator[tuple[str, tuple[Any, str]]]:
    """Yield name, dataset and place of each numeric variable, including the fields of structs."""
    import h5py

    for name, item in group.items():
        if isinstance(item, h5py.Group) and not name.startswith("#"):
            yield from _datasets(item)
        # MATLAB marks text, and writes an empty array as its sizes
        elif isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu" and not _is_text_or_empty(item):
            yield name, (item, str(item.name))


def _stretch(item: Any, first: int) -> np.ndarray:
    """Return one piece of a vector along the longest axis of its dataset."""
    along = int(np.argmax(item.shape))
    place = tuple(slice(first, first + PIECE) if axis == along else 0 for axis in range(item.ndim))
    return np.asarray(item[place], dtype=np.float64).reshape(-1)


def _is_text_or_empty(item: Any) -> bool:
    return bool(item.attrs.get("MATLAB_class", b"") == b"char" or "MATLAB_empty" in item.attrs)
