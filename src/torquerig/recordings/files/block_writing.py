"""Write a long recording block by block to a table file and its sidecar: both complete, or neither."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.files.checks import check_counts, check_finite
from torquerig.recordings.files.csv import append_csv, write_header
from torquerig.recordings.files.mat_blocks import mat_block_writer
from torquerig.recordings.files.parquet import append_parquet, parquet_writer
from torquerig.recordings.files.tdms import append_tdms, tdms_writer
from torquerig.recordings.files.writing import put_in_place, refuse_names
from torquerig.recordings.recording import Recording

Append = Callable[[Mapping[str, NDArray[np.float64]]], None]


def write_blocks(blocks: Iterable[Recording], path: Path, *, overwrite: bool = False) -> list[Path]:
    """Write a recording given as consecutive blocks; return the paths of the table and its sidecar.

    Parquet and TDMS hold every channel as float64; a .mat file is of v7.3. No file remains where a block fails.

    Raises
    ------
    InputError, RecordingError
        As :func:`write_recording`; an error raised by ``blocks`` is passed on.
    """
    path = Path(path)
    coming = iter(blocks)
    head = next(coming, None)
    if head is None:
        raise InputError(f"{path}: the recording has no blocks, so there is nothing to write")
    first = head
    refuse_names(first, path)

    def write(partial: Path) -> None:
        samples = 0
        with _OPENERS[path.suffix.lower()](partial, first) as append:
            for block in _chained(first, coming):
                check_finite(block, first=samples)
                append({name: channel.values for name, channel in block.channels.items()})
                samples += block.samples
        check_counts({"the table": samples}, str(path))

    return put_in_place(write, first, path, overwrite=overwrite)


def _chained(first: Recording, others: Iterator[Recording]) -> Iterator[Recording]:
    yield first
    yield from others


@contextmanager
def _parquet(path: Path, head: Recording) -> Iterator[Append]:
    writer = parquet_writer(path, head)
    try:
        yield lambda columns: append_parquet(writer, columns)
    finally:
        writer.close()


@contextmanager
def _tdms(path: Path, head: Recording) -> Iterator[Append]:
    with path.open("wb") as file:
        writer = tdms_writer(file, head)
        yield lambda columns: append_tdms(writer, columns)
        writer[0].close()


@contextmanager
def _csv(path: Path, head: Recording) -> Iterator[Append]:
    written = 0

    def append(columns: Mapping[str, NDArray[np.float64]]) -> None:
        nonlocal written
        size = next(iter(columns.values())).size
        append_csv(file, columns, times=(written + np.arange(size)) / head.sample_rate)
        written += size

    with path.open("wb") as file:
        write_header(file, head)
        yield append


_OPENERS: Mapping[str, Callable[[Path, Recording], AbstractContextManager[Append]]] = {
    ".parquet": _parquet,
    ".tdms": _tdms,
    ".csv": _csv,
    ".mat": mat_block_writer,
}
