"""Lints of names: one name for each thing, and equal marks for equal ratings."""

from __future__ import annotations

import re

from torquerig.decide.lints.finding import Finding, about
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, MatrixTable, TableSet, canonical


def several_names(table_set: TableSet) -> list[Finding]:
    """Find things that have different names in different tables."""
    found = []
    for alias in table_set.aliases:
        used = [
            (name, [table.name for table in table_set.audited if name in table.alternatives]) for name in alias.names
        ]
        shown = [f"{name} ({', '.join(tables)})" for name, tables in used if tables]
        if len(shown) > 1:
            found.append(
                Finding(
                    lint="one thing, several names",
                    table=", ".join(dict.fromkeys(table for _, tables in used for table in tables)),
                    place=alias.place,
                    what="; ".join(shown),
                    why=f"it cannot be looked up; taken as one because: {alias.reason or 'no reason is stated'}",
                    remedy=f"write {alias.names[0]} everywhere",
                )
            )
    return found


def unmatched_names(table_set: TableSet) -> list[Finding]:
    """Find names of a later table that no earlier table holds and no alias explains."""
    found = []
    seen: set[str] = set()
    for table in table_set.audited:
        unknown = [name for name in table.alternatives if seen and not seen & set(_all_names(table_set, name))]
        found += [
            about(
                table,
                lint="unknown name",
                table=table.name,
                what=f"{name!r} is in no earlier table and under no alias",
                why="it cannot be traced to the earlier tables",
                remedy="correct the name or add it to aliases with the reason",
            )
            for name in unknown
        ]
        seen |= set(table.alternatives)
    return found


def same_rating_judged_differently(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find equal ratings with different marks in a row whose mark follows from the rating."""
    found = []
    for row in table.rows:
        groups: dict[str, dict[str, str]] = {}
        for name, entry in zip(table.alternatives, row.entries, strict=True):
            rating = next(
                (table_set.ratings[one] for one in _all_names(table_set, name) if one in table_set.ratings), None
            )
            if row.follows_rating and rating is not None and entry != UNKNOWN:
                groups.setdefault(rating, {})[name] = str(canonical(entry))
        for rating, marks in groups.items():
            if len(set(marks.values())) > 1:
                listed = ", ".join(f"{name} {mark}" for name, mark in marks.items())
                found.append(
                    about(
                        row,
                        lint="same rating, different marks",
                        table=table.name,
                        what=f"{row.criterion!r}: all rated {rating}, but {listed}",
                        why="the mark follows from the rating; marks may be swapped, or the reference shaft differs",
                        remedy="state at which shaft the limit applies and rate again",
                    )
                )
    return found


def nearly_same_names(table: MatrixTable, table_set: TableSet) -> list[Finding]:
    """Find names in one table that differ only in case, spaces, signs or leading zeros."""
    groups: dict[str, list[str]] = {}
    for name in table.alternatives:
        groups.setdefault(_bare(name), []).append(name)
    return [
        about(
            table,
            lint="nearly the same name",
            table=table.name,
            what=f"{' and '.join(map(repr, names))} differ only in their spelling",
            why="one thing may be rated twice and take two ranks",
            remedy="keep one of them, or give them names that show the difference",
        )
        for names in groups.values()
        if len(names) > 1
    ]


def _bare(name: str) -> str:
    return "".join(part.lstrip("0") or "0" for part in re.findall(r"[a-z]+|[0-9]+", name.lower()))


def _all_names(table_set: TableSet, name: str) -> tuple[str, ...]:
    return next((alias.names for alias in table_set.aliases if name in alias.names), (name,))
