"""Whether each thing is called by one name, and judged as itself."""

from __future__ import annotations

import re

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.sheet import UNKNOWN, Book, Sheet, canonical


def several_names(book: Book) -> list[Finding]:
    """Find things that stand under different names in different tables."""
    found = []
    for alias in book.aliases:
        used = [(name, [sheet.name for sheet in book.audited if name in sheet.alternatives]) for name in alias.names]
        shown = [f"{name} ({', '.join(tables)})" for name, tables in used if tables]
        if len(shown) > 1:
            found.append(
                Finding(
                    lint="one thing, several names",
                    table=", ".join(dict.fromkeys(table for _, tables in used for table in tables)),
                    place=alias.place,
                    what="; ".join(shown),
                    why=f"nobody can look it up; taken as one because: {alias.reason or 'no reason is stated'}",
                    remedy=f"write {alias.names[0]} everywhere",
                )
            )
    return found


def unmatched_names(book: Book) -> list[Finding]:
    """Find names of a later table that no earlier table holds and no alias explains."""
    found = []
    seen: set[str] = set()
    for sheet in book.audited:
        strange = [name for name in sheet.alternatives if seen and not seen & set(_all_names(book, name))]
        found += [
            about(
                sheet,
                lint="a name from nowhere",
                table=sheet.name,
                what=f"{name!r} stands in no earlier table, under no alias",
                why="it cannot be traced to what was examined before",
                remedy="correct the name or add it to aliases with the reason",
            )
            for name in strange
        ]
        seen |= set(sheet.alternatives)
    return found


def same_rating_judged_differently(sheet: Sheet, book: Book) -> list[Finding]:
    """Find equal ratings with different marks in a row whose answer follows from the rating."""
    found = []
    for row in sheet.rows:
        groups: dict[str, dict[str, str]] = {}
        for name, entry in zip(sheet.alternatives, row.entries, strict=True):
            rating = next((book.ratings[one] for one in _all_names(book, name) if one in book.ratings), None)
            if row.follows_rating and rating is not None and entry != UNKNOWN:
                groups.setdefault(rating, {})[name] = str(canonical(entry))
        for rating, marks in groups.items():
            if len(set(marks.values())) > 1:
                listed = ", ".join(f"{name} {mark}" for name, mark in marks.items())
                found.append(
                    about(
                        row,
                        lint="same rating, judged differently",
                        table=sheet.name,
                        what=f"{row.criterion!r}: all rated {rating}, but {listed}",
                        why="the answer follows from the rating; marks look swapped or the reference shaft differs",
                        remedy="state where the limit holds and judge again",
                    )
                )
    return found


def nearly_same_names(sheet: Sheet, book: Book) -> list[Finding]:
    """Find names in one table that differ only in case, spaces, signs or leading zeros."""
    groups: dict[str, list[str]] = {}
    for name in sheet.alternatives:
        groups.setdefault(_bare(name), []).append(name)
    return [
        about(
            sheet,
            lint="nearly the same name",
            table=sheet.name,
            what=f"{' and '.join(map(repr, names))} differ only in their spelling",
            why="one thing may be judged twice, and take two ranks",
            remedy="keep one of them, or give them names that say how they differ",
        )
        for names in groups.values()
        if len(names) > 1
    ]


def _bare(name: str) -> str:
    return "".join(part.lstrip("0") or "0" for part in re.findall(r"[a-z]+|[0-9]+", name.lower()))


def _all_names(book: Book, name: str) -> tuple[str, ...]:
    return next((alias.names for alias in book.aliases if name in alias.names), (name,))
