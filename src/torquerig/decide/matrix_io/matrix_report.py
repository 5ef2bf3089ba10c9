"""The whole text of ``torquerig matrix``: published tables audited, or one's own matrix run through the engines."""

from __future__ import annotations

from pathlib import Path

from torquerig.decide.lints.audit import audit
from torquerig.decide.matrix_io.certainty_text import (
    tell_acceptability,
    tell_convergence,
    tell_flips,
    tell_missing,
    tell_near_misses,
    tell_pareto,
    tell_strength,
    tell_verdict,
)
from torquerig.decide.matrix_io.matrix_file import matrix_from
from torquerig.decide.matrix_io.printed_text import tell_sheet
from torquerig.decide.matrix_io.published_tables import tables_from
from torquerig.decide.matrix_io.sheet import Book
from torquerig.decide.matrix_io.text import (
    heading,
    tell_chart,
    tell_findings,
    tell_kesselring,
    tell_matrix,
    tell_pugh,
    tell_sweep,
)
from torquerig.decide.working import WorkedOut, work_out
from torquerig.document import read_document


def matrix_report(path: Path) -> str:
    """Return the text for a file of published tables (it has ``tables:``) or for one's own matrix.

    Raises
    ------
    InputError
        One sentence with file, line, key and remedy.
    """
    document = read_document(path)
    if isinstance(document.data, dict) and "tables" in document.data:
        return tell_book(tables_from(document))
    return tell_worked_out(work_out(matrix_from(document)))


def tell_book(book: Book) -> str:
    """Return all tables as printed and recomputed, then what is wrong with them."""
    findings = audit(book)
    title = heading(f"What the tables get wrong: {len(findings)} findings")
    return "\n\n".join([*(tell_sheet(sheet) for sheet in book.sheets), title, tell_findings(findings)]) + "\n"


def tell_worked_out(worked: WorkedOut) -> str:
    """Return one's own matrix with the three methods, how sure the winner is, what to ask next, and the lints."""
    case, matrix = worked.case, worked.case.matrix
    near = tell_near_misses(worked.near)
    out = f"\nleft out, as a demand eliminates it: {', '.join(worked.eliminated)}" if worked.eliminated else ""
    parts = [
        (f"{matrix.name}: the verdict", tell_verdict(worked.verdict)),
        (f"{matrix.name}: what is known", tell_matrix(matrix)),
        ("Elimination: who meets the demands", tell_chart(worked.chart) + (f"\n{near}" if near else "")),
        ("Dominance, before any weight", tell_pareto(worked.pareto)),
        (f"Pugh against {case.datum}", tell_pugh(worked.pugh)),
        ("Pugh until the datum stands", tell_convergence(worked.convergence, worked.circles)),
        ("Pugh with every alternative as datum", tell_sweep(worked.sweep)),
        (f"Kesselring, points {case.profile.name}", tell_kesselring(worked.overall) + out),
    ]
    if worked.strength is not None:
        parts.append(("Technical and economic rating apart", tell_strength(worked.strength)))
    parts += [
        ("How sure the winner is", tell_acceptability(worked.acceptability)),
        ("What would change the winner", tell_flips(worked.weight_flips, worked.score_flips, worked.common)),
        ("What to ask next", tell_missing(worked.missing)),
    ]
    if case.history:
        told = "\n".join(f"{number}. {text}" for number, text in enumerate(case.history, start=1))
        parts.append(("What was changed before", told))
    parts.append((f"Lints: {len(worked.findings)} findings", tell_findings(worked.findings)))
    return "\n\n".join(f"{heading(title)}\n{text}" for title, text in parts) + "\n"
