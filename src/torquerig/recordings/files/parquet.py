"""Parquet: one column per channel, compact and exact."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.parquet_columns import StoredColumn, schema_of
from torquerig.recordings.files.sidecar_text import SIDECAR_KEY, sidecar_text
from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces
from torquerig.recordings.recording import Recording

# row groups up to this size [rows] are read whole: less than half the memory and time of reading batches
_LARGEST_GROUP = 2**20


def read_parquet(path: Path) -> Table:
    """Read the columns of numbers and moments of a Parquet file; the others are skipped by name.

    Missing values become NaN. Moments become seconds after the first. The unit is the metadata ``unit`` of a field.

    Raises
    ------
    RecordingError
        When the file is damaged, or two columns have the same name.
    """
    import pyarrow as pa
    from pyarrow import parquet

    try:
        table = parquet.read_table(path)
        schema = schema_of(table.schema)
        columns = {
            name: column.with_origin(table[column.stored]).numbers(table[column.stored])
            for name, column in schema.columns.items()
        }
    except (pa.ArrowException, OSError, ValueError, LookupError) as error:
        raise _not_whole(path, error) from None
    return Table(
        columns=columns, units=schema.units, skipped=schema.skipped, notes=schema.notes,
        sidecar=_sidecar(table.schema.metadata),
    )  # fmt: skip


def parquet_pieces(path: Path) -> TablePieces:
    """Return the columns of :func:`read_parquet` in pieces of a row group's compressed columns at most."""
    import pyarrow as pa
    from pyarrow import parquet

    try:
        with parquet.ParquetFile(path) as file:
            schema = schema_of(file.schema_arrow)
            sidecar = _sidecar(file.schema_arrow.metadata)
            rows, groups = file.metadata.num_rows, file.num_row_groups
            largest = max((file.metadata.row_group(group).num_rows for group in range(groups)), default=0)
            columns = {name: _with_origin(file, column) for name, column in schema.columns.items()}
    except (pa.ArrowException, OSError, ValueError, LookupError) as error:
        raise _not_whole(path, error) from None

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        wanted = {name: columns[name] for name in names}
        try:
            if largest <= _LARGEST_GROUP:
                with parquet.ParquetFile(path) as file:
                    for group in range(groups):
                        # column by column, so that only one is in memory both compressed and decompressed
                        piece: dict[str, NDArray[np.float64]] = {}
                        for name, one in wanted.items():
                            part = file.read_row_group(group, [one.stored], use_threads=False)
                            piece[name] = one.numbers(part[one.stored])
                            del part
                        yield piece
                        del piece
                        pa.default_memory_pool().release_unused()
                return
            # buffered: read in parts, not a row group at a time
            stored = [one.stored for one in wanted.values()]
            with parquet.ParquetFile(path, buffer_size=2**20, pre_buffer=False) as file:
                for batch in file.iter_batches(PIECE, columns=stored, use_threads=False):
                    yield {name: one.numbers(batch[one.stored]) for name, one in wanted.items()}
        except (pa.ArrowException, OSError, ValueError, LookupError) as error:
            raise _not_whole(path, error) from None

    return TablePieces(
        names=tuple(columns), lengths=dict.fromkeys(columns, rows), pieces=pieces, units=schema.units,
        skipped=schema.skipped, notes=schema.notes, sidecar=sidecar,
    )  # fmt: skip


def _with_origin(file: Any, column: StoredColumn) -> StoredColumn:
    """Return a column with the moment of its first row."""
    if not column.tick or not file.metadata.num_rows:
        return column
    return column.with_origin(next(file.iter_batches(1, columns=[column.stored], use_threads=False))[column.stored])


def write_parquet(recording: Recording, path: Path) -> None:
    """Write the channels in the smallest type that holds each sample exactly; same recording, same bytes."""
    import pyarrow as pa
    from pyarrow import parquet

    table = pa.table({name: compact(channel.values) for name, channel in recording.channels.items()})
    table = table.replace_schema_metadata({SIDECAR_KEY: sidecar_text(recording)})
    parquet.write_table(table, path, compression="zstd")


def _sidecar(metadata: Mapping[bytes, bytes] | None) -> str:
    """Return the sidecar in the file's metadata, or nothing."""
    return (metadata or {}).get(SIDECAR_KEY.encode(), b"").decode("utf-8", errors="replace")


def compact(values: NDArray[np.float64]) -> NDArray[np.float64] | NDArray[np.float32] | NDArray[np.int32]:
    """Return ``values`` as int32 or float32 where that changes no sample, else unchanged."""
    if np.all(np.abs(values) < 2**31) and not np.any(np.signbit(values) & (values == 0)):
        counts = values.astype(np.int32)
        if np.array_equal(counts, values):
            return counts
    # a float32 overflows above 3.4e38
    if np.all(np.abs(values) < 3e38):
        single = values.astype(np.float32)
        if np.array_equal(single, values):
            return single
    return values


def parquet_writer(path: Path, recording: Recording) -> Any:
    """Return a writer of consecutive blocks of the channels of ``recording``, as float64."""
    import pyarrow as pa
    from pyarrow import parquet

    metadata = {SIDECAR_KEY: sidecar_text(recording)}
    schema = pa.schema([(name, pa.float64()) for name in recording.channels], metadata=metadata)
    return parquet.ParquetWriter(path, schema, compression="zstd", compression_level=1, use_dictionary=False)


def append_parquet(writer: Any, columns: Mapping[str, NDArray[np.float64]]) -> None:
    """Write one more block."""
    import pyarrow as pa

    writer.write_table(pa.table(dict(columns), schema=writer.schema), row_group_size=PIECE)


def _not_whole(path: Path, error: Exception) -> RecordingError:
    reason = " ".join(str(error).split()).rstrip(". ")
    return RecordingError(f"{path}: not a whole Parquet file ({reason}); copy it again from its source")
