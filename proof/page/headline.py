"""All scores compared with their requirements, and with the baselines on the same trials."""

from __future__ import annotations

from collections.abc import Mapping

from proof.baselines import TITLES
from proof.page.cells import error_cells, percent, share_cells
from proof.scoring.summary import Summary
from torquerig.reporting.layout import Cell, Table, number, words
from torquerig.reporting.matrix.chapters import Chapter

Row = tuple[Cell, ...]


def headline(ours: Summary) -> Chapter:
    """Return the scores of the diagnosis with exact bounds and requirements."""
    table = Table(
        caption="All blind trials",
        head=("", "count", "result", "one-sided 95 % bound", "required", ""),
        rows=(*_shares(ours), *_figures(ours)),
        note="Exactly right: verdict and every name. Within the class: the true mechanism is among the equivalent "
        "mechanisms of a finding. Bounds: Clopper and Pearson. A case with one false name counts as false, even if its "
        "other names are right.",
    )
    return Chapter(anchor="reached", title="Results", tables=(table,))


def baselines_compared(summaries: Mapping[str, Summary]) -> Chapter:
    """Return a table of the diagnosis and the baselines on the same trials."""
    rows = tuple(_method(TITLES[name], summary) for name, summary in summaries.items())
    table = Table(
        caption="Scores on the same recordings",
        head=("", "exactly right", "or within the class", "false names", "false names on clean rigs",
              "unexplained where true",
              "median error of first parameter", "held-out residual removed", "calibration error"),
        rows=rows, emphasised=frozenset({0}),
        note="All baselines start from the calibrated nominal model of the diagnosis. Only the sparse regression has a "
        "model to evaluate on held-out data, with a different residual. Its improvement counts rigs with a right name.",
    )  # fmt: skip
    return Chapter(anchor="baselines", title="Comparison with the baselines", tables=(table,))


def _shares(ours: Summary) -> tuple[Row, ...]:
    exact, within = ours.groups["all"]["all"]
    rows = (
        ("exactly right", exact, True, 0.95),
        ("exactly right or within the class", within, True, 0.95),
        ("false names", ours.false_names, False, None),
        ("false names on rigs without hidden effects", ours.false_on_blank, False, 0.0),
        ("unexplained where true", ours.unexplained_where_due, True, 0.9),
        ("held-out residual worse by more than 1 %", ours.harmed, False, 0.0),
    )
    return tuple(
        (
            *words(name),
            *share_cells(share, at_least=at_least),
            *_requirement(_ratio(share.hits, share.trials), limit, at_least),
        )
        for name, share, at_least, limit in rows
    )


def _figures(ours: Summary) -> tuple[Row, ...]:
    first, calibration = ours.first_named, ours.calibration
    rows = (
        ("median error of the identifying parameter", None if first is None else first.median, 0.05, False),
        ("its 90 % quantile", None if first is None else first.p90, 0.15, False),
        ("held-out residual removed, median", ours.improvement, None, True),
        (f"share of the oracle's improvement, median of {ours.oracles} rigs", ours.of_oracle, 0.9, True),
        ("expected calibration error", None if calibration is None else calibration.expected_error, 0.05, False),
    )
    return tuple(
        (*words(name), number(""), number(percent(value)), number(""), *_requirement(value, limit, at_least))
        for name, value, limit, at_least in rows
    )


def _ratio(hits: int, trials: int) -> float | None:
    return hits / trials if trials else None


def _requirement(value: float | None, limit: float | None, at_least: bool) -> tuple[Cell, Cell]:
    """Return the requirement and whether the value meets it."""
    if limit is None:
        return number("-"), Cell(text="")
    sign = "≥" if at_least else "≤"
    if value is None:
        return number(f"{sign} {percent(limit, 0)}"), Cell(text="unknown")
    met = value >= limit if at_least else value <= limit
    return number(f"{sign} {percent(limit, 0)}"), Cell(text="met" if met else "missed", word="mark")


def _method(title: str, summary: Summary) -> Row:
    exact, within = summary.groups["all"]["all"]
    shares = ((exact, True), (within, True), (summary.false_names, False), (summary.false_on_blank, False),
              (summary.unexplained_where_due, True))  # fmt: skip
    cells = [
        number(
            percent(_ratio(share.hits, share.trials)), title="; ".join(c.text for c in share_cells(share, at_least=up))
        )
        for share, up in shares
    ]
    error = error_cells(summary.first_named)[1]
    calibration = None if summary.calibration is None else summary.calibration.expected_error
    return (*words(title), *cells, error, number(percent(summary.improvement)), number(percent(calibration)))
