"""Parquet: one column per channel, compact and exact."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.sidecar_text import SIDECAR_KEY, sidecar_text
from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces
from torquerig.recordings.recording import Recording

# row groups up to this size [rows] are read whole: less than half the memory and time of reading batches
_LARGEST_GROUP = 2**20


def read_parquet(path: Path) -> Table:
    """Read the columns of numbers of a Parquet file; missing values become NaN, other columns are skipped by name."""
    import pyarrow as pa
    from pyarrow import parquet

    try:
        table = parquet.read_table(path)
        kept, skipped = _kinds(table.schema)
        columns = {name: _numbers(table[name]) for name in kept}
    except (pa.ArrowException, OSError, ValueError, LookupError) as error:
        raise _not_whole(path, error) from None
    return Table(columns=columns, skipped=skipped, sidecar=_sidecar(table.schema.metadata))


def _kinds(schema: Any) -> tuple[list[str], dict[str, str]]:
    """Return the names of the columns of numbers, and of the others with the reason."""
    import pyarrow as pa

    names = [name for name in schema.names if not name.startswith("__index")]
    if len(set(names)) < len(names):
        raise ValueError("two columns have the same name")
    kinds = {name: schema.field(name).type for name in names}
    kept = [name for name, kind in kinds.items() if pa.types.is_floating(kind) or pa.types.is_integer(kind)]
    return kept, {name: f"values of the type {kind}" for name, kind in kinds.items() if name not in kept}


def parquet_pieces(path: Path) -> TablePieces:
    """Return the columns of numbers in pieces; each needs at most the memory of a row group's compressed columns."""
    import pyarrow as pa
    from pyarrow import parquet

    try:
        with parquet.ParquetFile(path) as file:
            kept, skipped = _kinds(file.schema_arrow)
            sidecar = _sidecar(file.schema_arrow.metadata)
            rows, groups = file.metadata.num_rows, file.num_row_groups
            largest = max((file.metadata.row_group(group).num_rows for group in range(groups)), default=0)
    except (pa.ArrowException, OSError, ValueError, LookupError) as error:
        raise _not_whole(path, error) from None

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        try:
            if largest <= _LARGEST_GROUP:
                with parquet.ParquetFile(path) as file:
                    for group in range(groups):
                        # column by column, so that only one is in memory both compressed and decompressed
                        columns: dict[str, NDArray[np.float64]] = {}
                        for name in names:
                            columns |= _columns(file.read_row_group(group, [name], use_threads=False), [name])
                        yield columns
                        del columns
                        pa.default_memory_pool().release_unused()
                return
            # buffered: read in parts, not a row group at a time
            with parquet.ParquetFile(path, buffer_size=2**20, pre_buffer=False) as file:
                for batch in file.iter_batches(PIECE, columns=list(names), use_threads=False):
                    yield _columns(batch, names)
        except (pa.ArrowException, OSError, ValueError, LookupError) as error:
            raise _not_whole(path, error) from None

    return TablePieces(
        names=tuple(kept), lengths=dict.fromkeys(kept, rows), pieces=pieces, skipped=skipped, sidecar=sidecar
    )


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


def _columns(table: Any, names: Sequence[str]) -> Columns:
    return {name: _numbers(table[name]) for name in names}


def _numbers(column: Any) -> NDArray[np.float64]:
    """Return a column as float64; through DLPack, because ``to_numpy`` imports pandas for 40 MB."""
    import pyarrow as pa
    from pyarrow import compute

    if not pa.types.is_float64(column.type):
        column = column.cast(pa.float64())
    if column.null_count:
        column = compute.fill_null(column, float("nan"))
    chunks = column.chunks if isinstance(column, pa.ChunkedArray) else [column]
    parts = [np.from_dlpack(chunk) for chunk in chunks if len(chunk)]
    if not parts:
        return np.empty(0)
    return np.asarray(parts[0] if len(parts) == 1 else np.concatenate(parts), dtype=np.float64)


def _not_whole(path: Path, error: Exception) -> RecordingError:
    reason = " ".join(str(error).split()).rstrip(". ")
    return RecordingError(f"{path}: not a whole Parquet file ({reason}); copy it again from its source")
