"""The rows of a study in a folder, which lose nothing when the process is killed.

::

    FOLDER/study.json              which study, code and columns (its identity)
    FOLDER/rows/part-N-DIGEST.parquet   finished cases; any reader of Parquet reads them as one table
    FOLDER/rows/unfinished.parquet      cases that were given up; a resumed study tries them again
    FOLDER/damaged/                parts that were damaged on the disk; their cases are computed again
    FOLDER/.lock                   held by the process that writes

``merged/`` and ``replaced/`` exist while many parts are made few. A case is in one part or in ``unfinished.parquet``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.cases.case import Case
from torquerig.cases.folder_lock import folder_lock
from torquerig.cases.identity import Identity, refuse_other
from torquerig.cases.parts import (
    UNFINISHED,
    content_of,
    finished_parts,
    joined,
    number_of,
    read_part,
    schema_of,
    sync_folder,
    table_of,
    write_part,
    write_synced,
)
from torquerig.errors import InputError
from torquerig.whole_file import clear_leftovers, remove, temporary_name

if TYPE_CHECKING:
    import pandas as pd
    import pyarrow as pa

IDENTITY_FILE = "study.json"


@dataclass
class Store:
    """A store that this process holds; made by :func:`opened_store`.

    ``states`` has the state of each finished case; ``notes`` says in sentences what was found and repaired.
    """

    folder: Path
    identity: Identity
    rows_per_part: int
    states: dict[int, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    _given_up: dict[int, Mapping[str, Any]] = field(default_factory=dict)

    @property
    def rows(self) -> Path:
        """The folder of the parts."""
        return self.folder / "rows"

    @property
    def schema(self) -> pa.Schema:
        """Columns of the table."""
        return schema_of(self.identity)

    @property
    def parts(self) -> int:
        """How many parts of finished cases there are."""
        return len(finished_parts(self.rows))

    def save(self, rows: Sequence[Mapping[str, Any]]) -> None:
        """Add rows of finished cases (``state`` done or failed) as one part; on return they are on the disk.

        Raises
        ------
        OSError
            Where the part cannot be written; what was stored before is unchanged.
        """
        if not rows:
            return
        number = 1 + max(map(number_of, finished_parts(self.rows)), default=0)
        write_part(table_of(rows, self.schema), self.rows, number, temporary=self.folder)
        self.states |= {int(row["case"]): str(row["state"]) for row in rows}

    def save_unfinished(self, row: Mapping[str, Any]) -> None:
        """Keep the row of a case that was given up, for those who read the table; a resumed study drops it.

        Raises
        ------
        OSError
            Where it cannot be written.
        """
        self._given_up[int(row["case"])] = row
        self._write_unfinished(self.rows)

    def merge(self) -> None:
        """Make few parts of many, sorted by case, so that a complete study is the same files however it was computed.

        Killed at any moment, the rows are in the old parts or in the new ones; the next opening puts them in place. A
        disk without room for both leaves the old parts.
        """
        tables = list(self._tables())
        if len(tables) < 2 or len(tables) < len(finished_parts(self.rows)):  # a damaged one is for the next opening
            return
        table = _once(joined(tables, self.schema))
        partial = temporary_name(self.folder / "merged", "partial")
        try:
            partial.mkdir()
            for number, start in enumerate(range(0, len(table), self.rows_per_part), start=1):
                write_part(table.slice(start, self.rows_per_part), partial, number, temporary=self.folder)
            self._write_unfinished(partial)
            partial.replace(self.folder / "merged")
            sync_folder(self.folder)
        except OSError as error:
            remove(partial)
            self.notes.append(f"{self.folder}: the parts were left as they are ({error.strerror}); all rows are there")
            return
        _exchange_merged(self.folder)

    def refuse_other_cases(self, cases: Iterable[Case]) -> None:
        """Refuse a table of cases that gives a stored case another seed or other values.

        Raises
        ------
        InputError
            For the first such case.
        """
        names = ["case", "seed", *(column.name for column in self.identity.values)]
        given = {case.number: case for case in cases if case.number in self.states}
        for table in self._tables():
            both = [number in given for number in table["case"].to_pylist()]
            stored = table.select(names).filter(both)
            wanted = table_of((_start_of_row(given[number]) for number in stored["case"].to_pylist()), self.schema)
            if not stored.equals(wanted.select(names)):
                raise InputError(f"{self.folder}: {_first_difference(stored, wanted, names)}")

    def table(self) -> pa.Table:
        """Return all rows, unfinished ones too, sorted by case."""
        given_up = [table_of(self._given_up.values(), self.schema)] if self._given_up else []
        return joined([*self._tables(), *given_up], self.schema)

    def _tables(self) -> Iterator[pa.Table]:
        for path in finished_parts(self.rows):
            table = read_part(path, self.schema)
            if table is not None:
                yield table

    def _write_unfinished(self, folder: Path) -> None:
        if self._given_up:
            content = content_of(table_of(self._given_up.values(), self.schema))
            write_synced(content, folder / UNFINISHED, temporary=self.folder)


@contextmanager
def opened_store(folder: Path, identity: Identity, *, rows_per_part: int = 100_000) -> Iterator[Store]:
    """Yield the store in a folder, made where there is none; no other process can open it meanwhile.

    Parameters
    ----------
    rows_per_part : int
        Most rows of a part after merging: one part is in memory at a time for those who read it piece by piece.

    Raises
    ------
    InputError
        When another process has it, or it holds another study, or rows of other code.
    OSError
        Where the folder cannot be written to.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with folder_lock(folder):
        clear_leftovers(folder)
        stored = folder / IDENTITY_FILE
        if stored.exists():
            refuse_other(stored.read_text(encoding="utf-8"), identity, folder=folder)
        elif any(path.name != ".lock" for path in folder.iterdir()):
            raise InputError(f"{folder} holds other files and no study; give a new or empty folder")
        else:
            write_synced(identity.as_json().encode(), stored, temporary=folder)
        _exchange_merged(folder)
        store = Store(folder, identity, rows_per_part)
        store.rows.mkdir(exist_ok=True)
        (store.rows / UNFINISHED).unlink(missing_ok=True)
        _take_stock(store)
        yield store


def read_rows(folder: Path) -> pd.DataFrame:
    """Return the stored rows as a table, sorted by case; also while a study is writing them.

    Raises
    ------
    InputError
        When there are none.
    """
    import pyarrow.parquet as pq

    rows = Path(folder) / "rows"
    tables = None
    while tables is None:
        paths = sorted(rows.glob("*.parquet"))
        if not paths:
            raise InputError(f"{folder} holds no rows of a study; run the study first, or name its folder")
        with suppress(FileNotFoundError):  # parts are being made fewer
            tables = [pq.read_table(path) for path in paths]
    return joined(tables, tables[0].schema).to_pandas()


def _take_stock(store: Store) -> None:
    """Note which cases are done; put damaged parts aside."""
    twice = False
    for path in finished_parts(store.rows):
        table = read_part(path, store.schema)
        if table is None:
            aside = store.folder / "damaged"
            aside.mkdir(exist_ok=True)
            path.replace(aside / path.name)
            store.notes.append(f"{path.name} was damaged; it is in {aside} now and its cases are computed again")
            continue
        states = dict(zip(table["case"].to_pylist(), table["state"].to_pylist(), strict=True))
        twice = twice or not states.keys().isdisjoint(store.states)
        store.states |= states
    if twice:
        store.notes.append(f"{store.folder}: cases that were there twice count once")
        store.merge()


def _first_difference(stored: pa.Table, wanted: pa.Table, names: Sequence[str]) -> str:
    pairs = zip(stored.to_pylist(), wanted.select(names).to_pylist(), strict=True)
    row, other = next((row, other) for row, other in pairs if row != other)
    name = next(name for name in names if row[name] != other[name])
    return (
        f"case {row['case']} was computed with {name} {row[name]!r}, now it has {other[name]!r}; go on in another "
        "folder, or give the cases as they were"
    )


def _start_of_row(case: Case) -> dict[str, Any]:
    return {"case": case.number, "seed": case.seed, "state": "", **case.values}


def _once(table: pa.Table) -> pa.Table:
    """Return a table that is sorted by case without its second row of any case."""
    numbers = table["case"].to_numpy()
    import numpy as np

    return table.filter(np.diff(numbers, prepend=-1) > 0)


def _exchange_merged(folder: Path) -> None:
    """Put merged parts in the place of those that they were made of, from whatever step this had reached."""
    merged, rows, replaced = folder / "merged", folder / "rows", folder / "replaced"
    if merged.exists():
        if rows.exists():
            remove(replaced)
            rows.replace(replaced)
        merged.replace(rows)
        sync_folder(folder)
    if replaced.exists():
        remove(replaced)
