"""Where a line of a model shows in the features of a run: at which place of each stretch, else in which band."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Route:
    """Stretches (``rows``) that show a line and at which place; a band for where none does.

    ``part`` of it shows there, and it is a ``guest`` where the place is another line's.
    """

    rows: NDArray[np.int64]
    column: NDArray[np.int64]
    part: Floats
    guest: NDArray[np.bool_]
    band: int | None


@dataclass(frozen=True)
class Routes:
    """Many lines' routes in one: entry by entry which ``line`` shows in which ``row`` and ``column``, and its ``part``.

    ``turns`` are the entries in groups of which none has two at one place, those of earlier lines first. Lines that no
    place shows are ``unplaced``, each in its ``band``; what has neither is in none of them.
    """

    line: NDArray[np.int64]
    row: NDArray[np.int64]
    column: NDArray[np.int64]
    part: Floats
    guest: NDArray[np.bool_]
    turns: tuple[NDArray[np.int64], ...]
    unplaced: NDArray[np.int64]
    band: NDArray[np.int64]

    @staticmethod
    def of(routes: Sequence[Route]) -> Routes:
        """Return the routes of lines, at least one of them."""
        unplaced = {at: route.band for at, route in enumerate(routes) if not route.rows.size and route.band is not None}
        row = np.concatenate([route.rows for route in routes])
        column = np.concatenate([route.column for route in routes])
        return Routes(
            line=np.repeat(np.arange(len(routes)), [route.rows.size for route in routes]),
            row=row,
            column=column,
            part=np.concatenate([route.part for route in routes]),
            guest=np.concatenate([route.guest for route in routes]),
            turns=_in_turn(row, column),
            unplaced=np.array([*unplaced], dtype=np.int64),
            band=np.array([*unplaced.values()], dtype=np.int64),
        )


def _in_turn(row: NDArray[np.int64], column: NDArray[np.int64]) -> tuple[NDArray[np.int64], ...]:
    """Return the entries in groups: the first at each place, then the second, and so on."""
    taken: dict[tuple[int, int], int] = {}
    rank = np.empty(row.size, dtype=np.int64)
    for entry, place in enumerate(zip(row.tolist(), column.tolist(), strict=True)):
        rank[entry] = taken[place] = taken.get(place, -1) + 1
    return tuple(np.flatnonzero(rank == each) for each in range(rank.max(initial=-1) + 1))
