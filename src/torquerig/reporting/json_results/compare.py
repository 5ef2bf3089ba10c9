"""The result of ``torquerig compare``: ranking, eliminated drives with their reasons, verdict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from torquerig.decide.eliminate import Decision
from torquerig.reporting.figures.shades import SHARES
from torquerig.reporting.json_results.figures import FigureResult, figure_result
from torquerig.reporting.json_results.values import Missing, Quantity
from torquerig.study.results import DriveResult, StudyRuns
from torquerig.study.scoring import Decided
from torquerig.study.sweep import SweptPoint, least_error
from torquerig.study.verdict import Verdict
from torquerig.study.what_if import Change


@dataclass(frozen=True)
class RankedCombination:
    """A drive with a filter: rank, share of the ideal points [1], and its figures.

    ``rank_best`` and ``rank_worst`` are the extremes over the intervals of the data.
    """

    rank: int
    rank_best: int
    rank_worst: int
    drive: str
    motor: str
    gearbox: str
    ratio: float
    filter: str
    decision: str
    share_of_ideal: float
    reading_error: FigureResult
    disturbance: FigureResult
    price: FigureResult


@dataclass(frozen=True)
class NotRankedDrive:
    """A drive that a requirement eliminates or leaves open, or that cannot run: every reason in one sentence each."""

    drive: str
    decision: str
    reasons: tuple[str, ...]


@dataclass(frozen=True)
class DriveShares:
    """The rms of each share of the reading of a drive; empty where the drive cannot run."""

    drive: str
    rms: Mapping[str, Quantity]
    percent_of_power: Mapping[str, float]


@dataclass(frozen=True)
class VerdictResult:
    """What to do, and how sure that is: ``p_best`` is the share of Monte Carlo samples in which the winner is best."""

    winner: str
    sentence: str
    certainty: str
    p_best: float
    best_shares: Mapping[str, float]
    open_facts: tuple[str, ...]


@dataclass(frozen=True)
class ChangeResult:
    """The effect of ``--set`` on a drive: reading error and disturbance before and after, in the unit of the study."""

    before: str
    after: str
    unit: str
    error_before: float | Missing
    error_after: float | Missing
    disturbance_before: float | Missing
    disturbance_after: float | Missing


@dataclass(frozen=True)
class DriveAtPoint:
    """A drive at a point of a sweep: its filter with the least reading error."""

    drive: str
    filter: str
    reading_error: Quantity


@dataclass(frozen=True)
class SweptPointResult:
    """A computed point of a sweep: the values as the scenario states them, the winner, every simulated drive."""

    values: Mapping[str, str]
    winner: str
    certainty: str
    drives: tuple[DriveAtPoint, ...]


@dataclass(frozen=True)
class CompareResult:
    """A study: its verdict, ranking and eliminated drives, and the files that were written."""

    title: str
    seed: int
    verdict: VerdictResult
    ranking: tuple[RankedCombination, ...]
    not_ranked: tuple[NotRankedDrive, ...]
    shares: tuple[DriveShares, ...]
    changes: tuple[ChangeResult, ...]
    notes: tuple[str, ...]
    written: tuple[str, ...]
    sweep: tuple[SweptPointResult, ...] = ()


@dataclass(frozen=True)
class PointResult:
    """The winner at one operating point of a study."""

    occupancy_percent: float
    particle_size_mm: float
    winner: str
    certainty: str
    reading_error: FigureResult | Missing
    written: str


@dataclass(frozen=True)
class ComparePointsResult:
    """The winners of a study at all its operating points (``--all-points``)."""

    json_name: ClassVar[str] = "compare-points"
    title: str
    seed: int
    points: tuple[PointResult, ...]


def compare_result(
    runs: StudyRuns, decided: Decided, answer: Verdict, *, changes: Sequence[Change], notes: Sequence[str],
    written: Sequence[str], swept: Sequence[SweptPoint] = (),
) -> CompareResult:  # fmt: skip
    """Return the result of a study."""
    study = runs.study
    return CompareResult(
        title=str(study.document.data.get("title", study.document.path.stem)),
        seed=study.settings.seed,
        verdict=VerdictResult(
            winner=answer.winner, sentence=answer.sentence, certainty=str(answer.certainty), p_best=answer.p_best,
            best_shares=dict(answer.best_shares), open_facts=answer.open_facts,
        ),
        ranking=tuple(_ranked(name, decided) for name in decided.ranked()),
        not_ranked=not_ranked(runs, decided),
        shares=tuple(map(_shares, runs.drives)),
        changes=tuple(_change(one, study.effort_unit) for one in changes),
        notes=tuple(notes),
        written=tuple(written),
        sweep=tuple(_swept(one) for one in swept),
    )  # fmt: skip


def _swept(point: SweptPoint) -> SweptPointResult:
    drives = []
    for one in point.runs.drives:
        found = least_error(one)
        if found is not None:
            drives.append(DriveAtPoint(one.candidate.name, found[0], Quantity(found[1], one.disturbance.unit)))
    return SweptPointResult(dict(point.values), point.verdict.winner, str(point.verdict.certainty), tuple(drives))


def not_ranked(runs: StudyRuns, decided: Decided) -> tuple[NotRankedDrive, ...]:
    """Return the drives that a requirement eliminates, leaves open or sends back, and those that cannot run."""
    reach = {one.candidate.name: one.out_of_reach for one in runs.drives}
    found = []
    for row in decided.chart.rows:
        sentences = [one.sentence() for one in row.remarks]
        why = reach.get(row.alternative, "")
        if row.decision is not Decision.PURSUE or why:
            found.append(NotRankedDrive(row.alternative, str(row.decision), (*([why] if why else []), *sentences)))
    return tuple(found)


def _ranked(name: str, decided: Decided) -> RankedCombination:
    made, overall = decided.alternatives[name], decided.overall
    place = overall.alternatives.index(name)
    best, worst = overall.rank_range
    candidate = made.drive.candidate
    decisions = {row.alternative: str(row.decision) for row in decided.chart.rows}
    return RankedCombination(
        rank=int(overall.ranks[place]), rank_best=int(best[place]), rank_worst=int(worst[place]), drive=candidate.name,
        motor=candidate.motor, gearbox=candidate.gearbox, ratio=candidate.ratio, filter=made.chain,
        decision=decisions[candidate.name], share_of_ideal=float(overall.share[place]),
        reading_error=figure_result(made.drive.chains[made.chain].truth_error),
        disturbance=figure_result(made.drive.disturbance), price=figure_result(made.drive.margins["price"]),
    )  # fmt: skip


def _shares(drive: DriveResult) -> DriveShares:
    if drive.shares is None:
        return DriveShares(drive.candidate.name, {}, {})
    unit = drive.disturbance.unit
    rms = {name: Quantity(float(getattr(drive.shares, name)), unit) for name in SHARES}
    return DriveShares(drive.candidate.name, rms, {name: float(drive.shares.percent()[name]) for name in SHARES})


def _change(one: Change, unit: str) -> ChangeResult:
    def figure(value: float | None) -> float | Missing:
        return Missing("the drive cannot run") if value is None else value

    return ChangeResult(
        before=one.before, after=one.after, unit=unit, error_before=figure(one.error_before),
        error_after=figure(one.error_after), disturbance_before=figure(one.disturbance_before),
        disturbance_after=figure(one.disturbance_after),
    )  # fmt: skip
