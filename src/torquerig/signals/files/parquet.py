"""Parquet: one column per channel, compact and exact."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.signals.files.table import Table
from torquerig.signals.recording import Recording


def read_parquet(path: Path) -> Table:
    """Read the columns of numbers of a Parquet file; missing values become NaN, columns of words are left out."""
    import pyarrow as pa
    from pyarrow import parquet

    try:
        table = parquet.read_table(path)
    except (pa.ArrowException, OSError) as error:
        reason = str(error).splitlines()[0].rstrip(". ")
        raise RecordingError(f"{path}: not a whole Parquet file ({reason}); copy it again from its source") from None
    columns = {
        name: np.asarray(table[name].cast(pa.float64()).to_numpy(), dtype=np.float64)
        for name, kind in zip(table.schema.names, table.schema.types, strict=True)
        if not name.startswith("__index") and (pa.types.is_floating(kind) or pa.types.is_integer(kind))
    }
    return Table(columns=columns)


def write_parquet(recording: Recording, path: Path) -> None:
    """Write the channels in the smallest type that holds each sample exactly; same recording, same bytes."""
    import pyarrow as pa
    from pyarrow import parquet

    table = pa.table({name: compact(channel.values) for name, channel in recording.channels.items()})
    parquet.write_table(table, path, compression="zstd")


def compact(values: NDArray[np.float64]) -> NDArray[np.float64] | NDArray[np.float32] | NDArray[np.int32]:
    """Return ``values`` as int32 or float32 where that changes no sample, else as they are."""
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
