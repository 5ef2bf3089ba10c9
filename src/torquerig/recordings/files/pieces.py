"""What a file holds without its samples, and how to go through them piece by piece."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.table import Table, time_among

PIECE = 2**18
"""Samples of one piece [1]; a format may hand over fewer or somewhat more."""

Columns = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True, kw_only=True)
class TablePieces:
    """A file that is read piece by piece.

    Parameters
    ----------
    names : tuple of str
        The columns of numbers, in the order of the file.
    lengths : mapping of str to int
        Samples of each column; empty where only reading to the end tells.
    pieces : callable
        Given names of columns, goes through them from the start: mappings of equally long arrays, one after the other.
    rates, units : mapping
        As in :class:`Table`.
    read_whole : str
        Why the file had to be read as a whole first; empty where it was not.
    """

    names: tuple[str, ...]
    pieces: Callable[[Sequence[str]], Iterator[Columns]]
    lengths: Mapping[str, int] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    read_whole: str = ""

    def time_name(self) -> str | None:
        """Return the name of the time column [s], or None."""
        return time_among(self.names)


def pieces_of(table: Table, *, reason: str) -> TablePieces:
    """Return a table that is in memory already as pieces; ``reason`` says why it had to be read whole."""

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
        read_whole=reason,
    )
