"""Columns of numbers as a format's reader returns them, before quantity and unit are determined."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.names.time_column import time_column


@dataclass(frozen=True, kw_only=True)
class Table:
    """Columns of numbers of one file.

    Parameters
    ----------
    columns : mapping of str to ndarray, shape (samples,), float64
        In the order of the file; the lengths may still differ.
    rates : mapping of str to float
        Sample rates [Hz] of the columns for which the file states one.
    units : mapping of str to str
        Units that the file states, as written.
    skipped : mapping of str to str
        Columns that are not read, each with the reason: words, states, no numbers.
    notes : tuple of str
        What the reader understood beyond names and numbers, one sentence each: the line of the names, a unit row, the
        source of the times.
    starts : mapping of str to float
        When the columns start on the clock of the file [s], where the file states it.
    sidecar : str
        The text of the sidecar that torquerig wrote into the file; empty where it holds none.
    time_has_unit : bool
        False where the unit of the times is not stated; they are read as seconds unless something contradicts it.
    """

    columns: Mapping[str, NDArray[np.float64]]
    rates: Mapping[str, float] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    skipped: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    sidecar: str = ""
    starts: Mapping[str, float] = field(default_factory=dict)
    time_has_unit: bool = True

    def time_name(self) -> str | None:
        """Return the name of the time column, or None; ``time_s`` is preferred to ``time``, and that to ``t``."""
        time = time_column(self.columns, self.units)
        return None if time is None else time.name

    def signal_names(self) -> list[str]:
        """Return the names of all columns but the time, in the order of the file."""
        time = self.time_name()
        return [name for name in self.columns if name != time]


def distinct(names: Iterable[str]) -> list[str]:
    """Return the names made distinct: the second of equal ones ends with ``_2``, the third with ``_3``."""
    given: dict[str, None] = {}
    for name in names:
        candidate, count = name, 1
        while candidate in given:
            count += 1
            candidate = f"{name}_{count}"
        given[candidate] = None
    return list(given)
