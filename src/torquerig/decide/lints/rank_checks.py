"""Whether the printed ranks follow from the printed sums, by one convention."""

from __future__ import annotations

from itertools import combinations

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.sheet import Book, Sheet
from torquerig.decide.ranks import TIE, competition_ranks, dense_ranks

COMPETITION, DENSE, ORDINAL = "competition (1 2 2 4)", "dense (1 2 2 3)", "ordinal (1 2 3 4)"


def tied_ranks_differ(sheet: Sheet, book: Book) -> list[Finding]:
    """Find alternatives with the same sum but different ranks."""
    return [
        about(
            sheet,
            lint="tied sums, different ranks",
            table=sheet.name,
            what=f"{first[0]} and {second[0]} both have the sum {first[1]:g}, but ranks {first[2]} and {second[2]}",
            why="the table prefers one of them for no reason that it shows",
            remedy="let ties share a rank",
        )
        for first, second in combinations(_ranked(sheet), 2)
        if abs(first[1] - second[1]) < TIE and first[2] != second[2]
    ]


def ranks_follow_no_convention(sheet: Sheet, book: Book) -> list[Finding]:
    """Find printed ranks that no single convention gives for the printed sums."""
    ranked = _ranked(sheet)
    if not ranked or conventions(sheet):
        return []
    sums = [one[1] for one in ranked]
    return [
        about(
            sheet,
            lint="mixed rank conventions",
            table=sheet.name,
            what=f"the ranks {_listed([one[2] for one in ranked])} follow no one convention",
            why=f"the sums give {_listed(competition_ranks(sums).tolist())} by {COMPETITION} "
            f"and {_listed(dense_ranks(sums).tolist())} by {DENSE}",
            remedy="declare one convention and keep to it",
        )
    ]


def conventions_differ(book: Book) -> list[Finding]:
    """Find tables of one decision whose ranks follow different conventions."""
    told = {sheet.name: found for sheet in book.audited if len(found := conventions(sheet)) == 1}
    if len({next(iter(found)) for found in told.values()}) < 2:
        return []
    return [
        Finding(
            lint="mixed rank conventions",
            table=", ".join(told),
            what="; ".join(f"{name} counts by {next(iter(found))}" for name, found in told.items()),
            why="the same rank means different things in different tables",
            remedy="declare one convention and keep to it",
        )
    ]


def conventions(sheet: Sheet) -> frozenset[str]:
    """Return the conventions that give the printed ranks from the printed sums; several where there is no tie."""
    ranked = _ranked(sheet)
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


def _ranked(sheet: Sheet) -> list[tuple[str, float, int]]:
    if not sheet.ranks or not sheet.sums:
        return []
    triples = zip(sheet.alternatives, sheet.sums, sheet.ranks, strict=True)
    return [(name, total, rank) for name, total, rank in triples if total is not None and rank is not None]


def _listed(ranks: list[int]) -> str:
    return " ".join(str(rank) for rank in ranks)
