"""A table with plain names: units taken out of the header cells, times in seconds."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.several_times.own_times import pieces_with_own_times, with_own_times
from torquerig.recordings.files.table_pieces import Columns, TablePieces
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.time_column import TimeColumn, time_column


@dataclass(frozen=True)
class _Names:
    """The new name of each column, the units by new name, and the column of times."""

    new: Mapping[str, str]
    units: Mapping[str, str]
    time: TimeColumn | None

    def has_unit(self) -> bool:
        # LabVIEW's X_Value is in seconds by definition
        return self.time is None or self.time.stated or self.time.name.strip().lower() == "x_value"

    def notes(self) -> tuple[str, ...]:
        if self.time is None or self.time.name.strip().lower() == "time_s":
            return ()
        if not self.time.stated:
            return (f"the column {self.time.name} states no unit and is read as seconds",)
        return (f"the column {self.time.name} is the time, in {self.time.unit}",) if self.time.unit != "s" else ()


def with_plain_names(table: Table, *, kept: Collection[str] = ()) -> Table:
    """Return the table with ``Torque [Nm]`` named ``Torque``, its unit in ``units``, and its times in seconds.

    A name in ``kept`` (those that a sidecar writes) stays, as does one that two columns would share.
    """
    table = with_own_times(table, kept=kept)
    names = _names(table.columns, table.units, kept)
    columns = {names.new[name]: values for name, values in table.columns.items()}
    if names.time is not None and names.time.seconds != 1.0:
        time = names.new[names.time.name]
        columns[time] = columns[time] * names.time.seconds
    return replace(
        table,
        columns=columns,
        rates={names.new[name]: rate for name, rate in table.rates.items()},
        starts={names.new[name]: start for name, start in table.starts.items() if name in names.new},
        units=names.units,
        notes=(*table.notes, *names.notes()),
        time_has_unit=names.has_unit(),
    )


def pieces_with_plain_names(table: TablePieces, *, kept: Collection[str] = ()) -> TablePieces:
    """Return the same for a table that is read piece by piece."""
    table = pieces_with_own_times(table, kept=kept)
    names = _names(table.names, table.units, kept)
    written = {new: name for name, new in names.new.items()}
    time = None if names.time is None else names.new[names.time.name]
    seconds = 1.0 if names.time is None else names.time.seconds

    def pieces(wanted: Sequence[str]) -> Iterator[Columns]:
        for piece in table.pieces([written[name] for name in wanted]):
            columns = {names.new[name]: values for name, values in piece.items()}
            if time in columns and seconds != 1.0:
                columns[time] = columns[time] * seconds
            yield columns

    return replace(
        table,
        names=tuple(names.new[name] for name in table.names),
        pieces=pieces,
        lengths={names.new[name]: length for name, length in table.lengths.items()},
        rates={names.new[name]: rate for name, rate in table.rates.items()},
        starts={names.new[name]: start for name, start in table.starts.items() if name in names.new},
        units=names.units,
        notes=(*table.notes, *names.notes()),
        time_has_unit=names.has_unit(),
    )


def _names(names: Iterable[str], units: Mapping[str, str], kept: Collection[str]) -> _Names:
    cells = list(names)
    split = {cell: split_header(cell) for cell in cells}
    plain = {cell: _plain(cell, *split[cell], kept=kept) for cell in cells}
    counts = Counter(plain.values())
    new = {cell: name if counts[name] == 1 else cell for cell, name in plain.items()}
    stated = {cell: (units.get(cell) or "").strip() or split[cell][1] for cell in cells}
    time = time_column(cells, units)
    found = {new[cell]: unit for cell, unit in stated.items() if unit}
    if time is not None:
        found[new[time.name]] = "s"
    return _Names(new=new, units=found, time=time)


def _plain(cell: str, name: str, unit: str | None, *, kept: Collection[str]) -> str:
    # torque_Nm is a name in one word and stays
    if cell in kept:
        return cell
    return cell.strip() if unit is None or cell.strip() == f"{name}_{unit.replace('/', '_')}" else name
