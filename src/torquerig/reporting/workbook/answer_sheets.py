"""Result sheets of a matrix workbook: verdict, rank shares, missing values, errors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from torquerig.decide.lints.finding import Finding
    from torquerig.decide.matrix_analysis import MatrixAnalysis

Looks = dict[str, Any]


def write_answers(sheet: Any, looks: Looks, worked: MatrixAnalysis) -> None:
    """Write the verdict, the share of samples of each rank, and the ratings of the S-diagram."""
    sheet.set_column(0, 0, 34)
    sheet.set_column(1, 12, 13)
    sheet.write_string(0, 0, worked.verdict.sentence(), looks["bold"])
    found = worked.acceptability
    together = found["together"]
    ranks = [f"rank {place + 1}" for place in range(len(together.alternatives))]
    _row(sheet, 2, ["best in share of samples", *found, "mean rank", *ranks], looks["head"])
    for row, name in enumerate(together.alternatives):
        shares = [float(one.p_best[row]) for one in found.values()]
        _row(sheet, 3 + row, [name, *shares, float(together.mean_rank[row]), *together.shares[row].tolist()],
             looks["three"])  # fmt: skip
    line = 5 + len(together.alternatives)
    if worked.strength is not None:
        made = worked.strength
        _row(sheet, line, ["", "technical x", "economic y", "(x+y)/2", "sqrt(x y)", "technically"], looks["head"])
        for row, (name, word) in enumerate(zip(made.alternatives, made.grades(), strict=True), start=1):
            numbers = (made.technical.value, made.economic.value, made.arithmetic, made.hyperbolic)
            _row(sheet, line + row, [name, *(float(one[row - 1]) for one in numbers), word], looks["three"])


def write_ask(sheet: Any, looks: Looks, worked: MatrixAnalysis) -> None:
    """Write the missing values, the most useful first."""
    _row(sheet, 0, ["missing value", "changes the winner in", "gain in T/T_max", "question"], looks["head"])
    sheet.set_column(0, 0, 50)
    sheet.set_column(1, 2, 14)
    sheet.set_column(3, 3, 110)
    for row, one in enumerate(worked.missing, start=1):
        _row(sheet, row, [one.fact, one.p_change, one.gain, one.sentence()], looks["three"])


def write_findings(sheet: Any, looks: Looks, findings: Sequence[Finding]) -> None:
    """Write the errors of the tables."""
    _row(sheet, 0, ["table", "check", "error", "reason", "remedy"], looks["head"])
    for column, width in enumerate((14, 30, 70, 60, 60)):
        sheet.set_column(column, column, width)
    for row, one in enumerate(findings, start=1):
        _row(sheet, row, [one.table, one.lint, one.what, one.why, one.remedy], looks["wrap"])


def _row(sheet: Any, row: int, values: Sequence[str | float], look: Any) -> None:
    for column, value in enumerate(values):
        if isinstance(value, str):
            sheet.write_string(row, column, value, look if row == 0 or column else None)
        else:
            sheet.write_number(row, column, value, look)
