"""Lints of printed ranks: they must follow from the printed sums by one convention."""

from __future__ import annotations

from itertools import combinations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import MatrixTable, TableSet
from torquerig.decide.ranks import TIE, competition_ranks, dense_ranks

COMPETITION, DENSE, ORDINAL = "competition (1 2 2 4)", "dense (1 2 2 3)", "ordinal (1 2 3 4)"


def tied_ranks_differ(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find alternatives with the same sum but different ranks."""
    return [
        about(
            table,
            lint="tied sums, different ranks",
            table=table.name,
            what=f"{first[0]} and {second[0]} both have the sum {first[1]:g}, but ranks {first[2]} and {second[2]}",
            why="the table gives no reason for the different ranks",
            remedy="give equal sums the same rank",
        )
        for first, second in combinations(_ranked(table), 2)
        if abs(first[1] - second[1]) < TIE and first[2] != second[2]
    ]


def ranks_follow_no_convention(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find printed ranks that no single convention gives for the printed sums."""
    ranked = _ranked(table)
    if not ranked or conventions(table):
        return []
    sums = [one[1] for one in ranked]
    return [
        about(
            table,
            lint="mixed rank conventions",
            table=table.name,
            what=f"the ranks {_listed([one[2] for one in ranked])} follow no single convention",
            why=f"the sums give {_listed(competition_ranks(sums).tolist())} by {COMPETITION} "
            f"and {_listed(dense_ranks(sums).tolist())} by {DENSE}",
            remedy="state one convention and use it everywhere",
        )
    ]


def conventions_differ(table_set: TableSet) -> list[Finding]:
    """Find tables of one decision whose ranks follow different conventions."""
    by_table = {table.name: found for table in table_set.audited if len(found := conventions(table)) == 1}
    if len({next(iter(found)) for found in by_table.values()}) < 2:
        return []
    return [
        Finding(
            lint="mixed rank conventions",
            table=", ".join(by_table),
            what="; ".join(f"{name} uses {next(iter(found))}" for name, found in by_table.items()),
            why="the same rank means different things in different tables",
            remedy="state one convention and use it everywhere",
        )
    ]


def conventions(table: MatrixTable) -> frozenset[str]:
    """Return the conventions that give the printed ranks from the printed sums; several where there is no tie."""
    ranked = _ranked(table)
    if not ranked:
        return frozenset()
    sums, ranks = [one[1] for one in ranked], [one[2] for one in ranked]
    found = set()
    if competition_ranks(sums).tolist() == ranks:
        found.add(COMPETITION)
    if dense_ranks(sums).tolist() == ranks:
        found.add(DENSE)
    in_order = [total for _, total in sorted(zip(ranks, sums, strict=True))]
    if sorted(ranks) == list(range(1, len(ranks) + 1)) and in_order == sorted(sums, reverse=True):
        found.add(ORDINAL)
    return frozenset(found)


def _ranked(table: MatrixTable) -> list[tuple[str, float, int]]:
    if not table.ranks or not table.sums:
        return []
    triples = zip(table.alternatives, table.sums, table.ranks, strict=True)
    return [(name, total, rank) for name, total, rank in triples if total is not None and rank is not None]


def _listed(ranks: list[int]) -> str:
    return " ".join(str(rank) for rank in ranks)
