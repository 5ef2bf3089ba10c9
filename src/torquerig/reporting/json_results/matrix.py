"""The result of ``torquerig matrix``: elimination, ranking, verdict and findings of a matrix or of published tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from torquerig.decide.lints.audit import audit
from torquerig.decide.lints.finding import Finding
from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import recomputed_kesselring, recomputed_pugh
from torquerig.decide.ranks import competition_ranks
from torquerig.reporting.json_results.values import Missing, known


@dataclass(frozen=True)
class RankedAlternative:
    """An alternative: rank, and points or marks with their extremes; ``share_of_ideal`` is T/T_max of Kesselring."""

    table: str
    method: str
    rank: int
    alternative: str
    total: float
    total_low: float
    total_high: float
    share_of_ideal: float | Missing


@dataclass(frozen=True)
class EliminationResult:
    """What the requirements decide of an alternative, and why."""

    alternative: str
    decision: str
    reasons: tuple[str, ...]


@dataclass(frozen=True)
class FindingResult:
    """An error in a matrix, with its reason and remedy."""

    lint: str
    table: str
    place: str
    what: str
    why: str
    remedy: str


@dataclass(frozen=True)
class MatrixResult:
    """The matrices of a file.

    Parameters
    ----------
    name : str
    verdict, sentence : str
        Certainty of the winner and the answer; empty for published tables.
    ranking : tuple of RankedAlternative
    elimination : tuple of EliminationResult
    pugh : mapping of str to mapping of str to str
        Signs against the baseline, by alternative and criterion.
    findings : tuple of FindingResult
    understood : tuple of str
        How a file without fixed form was read.
    texts : tuple of str
        What ``--trace`` and ``--before`` show.
    written : tuple of str
    """

    name: str
    verdict: str
    sentence: str
    ranking: tuple[RankedAlternative, ...]
    elimination: tuple[EliminationResult, ...]
    pugh: Mapping[str, Mapping[str, str]]
    findings: tuple[FindingResult, ...]
    understood: tuple[str, ...]
    texts: tuple[str, ...]
    written: tuple[str, ...]


def matrix_result(
    made: MatrixAnalysis, *, name: str, texts: Sequence[str] = (), written: Sequence[str] = ()
) -> MatrixResult:
    """Return the result of a decision matrix."""
    found, ranked = made.overall, []
    for row, alternative in enumerate(found.alternatives):
        ranked.append(
            RankedAlternative(
                name, "kesselring", int(found.ranks[row]), alternative, float(found.total[row]),
                float(found.total_low[row]), float(found.total_high[row]), float(found.share[row]),
            )
        )  # fmt: skip
    return MatrixResult(
        name=name, verdict=str(made.verdict.certainty), sentence=made.verdict.sentence(),
        ranking=tuple(sorted(ranked, key=lambda one: (one.rank, one.alternative))),
        elimination=tuple(
            EliminationResult(row.alternative, str(row.decision), tuple(one.sentence() for one in row.remarks))
            for row in made.chart.rows
        ),
        pugh={
            one: dict(zip(made.pugh.criteria, map(str, made.pugh.signs(one)), strict=True))
            for one in made.pugh.alternatives
        },
        findings=tuple(map(_finding, made.findings)), understood=(), texts=tuple(texts), written=tuple(written),
    )  # fmt: skip


def tables_result(tables: TableSet, understood: Sequence[str], *, name: str) -> MatrixResult:
    """Return the result of published tables, recalculated from their cells."""
    ranked = [one for table in tables.tables for one in _ranked(table)]
    return MatrixResult(
        name=name, verdict="", sentence="", ranking=tuple(ranked), elimination=(), pugh={},
        findings=tuple(map(_finding, audit(tables))), understood=tuple(understood), texts=(), written=(),
    )  # fmt: skip


def _ranked(table: MatrixTable) -> list[RankedAlternative]:
    if table.method is Method.ELIMINATION:
        return []
    if table.method is Method.PUGH:
        rated, names = recomputed_pugh(table), table.alternatives
        totals, lows, highs = (one[1:].astype(float) for one in (rated.net_certain, rated.net_low, rated.net_high))
        shares: Sequence[float | None] = [None] * len(names)
    else:
        points = recomputed_kesselring(table)
        names, totals, lows, highs = points.alternatives, points.total, points.total_low, points.total_high
        shares = points.share.tolist() if table.profile.stated else [None] * len(names)
    ranks = competition_ranks(totals).tolist()
    made = [
        RankedAlternative(
            table.name, str(table.method.value), int(rank), name, float(total), float(low), float(high),
            known(share, "the table states no scale of points"),
        )
        for name, rank, total, low, high, share in zip(names, ranks, totals, lows, highs, shares, strict=True)
    ]  # fmt: skip
    return sorted(made, key=lambda one: (one.rank, one.alternative))


def _finding(one: Finding) -> FindingResult:
    return FindingResult(one.lint, one.table, one.place, one.what, one.why, one.remedy)
