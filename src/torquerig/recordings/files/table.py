"""Columns of numbers as a format's reader hands them over, before anything is known of what they mean."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

TIME_NAMES = ("time_s", "time", "t", "x_value", "time (s)", "time [s]")


@dataclass(frozen=True, kw_only=True)
class Table:
    """What a file holds.

    Parameters
    ----------
    columns : mapping of str to ndarray, shape (samples,), float64
        In the order of the file; the lengths may still differ.
    rates : mapping of str to float
        Samples per second [Hz] of the columns for which the file itself states it.
    units : mapping of str to str
        Units that the file itself states.
    """

    columns: Mapping[str, NDArray[np.float64]]
    rates: Mapping[str, float] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)

    def time_name(self) -> str | None:
        """Return the name of the time column [s], or None; ``time_s`` goes before ``time``, and that before ``t``."""
        return time_among(self.columns)

    def signal_names(self) -> list[str]:
        """Return the names of all columns but the time, in the order of the file."""
        time = self.time_name()
        return [name for name in self.columns if name != time]


def time_among(names: Iterable[str]) -> str | None:
    """Return the name among ``names`` that means the time [s], or None; ``time_s`` goes before ``time`` and ``t``."""
    lowered = {name.strip().lower(): name for name in reversed(list(names))}
    return next((lowered[known] for known in TIME_NAMES if known in lowered), None)


def distinct(names: Iterable[str]) -> list[str]:
    """Return the names with the second of two equal ones ending in ``_2``, the third in ``_3``."""
    given: list[str] = []
    for name in names:
        candidate, count = name, 1
        while candidate in given:
            count += 1
            candidate = f"{name}_{count}"
        given.append(candidate)
    return given
