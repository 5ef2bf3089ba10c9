"""A table file that is read piece by piece: names, lengths, rates and units, without the samples."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.number_table import Table
from torquerig.recordings.names.time_column import time_column

PIECE = 2**18
"""Samples of one piece [1]; a format may return fewer or somewhat more."""

Columns = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True, kw_only=True)
class TablePieces:
    """A file that is read piece by piece.

    Parameters
    ----------
    names : tuple of str
        The columns of numbers, in the order of the file.
    lengths : mapping of str to int
        Samples of each column; empty where they are known only after reading to the end.
    pieces : callable
        Takes names of columns and yields mappings of equally long arrays, from the start.
    rates, units, skipped, notes, sidecar, starts, time_has_unit
        As in :class:`Table`.
    read_whole : str
        The reason why the file was read at once; empty where it was not.
    """

    names: tuple[str, ...]
    pieces: Callable[[Sequence[str]], Iterator[Columns]]
    lengths: Mapping[str, int] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    skipped: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    sidecar: str = ""
    starts: Mapping[str, float] = field(default_factory=dict)
    time_has_unit: bool = True
    read_whole: str = ""

    def time_name(self) -> str | None:
        """Return the name of the time column, or None."""
        time = time_column(self.names, self.units)
        return None if time is None else time.name


def pieces_of(table: Table, *, reason: str) -> TablePieces:
    """Return a table in memory as pieces; ``reason`` is why the file had to be read at once."""

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        size = max((table.columns[name].size for name in names), default=0)
        for first in range(0, size, PIECE):
            yield {name: table.columns[name][first : first + PIECE] for name in names}

    return TablePieces(
        names=tuple(table.columns),
        lengths={name: values.size for name, values in table.columns.items()},
        pieces=pieces,
        rates=table.rates,
        units=table.units,
        skipped=table.skipped,
        notes=table.notes,
        sidecar=table.sidecar,
        starts=table.starts,
        read_whole=reason,
    )
