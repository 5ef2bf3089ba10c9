"""Edits between two versions of a matrix, and the changes of the ranking."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from torquerig.decide.matrix_io.matrix_writing import case_data

if TYPE_CHECKING:
    from torquerig.decide.case import MatrixCase
    from torquerig.decide.matrix_analysis import MatrixAnalysis


@dataclass(frozen=True, kw_only=True)
class Edit:
    """One changed entry: its key in the file, and its value before and after; None where it is absent."""

    key: str
    before: Any
    after: Any


@dataclass(frozen=True, kw_only=True)
class RankingChanges:
    """The changes of the ranking that follow from the edits.

    Parameters
    ----------
    edits : tuple of Edit
    winners_before, winners_after : tuple of str
    ranks : mapping-like tuple of (alternative, rank before or None, rank after or None)
        Only those whose rank changed.
    reversed_pairs : tuple of (str, str)
        Pairs of which the second now ranks above the first, both rated before and after. When alternatives were only
        added or removed there is none, because points do not depend on the others.
    """

    edits: tuple[Edit, ...]
    winners_before: tuple[str, ...]
    winners_after: tuple[str, ...]
    ranks: tuple[tuple[str, int | None, int | None], ...]
    reversed_pairs: tuple[tuple[str, str], ...]


def edits_between(before: MatrixCase, after: MatrixCase) -> tuple[Edit, ...]:
    """Return every entry that differs: baseline, scale, criteria, weights, limits, points and cells."""
    old, new = dict(_entries(case_data(before))), dict(_entries(case_data(after)))
    return tuple(
        Edit(key=key, before=old.get(key), after=new.get(key))
        for key in dict.fromkeys((*old, *new))
        if old.get(key) != new.get(key)
    )


def ranking_changes(before: MatrixAnalysis, after: MatrixAnalysis) -> RankingChanges:
    """Return the edits between two analysed cases with the ranks that they changed."""
    ranks = [dict(zip(one.overall.alternatives, one.overall.ranks.tolist(), strict=True)) for one in (before, after)]
    names = dict.fromkeys((*before.case.matrix.alternatives, *after.case.matrix.alternatives))
    both = [name for name in names if name in ranks[0] and name in ranks[1]]
    return RankingChanges(
        edits=edits_between(before.case, after.case),
        winners_before=before.verdict.winners,
        winners_after=after.verdict.winners,
        ranks=tuple(
            (name, ranks[0].get(name), ranks[1].get(name)) for name in names if ranks[0].get(name) != ranks[1].get(name)
        ),
        reversed_pairs=tuple(
            (first, second)
            for first in both
            for second in both
            if ranks[0][first] < ranks[0][second] and ranks[1][first] > ranks[1][second]
        ),
    )


def _entries(data: Any, key: str = "") -> Iterator[tuple[str, Any]]:
    if not isinstance(data, dict) or not data:
        yield key, data
        return
    for name, held in data.items():
        yield from _entries(held, f"{key}.{name}" if key else str(name))
