"""Ranking of draws: the totals of the Kesselring matrix at each draw, shares of draws, and their uncertainty."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pandas as pd
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.decide.kesselring import TEACHING, kesselring
from torquerig.decide.matrix import Cell
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.reporting.study.draws_text import answer_text
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.monte_carlo.distribution import distribution, share_uncertainty
from torquerig.study.monte_carlo.drawn_study import drawn_study
from torquerig.study.monte_carlo.ranking import Ranking, Rating, column_of, rating_of
from torquerig.study.monte_carlo.running import _ranked
from torquerig.study.settings import SIMULATED

SMALL = (
    "study.motors=[bldc-12n14p, HDS6A-0104A]", "study.gearboxes=[reference-5-1]",
    "study.filters.names=[none, low_pass_20Hz]",
)  # fmt: skip


@cache
def rating() -> Rating:
    document = read_document(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
    return rating_of(drawn_study(open_study(overridden(document, SMALL), load_catalog(shipped_folder()))))


def tables(draws: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(1)
    columns = [column.name for column in rating().drawn.results() if column.kind == "float"]
    return {name: rng.uniform(0.02, 0.6, (len(rating().drawn.drives), draws)) for name in columns}


def test_the_totals_are_those_of_the_matrix_at_each_draw() -> None:
    values = tables(3)
    found = rating().ranking(values)
    drives, rows = list(rating().drawn.drives), rating().drawn.study.settings.criteria
    for draw in range(3):
        cells = dict(rating().matrix.cells)
        for drive, filtering in found.combinations:
            for name, row in rows.items():
                if row.metric in SIMULATED:
                    value = values[column_of(row.metric, filtering)][drives.index(drive), draw]
                    cells[(f"{drive} | {filtering}", name)] = Cell(value=float(value))
        whole = kesselring(replace(rating().matrix, cells=cells), profile=TEACHING)
        np.testing.assert_allclose(found.totals[draw], whole.share, rtol=1e-12)
    assert sum(found.shares().values()) == pytest.approx(1)
    assert sum(found.drive_shares().values()) == pytest.approx(1)


def test_a_drive_that_cannot_run_at_a_draw_is_not_best_there() -> None:
    values = tables(4)
    for table in values.values():
        table[0, 2] = np.nan
    found = rating().ranking(values)
    first = next(iter(rating().drawn.drives))
    assert found.combinations[found.best[2]][0] != first
    assert distribution(next(iter(values.values()))[0]).draws == 3  # type: ignore[union-attr]


def test_the_interval_of_the_median_holds_it_in_95_of_100_cases() -> None:
    rng = np.random.default_rng(7)
    held = 0
    for _ in range(400):
        found = distribution(rng.exponential(1.0, 50))
        assert found is not None
        held += found.median_low <= np.log(2) <= found.median_high
    assert 0.93 <= held / 400 <= 0.99
    assert distribution(np.array([np.nan])) is None


def test_the_uncertainty_of_a_share_is_that_of_wilson() -> None:
    assert share_uncertainty(0.5, 10_000) == pytest.approx(0.0098, rel=0.01)
    assert 0 < share_uncertainty(1.0, 100) < 0.02


def test_the_answer_tells_drive_and_filter_apart() -> None:
    drives, filters = list(rating().drawn.drives), rating().drawn.filters
    combinations = tuple((drive, one) for drive in drives for one in filters)
    totals = np.zeros((20, len(combinations)))
    totals[::2, 0], totals[1::2, 1] = 1.0, 1.0  # the first drive with either filter
    told = answer_text(Ranking(combinations, totals, {}))
    assert told.startswith(f"{drives[0]} is the best drive: it is first in 100% of 20 draws (at least 84% of all).")
    assert told.endswith(f"Its best filter is open: {filters[0]} (50%), {filters[1]} (50%).")
    totals[:5] = 0.0
    totals[:5, -1] = 1.0
    told = answer_text(Ranking(combinations, totals, {}))
    assert told.startswith(
        f"No drive is clearly best: what the data sheets leave open decides. {drives[0]} is first in 75%"
    )


def test_draws_without_any_reading_are_refused_with_their_reason() -> None:
    values = {name: np.full_like(table, np.nan) for name, table in tables(2).items()}
    rows = pd.DataFrame({"error": ["the channel torque is missing", None], "out_of_reach": [None, ""]})
    with pytest.raises(InputError, match=r"no drive has a reading at any draw, .*: the channel torque is missing"):
        _ranked(rating(), values, rows)
