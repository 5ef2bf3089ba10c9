"""The whole text of ``torquerig matrix``: published tables audited, or a user's matrix analysed."""

from __future__ import annotations

from pathlib import Path

from torquerig.decide.lints.audit import audit
from torquerig.decide.matrix_analysis import MatrixAnalysis, analyse_matrix
from torquerig.decide.matrix_io.certainty_text import (
    acceptability_text,
    convergence_text,
    flips_text,
    missing_facts_text,
    near_misses_text,
    pareto_text,
    strength_text,
    verdict_text,
)
from torquerig.decide.matrix_io.matrix_file import matrix_from
from torquerig.decide.matrix_io.matrix_table import TableSet
from torquerig.decide.matrix_io.opened import OpenedMatrix, open_matrix
from torquerig.decide.matrix_io.published_text import published_table_text
from torquerig.decide.matrix_io.result_text import (
    chart_text,
    findings_text,
    heading,
    kesselring_text,
    known_values_text,
    pugh_text,
    sweep_text,
)
from torquerig.plain_table import wrapped


def matrix_report(path: Path) -> str:
    """Return the text for a file of published tables (it has ``tables:``) or for a user's matrix.

    Raises
    ------
    InputError
        One sentence with file, line, key and remedy.
    """
    opened = open_matrix(path)
    if opened.document is None:
        return tables_text(opened)
    return matrix_analysis_text(analyse_matrix(matrix_from(opened.document)))


def tables_text(opened: OpenedMatrix) -> str:
    """Return the tables of a file with how a sheet was understood; empty where the file holds a matrix of facts."""
    if opened.tables is None:
        return ""
    head = [heading("How the sheet was read"), *(wrapped(one) for one in opened.understood)]
    said = "\n".join(head) + "\n\n" if opened.understood else ""
    return said + published_tables_text(opened.tables)


def published_tables_text(table_set: TableSet) -> str:
    """Return all tables as printed and recalculated, then the findings of the lints."""
    findings = audit(table_set)
    title = heading(f"Errors in the tables: {len(findings)} findings")
    return (
        "\n\n".join([*(published_table_text(table) for table in table_set.tables), title, findings_text(findings)])
        + "\n"
    )


def matrix_analysis_text(analysis: MatrixAnalysis) -> str:
    """Return a user's matrix with the three methods, the certainty of the winner, what to ask next, and the lints."""
    case, matrix = analysis.case, analysis.case.matrix
    near = near_misses_text(analysis.near)
    out = (
        f"\nleft out, because a requirement eliminates it: {', '.join(analysis.eliminated)}"
        if analysis.eliminated
        else ""
    )
    parts = [
        (f"{matrix.name}: the verdict", verdict_text(analysis.verdict)),
        (f"{matrix.name}: known values", known_values_text(matrix)),
        (
            "Elimination: which alternatives meet the requirements",
            chart_text(analysis.chart) + (f"\n{near}" if near else ""),
        ),
        ("Dominance, without weights", pareto_text(analysis.pareto)),
        (f"Pugh against {case.baseline}", pugh_text(analysis.pugh)),
        ("Pugh until the baseline is stable", convergence_text(analysis.convergence, analysis.cycles)),
        ("Pugh with every alternative as baseline", sweep_text(analysis.sweep)),
        (f"Kesselring, points {case.profile.name}", kesselring_text(analysis.overall) + out),
    ]
    if analysis.strength is not None:
        parts.append(("Technical and economic rating", strength_text(analysis.strength)))
    parts += [
        ("How certain the winner is", acceptability_text(analysis.acceptability)),
        ("What would change the winner", flips_text(analysis.weight_flips, analysis.score_flips, analysis.common)),
        ("What to ask next", missing_facts_text(analysis.missing)),
    ]
    if case.history:
        history = "\n".join(f"{number}. {text}" for number, text in enumerate(case.history, start=1))
        parts.append(("Earlier changes", history))
    parts.append((f"Lints: {len(analysis.findings)} findings", findings_text(analysis.findings)))
    return "\n\n".join(f"{heading(title)}\n{text}" for title, text in parts) + "\n"
