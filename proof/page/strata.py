"""Scores by hidden effects, size, mechanism and runs, and by parameter."""

from __future__ import annotations

from collections.abc import Mapping

from proof.page.cells import error_cells, percent, share_cells
from proof.scoring.summary import Share, Summary
from torquerig.reporting.layout import Table, number, words
from torquerig.reporting.matrix.chapters import Chapter


def strata(ours: Summary) -> Chapter:
    """Return one table for each way of grouping the trials."""
    tables = tuple(_group(title, rows) for title, rows in ours.groups.items() if title != "all")
    return Chapter(anchor="strata", title="Scores by group", tables=tables)


def parameters(ours: Summary) -> Chapter:
    """Return relative errors and coverage of the stated 95 % intervals."""
    rows = {"identifying parameters": ours.first_named, "every parameter": ours.every_parameter, **ours.by_parameter}
    table = Table(
        caption="Relative error of the parameters of right findings",
        head=("", "number", "median", "90 % quantile", "95 % intervals that contain the true value"),
        rows=tuple((*words(name), *error_cells(row)) for name, row in rows.items()),
        note="Required: median 5 % or less, 90 % quantile 15 % or less, 90 to 98 % of the intervals.",
    )
    return Chapter(anchor="parameters", title="Parameters", tables=(table,))


def laws_compared(drawn: Summary, same: Summary) -> Chapter:
    """Return the scores of the same rigs with drawn laws and with the simulator's laws."""
    rows = []
    for name, summary in (("laws drawn for each rig", drawn), ("laws of the simulator", same)):
        exact, within = summary.groups["all"]["all"]
        rows.append(
            (*words(name), *share_cells(exact, at_least=True), number(percent(within.hits / max(within.trials, 1))),
             number(f"{summary.false_names.hits}"))
        )  # fmt: skip
    table = Table(caption="Same rigs, effects and runs",
                  head=("", "exactly right", "share", "bound", "or within the class", "false names"),
                  rows=tuple(rows))  # fmt: skip
    return Chapter(anchor="laws", title="Effect of laws that differ from the simulator", tables=(table,))


def _group(title: str, rows: Mapping[str, tuple[Share, Share]]) -> Table:
    body = tuple(
        (*words(name), *share_cells(exact, at_least=True), number(percent(within.hits / max(within.trials, 1))))
        for name, (exact, within) in rows.items()
    )
    return Table(caption=f"By {title}", head=("", "exactly right", "share", "bound", "or within the class"), rows=body)
