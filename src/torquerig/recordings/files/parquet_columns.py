"""Which columns of a Parquet file are numbers: floats, integers, decimals, true and false, and moments of time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.names.time_column import time_column

_SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
# where pandas stores the index of a table
_INDEX, _INDEX_NAME = "__index_level_0__", "time"


@dataclass(frozen=True, kw_only=True)
class StoredColumn:
    """A column as it is stored: its name there, and for moments the ticks of the first and the length of a tick [s]."""

    stored: str
    tick: float = 0.0
    origin: int = 0

    def numbers(self, column: Any) -> NDArray[np.float64]:
        """Return the column as float64; moments in seconds after the first, missing values as NaN."""
        import pyarrow as pa
        from pyarrow import compute

        if self.tick:
            ticks = compute.subtract(_ticks(column), self.origin)
            return _exact(compute.multiply(ticks.cast(pa.float64(), safe=False), self.tick))
        return _exact(column)

    def with_origin(self, column: Any) -> StoredColumn:
        """Return the column with the ticks of its first moment."""
        first = next((value for value in _ticks(column).to_pylist() if value is not None), 0) if self.tick else 0
        return replace(self, origin=first)


@dataclass(frozen=True, kw_only=True)
class Schema:
    """The columns of numbers by name, the units of their fields, the others with the reason, and remarks."""

    columns: Mapping[str, StoredColumn]
    units: Mapping[str, str] = field(default_factory=dict)
    skipped: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


def schema_of(schema: Any) -> Schema:
    """Return what a file's schema says; ValueError where two columns have the same name.

    The unit is the field's metadata ``unit`` or ``units``. The index of pandas is read where it holds moments.
    """
    import pyarrow as pa

    names = list(schema.names)
    if len(set(names)) < len(names):
        raise ValueError("two columns have the same name")
    columns, skipped, notes = {}, {}, []
    units: dict[str, str] = {}
    for stored in names:
        kind = schema.field(stored).type
        tick = _tick(kind)
        name = _INDEX_NAME if stored == _INDEX and tick and _INDEX_NAME not in names else stored
        if name.startswith("__index"):
            continue
        is_number = any(
            test(kind) for test in (pa.types.is_floating, pa.types.is_integer, pa.types.is_boolean, pa.types.is_decimal)
        )
        if not is_number and not tick:
            skipped[name] = f"values of the type {kind}"
            continue
        columns[name] = StoredColumn(stored=stored, tick=tick)
        unit = "s" if tick else _unit(schema.field(stored).metadata)
        units |= {name: unit} if unit else {}
        if tick:
            notes.append(f"{name}: moments are read in seconds after the first")
        elif pa.types.is_boolean(kind):
            notes.append(f"{name}: true and false are read as 1 and 0")
    moments = [name for name, column in columns.items() if column.tick]
    if len(moments) == 1 and time_column(columns, units) is None and "time_s" not in columns:
        # the only column of moments is the time whatever its name
        columns = {"time_s" if name in moments else name: column for name, column in columns.items()}
        units = {"time_s" if name in moments else name: unit for name, unit in units.items()}
        notes.append(f"{moments[0]} is called time_s")
    return Schema(columns=columns, units=units, skipped=skipped, notes=tuple(notes))


def _tick(kind: Any) -> float:
    """Return the length of a tick of a type of moments [s]; 0 for another type."""
    import pyarrow as pa

    is_moment = any(test(kind) for test in (pa.types.is_timestamp, pa.types.is_duration, pa.types.is_time))
    return _SECONDS[kind.unit] if is_moment else 0.0


def _unit(metadata: Mapping[bytes, bytes] | None) -> str:
    found = next(((metadata or {})[key] for key in (b"unit", b"units") if key in (metadata or {})), b"")
    return found.decode("utf-8", errors="replace").strip()


def _ticks(column: Any) -> Any:
    import pyarrow as pa

    is_short = pa.types.is_time32(column.type)
    return (column.cast(pa.int32()) if is_short else column).cast(pa.int64())


def _exact(column: Any) -> NDArray[np.float64]:
    """Return a column as float64; through DLPack, because ``to_numpy`` imports pandas for 40 MB."""
    import pyarrow as pa
    from pyarrow import compute

    if not pa.types.is_float64(column.type):
        column = column.cast(pa.float64(), safe=False)  # integers beyond 2**53 are rounded
    if column.null_count:
        column = compute.fill_null(column, float("nan"))
    chunks = column.chunks if isinstance(column, pa.ChunkedArray) else [column]
    parts = [np.from_dlpack(chunk) for chunk in chunks if len(chunk)]
    if not parts:
        return np.empty(0)
    return np.asarray(parts[0] if len(parts) == 1 else np.concatenate(parts), dtype=np.float64)
