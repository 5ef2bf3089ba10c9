"""Run a study of many draws into its store, and read it back as tables."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.cases import Limits, Progress, StudyRun, run_cases
from torquerig.cases.block import Engine
from torquerig.errors import InputError
from torquerig.study.candidates import scenario_of
from torquerig.study.monte_carlo.design import Design, Method, design_of
from torquerig.study.monte_carlo.drawn_case import drawn_rows
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, cases_of_draws
from torquerig.study.monte_carlo.lost_draws import LostDraws, lost_draws
from torquerig.study.monte_carlo.ranking import Floats, Ranking, Rating, rating_of, tables_of
from torquerig.study.monte_carlo.sensitivity import Sensitivity, sensitivity

if TYPE_CHECKING:
    import pandas as pd

LANES = 8  # rigs that the vector registers hold
LARGEST_BLOCK = 64  # cases; with drawn pole pairs and slots few rigs of eight are alike
SAMPLES = 3_000_000  # of all cases of a block: some 200 MB of recordings in each worker
SECONDS = 600.0  # [s] on the clock after which a case is given up; one takes some 0.05 s


@dataclass(frozen=True)
class Draws:
    """The draws of a study: the run that computed or found them, their tables, the ranking, and what has no figures."""

    run: StudyRun
    tables: dict[str, Floats]
    ranking: Ranking
    lost: Mapping[str, LostDraws]


def run_draws(
    drawn: DrawnStudy, draws: int, *, folder: Path, engine: Engine | None = None, seconds: float | None = SECONDS,
    progress: Callable[[Progress], None] | None = None,
) -> Draws:  # fmt: skip
    """Compute the draws that the store lacks, and return all of them.

    A case is given up, and tried again by the next call, after ``seconds`` on the clock.

    Raises
    ------
    InputError
        For a store of another study, and as :func:`torquerig.cases.run_cases`.
    """
    rating = rating_of(drawn)
    cases = cases_of_draws(drawn, draws)
    run = run_cases(
        drawn_rows, drawn, cases, folder=folder, identity=drawn.identity("draws"), engine=engine,
        block_size=_block_size(drawn), limits=Limits(seconds=seconds), progress=progress,
    )  # fmt: skip
    rows = run.rows()
    asked = rows[rows["draw"] < draws]
    tables = tables_of(drawn, asked)
    return Draws(run, tables, _ranked(rating, tables, asked), lost_draws(asked))


@dataclass(frozen=True)
class DesignedDraws:
    """The rows of a sensitivity study, and what they say."""

    run: StudyRun
    design: Design
    found: Sensitivity


def run_design(
    drawn: DrawnStudy, method: Method, count: int, *, folder: Path, engine: Engine | None = None,
    seconds: float | None = SECONDS, progress: Callable[[Progress], None] | None = None,
) -> DesignedDraws:  # fmt: skip
    """Compute the rows of a Sobol or Morris design that the store lacks, and return the effect of each open value.

    Raises
    ------
    InputError
        As :func:`run_draws`, and where a drive has no reading error at a row.
    """
    rating, design = rating_of(drawn), design_of(drawn, method, count)
    cases = design.cases(drawn)
    run = run_cases(
        drawn_rows, drawn, cases, folder=folder, identity=drawn.identity(design.plan), engine=engine,
        block_size=_block_size(drawn), limits=Limits(seconds=seconds), progress=progress,
    )  # fmt: skip
    rows = run.rows()
    asked = rows[rows["case"].isin([case.number for case in cases])]
    tables = design.filled(tables_of(drawn, asked))
    found = sensitivity(design, tables, _ranked(rating, tables, asked), prices=rating.prices)
    return DesignedDraws(run, design, found)


def _ranked(rating: Rating, tables: Mapping[str, Floats], rows: pd.DataFrame) -> Ranking:
    """Return the ranking; InputError with the reason of the first case where not one has a reading."""
    found = rating.ranking(tables)
    if found.combinations and found.is_empty:
        reasons = [*rows["error"].dropna(), *(one for one in rows["out_of_reach"].dropna() if one)]
        why = f": {reasons[0]}" if reasons else ""
        raise InputError(f"no drive has a reading at any draw, so there is nothing to rank{why}")
    return found


def _block_size(drawn: DrawnStudy) -> int:
    """Return how many cases a worker gets at once: as many as memory allows, eight at least."""
    study, first = drawn.study, next(iter(drawn.drives.values()))
    rate = scenario_of(first, study, seed=study.settings.seed).recording.sample_rate
    return max(LANES, min(LARGEST_BLOCK, int(SAMPLES / (rate * study.settings.duration))))
