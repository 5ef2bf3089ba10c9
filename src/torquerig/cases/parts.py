"""Parts of a stored table: Parquet files that are written whole, and recognised when they were damaged since.

The name of a part ends with the digest of its bytes. What a crash of the system left half on the disk, or a disk has
changed, has another digest.
"""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.cases.case import Column, plain
from torquerig.cases.identity import Identity, digest_of
from torquerig.whole_file import temporary_name

if TYPE_CHECKING:
    import pyarrow as pa

UNFINISHED = "unfinished.parquet"  # rows of cases that were given up
_PART = re.compile(r"part-(?P<number>\d{6,})-(?P<digest>[0-9a-f]{16})\.parquet")


def schema_of(identity: Identity) -> pa.Schema:
    """Return the columns of the stored table, each with its unit and meaning as metadata."""
    import pyarrow as pa

    kinds = {"float": pa.float64(), "int": pa.int64(), "str": pa.string(), "bool": pa.bool_()}
    engine = [
        pa.field("case", pa.int64(), nullable=False),
        pa.field("seed", pa.int64(), nullable=False),
        pa.field("state", pa.string(), nullable=False, metadata={"meaning": "done, failed or unfinished"}),
        pa.field("error", pa.string()),
    ]

    def field(column: Column) -> pa.Field:
        return pa.field(column.name, kinds[column.kind], metadata={"unit": column.unit, "meaning": column.meaning})

    return pa.schema([*engine, *map(field, identity.values), *map(field, identity.results)])


def table_of(rows: Iterable[Mapping[str, Any]], schema: pa.Schema) -> pa.Table:
    """Return rows as a table, sorted by case; what a row lacks is null."""
    import pyarrow as pa

    ordered = sorted(rows, key=lambda row: int(row["case"]))
    columns = [
        pa.array([_as(field.type, plain(row.get(field.name))) for row in ordered], field.type, from_pandas=False)
        for field in schema
    ]
    return pa.Table.from_arrays(columns, schema=schema)


def content_of(table: pa.Table) -> bytes:
    """Return the bytes of a Parquet file; the same table gives the same."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    held = pa.BufferOutputStream()
    pq.write_table(table, held, compression="zstd")
    return bytes(held.getvalue())


def write_part(table: pa.Table, folder: Path, number: int, *, temporary: Path) -> Path:
    """Write a part and return its path; it is in ``folder`` whole and on the disk, or not at all.

    ``temporary`` is a folder of the same file system, so that readers of ``folder`` never see a part of a part.

    Raises
    ------
    OSError
        Where it cannot be written; its ``filename`` is the folder.
    """
    content = content_of(table)
    path = folder / f"part-{number:06d}-{digest_of(content)}.parquet"
    write_synced(content, path, temporary=temporary)
    return path


def write_synced(content: bytes, path: Path, *, temporary: Path) -> None:
    """Write a file whole or not at all, and wait until the disk has it and its name.

    Raises
    ------
    OSError
        Where it cannot be written; its ``filename`` is the folder.
    """
    partial = temporary_name(temporary / path.name, "partial")
    try:
        with partial.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        partial.replace(path)
        sync_folder(path.parent)
    except OSError as error:
        raise OSError(error.errno or errno.EIO, error.strerror or str(error), str(path.parent)) from error
    finally:
        partial.unlink(missing_ok=True)


def read_part(path: Path, schema: pa.Schema) -> pa.Table | None:
    """Return the table of a part, or None where the file is damaged or no part of such a table."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    match = _PART.fullmatch(path.name)
    content = path.read_bytes()
    if match is None or digest_of(content) != match["digest"]:
        return None
    table = pq.read_table(pa.BufferReader(content))
    return table if table.schema.equals(schema) else None


def finished_parts(folder: Path) -> list[Path]:
    """Return the paths of the parts of finished cases, in the order in which they were written."""
    return sorted(path for path in folder.glob("*.parquet") if path.name != UNFINISHED)


def number_of(path: Path) -> int:
    """Return the number of a part; 0 for a file that has none."""
    match = _PART.fullmatch(path.name)
    return int(match["number"]) if match else 0


def joined(tables: Sequence[pa.Table], schema: pa.Schema) -> pa.Table:
    """Return tables of this schema as one, sorted by case."""
    import pyarrow as pa

    return pa.concat_tables([schema.empty_table(), *tables]).sort_by("case")


def sync_folder(folder: Path) -> None:
    """Wait until the names in a folder are on the disk; Windows does that by itself."""
    if os.name == "nt":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _as(kind: Any, value: Any) -> Any:
    return float(value) if value is not None and str(kind) == "double" else value
