"""Checks of a tabulated profile: numbers in every row, a time that rises evenly, an end not before the run's."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError

EVEN_ROWS = 8  # fewest rows of a table that counts as evenly spaced
EVEN_SHARE = 0.9  # share of equal steps from which a table counts as evenly spaced
EVEN_WITHIN = 0.25  # relative deviation within which steps count as equal


def refuse_gaps(
    time: NDArray[np.float64], columns: Mapping[str, NDArray[np.float64]], *, place: Callable[[int], str]
) -> None:
    """Refuse a table that does not determine the set-point at each time.

    An evenly spaced table has a gap where one step is more than 1.5 times the median step. A table of fewer than
    ``EVEN_ROWS`` rows, or of uneven ones, is read as straight lines between its rows.

    Parameters
    ----------
    time : ndarray, shape (rows,)
        [s]
    place : callable
        Returns file and line of a row, counted from 0.

    Raises
    ------
    InputError
        With file, line and remedy.
    """
    for name, values in columns.items():
        bad = np.flatnonzero(~np.isfinite(values))
        if bad.size:
            raise InputError(
                f"{place(int(bad[0]))}: the profile has a gap: {name} is no number; write the value, or take the "
                "row out for a straight line across it"
            )
    if time.size < 2:
        raise InputError(f"{place(0)}: a profile needs at least two rows; add the time at which it ends")
    if time[0] != 0:
        raise InputError(
            f"{place(0)}: the profile starts at {time[0]:g} s, and the time before it is not stated; count the time "
            "from 0"
        )
    steps = np.diff(time)
    if not np.all(steps > 0):
        row = int(np.argmin(steps > 0)) + 1
        raise InputError(
            f"{place(row)}: the time does not rise ({time[row - 1]:g} s, then {time[row]:g} s); put the rows in order "
            "and remove doubles"
        )
    usual = float(np.median(steps))
    even = np.mean(np.abs(steps - usual) <= EVEN_WITHIN * usual) >= EVEN_SHARE
    worst = int(np.argmax(steps))
    if time.size >= EVEN_ROWS and even and steps[worst] > 1.5 * usual:
        raise InputError(
            f"{place(worst + 1)}: the profile has a gap: the time jumps from {time[worst]:g} s to {time[worst + 1]:g} "
            f"s in a table of {usual:g} s steps; fill in the rows between"
        )


def refuse_short(profile: str, length: float, *, duration: float) -> None:
    """Refuse a profile that ends after ``length`` [s] for a longer run of ``duration`` [s]."""
    if duration > length * (1 + 1e-9):
        raise InputError(
            f"the profile {profile} ends after {length:g} s, and the run lasts {duration:g} s; make the run shorter, "
            "extend the profile, or raise its repeats"
        )
