"""Calculation of every cell of a study as compact tables, one drive at a time, with its catalog values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.reporting.layout import Cell, Table, words

if TYPE_CHECKING:
    from torquerig.decide.trace import CellTrace
    from torquerig.study.scoring import Decided
    from torquerig.study.trace import TracedDrive

FEW = 4  # catalog values that are named in the cell itself


@dataclass(frozen=True, kw_only=True)
class DriveTables:
    """Tables of one drive on the page: anchor, heading, the two tables, and the result."""

    anchor: str
    title: str
    cells: Table
    values: Table
    end: str


def drive_tables(traced: Sequence[TracedDrive]) -> tuple[DriveTables, ...]:
    """Return the tables of every drive."""
    return tuple(
        DriveTables(
            anchor=trace_anchor(one.drive),
            title=one.combination or f"{one.drive}, eliminated",
            cells=cells_table(one),
            values=values_table(one),
            end="; ".join(f"{label}: {text}" for label, text in one.end),
        )
        for one in traced
    )


def trace_anchor(drive: str) -> str:
    """Return the anchor of a drive's cells on the page."""
    return f"way-{re.sub(r'[^A-Za-z0-9]+', '-', drive).strip('-')}"


def functions_table(decided: Decided) -> Table:
    """Return the value function and the weight of each criterion, the same for every drive."""
    result = decided.overall
    rows = []
    for one in decided.matrix.criteria:
        knots = one.value.knots if one.value else ()
        unit = "" if one.unit == "1" else f" {one.unit}"
        points = ", ".join(f"{value:g}{unit}: {points:g}" for value, points in knots)
        share = f"{result.normalised[result.criteria.index(one.name)]:.3f}" if one.name in result.criteria else "-"
        rows.append((*words(one.name, points, f"{one.weight:g}", share), Cell(text=one.purpose, word="remark")))
    return Table(
        caption="Value functions and weights, the same for every drive",
        head=("criterion", "value: points (linear between, constant outside)", "weight as given", "normalised",
              "purpose"),
        rows=tuple(rows),
    )  # fmt: skip


def cells_table(one: TracedDrive) -> Table:
    """Return a row per criterion and requirement: catalog values, calculation, value and points."""
    rows = tuple(
        (*words(trace.criterion), Cell(text=_catalog(trace), word="remark narrow"),
         Cell(text="; ".join(trace.texts("metric")), word="remark narrow"),
         *words(_value(trace)), Cell(text=_rating(trace), word="remark narrow"),
         *words(_before(trace, "points", ", on the scale"), _after(trace, "weight", ": adds ").removesuffix(" to T")))
        for trace in (*one.criteria, *one.requirements)
    )  # fmt: skip
    return Table(
        caption=f"{one.combination or one.drive}: from the catalog to the points",
        head=("criterion or requirement", "catalog values", "calculation", "value", "Pugh sign or requirement",
              "points", "adds to T"),
        rows=rows,
    )  # fmt: skip


def values_table(one: TracedDrive) -> Table:
    """Return each catalog value behind the drive's cells, with interval, evidence and source."""
    rows = tuple(
        (*words(origin.name), Cell(text=origin.shown, word="name"), *words(origin.evidence, origin.source),
         Cell(text=", ".join(used), word="remark narrow"))
        for origin, used in one.origins
    )  # fmt: skip
    return Table(
        caption=f"The catalog values behind {one.drive}",
        head=("catalog value", "known", "evidence", "source", "used for"), rows=rows,
    )  # fmt: skip


def _catalog(trace: CellTrace) -> str:
    values = trace.texts("catalog")
    if len(values) > FEW:
        return f"{len(values)} values of motor, gearbox, sensor and coupling, listed below"
    return "; ".join(values) or "none"


def _value(trace: CellTrace) -> str:
    missing = (f"missing: {text}" for text in trace.texts("missing"))
    return "; ".join((*(text.partition(", from ")[0] for text in trace.texts("value")), *missing))


def _rating(trace: CellTrace) -> str:
    return "; ".join(trace.texts("requirement")) or _before(trace, "Pugh", " against ")


def _before(trace: CellTrace, label: str, end: str) -> str:
    return "; ".join(text.partition(end)[0] for text in trace.texts(label))


def _after(trace: CellTrace, label: str, start: str) -> str:
    return "; ".join(text.partition(start)[2] for text in trace.texts(label))
