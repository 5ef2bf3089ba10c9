"""Many lines' routes in one: what shows where, and in turn where several show at one place."""

from __future__ import annotations

import numpy as np

from torquerig.diagnosis.looking.route import Route, Routes


def route(rows: list[int], column: int, *, band: int | None = None, guest: bool = False) -> Route:
    count = len(rows)
    return Route(
        rows=np.array(rows, dtype=np.int64), column=np.full(count, column), part=np.full(count, 0.5),
        guest=np.full(count, guest), band=band,
    )  # fmt: skip


def test_entries_at_one_place_are_taken_in_the_order_of_their_lines() -> None:
    both = Routes.of([route([0, 1], 3), route([1, 2], 3, guest=True), route([1], 3)])
    places = list(zip(both.row.tolist(), both.column.tolist(), strict=True))
    taken = [[(both.line[entry], places[entry]) for entry in turn] for turn in both.turns]
    assert taken == [[(0, (0, 3)), (0, (1, 3)), (1, (2, 3))], [(1, (1, 3))], [(2, (1, 3))]]
    assert both.guest.tolist() == [False, False, True, True, False]


def test_a_line_that_no_place_shows_is_in_its_band_or_nowhere() -> None:
    none = Routes.of([route([], 0, band=7), route([], 0), route([0], 2, band=4)])
    assert (none.unplaced.tolist(), none.band.tolist()) == ([0], [7])
    assert none.line.tolist() == [2]
