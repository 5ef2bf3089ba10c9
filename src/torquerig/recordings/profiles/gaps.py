"""What no profile may have: rows that are no numbers, a time that does not rise or jumps, an end before the run's."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError

EVEN_ROWS = 8  # so many rows before their spacing counts as even
EVEN_SHARE = 0.9  # of the steps that are alike
EVEN_WITHIN = 0.25  # relative spread of steps that count as alike


def refuse_gaps(
    time: NDArray[np.float64], columns: Mapping[str, NDArray[np.float64]], *, place: Callable[[int], str]
) -> None:
    """Refuse a table that does not say at each time what the set-point is.

    An evenly spaced table has a gap where one step is more than half as long again as the others; in one with rows of
    its own choice (fewer than ``EVEN_ROWS``, or uneven ones) straight lines between them are what is meant.

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
            f"{place(0)}: the profile starts at {time[0]:g} s; nothing is said of the time before it: count the time "
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


def refuse_short(word: str, length: float, *, duration: float) -> None:
    """Refuse the profile ``word`` that ends after ``length`` [s] for a run of ``duration`` [s] that is longer."""
    if duration > length * (1 + 1e-9):
        raise InputError(
            f"the profile {word} ends after {length:g} s, and the run lasts {duration:g} s; make the run shorter, go "
            "on with the profile, or raise its repeats"
        )
