"""A matrix analysis as Markdown, for comparison line by line in version control."""

from __future__ import annotations

import re

from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.harmless import harmless
from torquerig.reporting.layout import Table
from torquerig.reporting.matrix.chapters import chapters


def matrix_markdown(worked: MatrixAnalysis) -> str:
    """Return the whole decision as Markdown, without pictures; the same case gives the same text."""
    parts = [f"# {escaped(worked.case.matrix.name)}", f"**{escaped(worked.verdict.sentence())}**"]
    for chapter in chapters(worked):
        parts.append(f"## {chapter.title}")
        parts += ["\n".join(f"- {escaped(line)}" for line in chapter.lines)] if chapter.lines else []
        parts += [table_text(table) for table in chapter.tables]
    return "\n\n".join(parts) + "\n"


def table_text(table: Table) -> str:
    """Return a table with its caption above and its note below."""
    right = ["number" in cell.word for cell in table.rows[0]] if table.rows else [False] * len(table.head)
    lines = [
        f"*{escaped(table.caption)}*",
        "",
        _row([escaped(text) for text in table.head]),
        _row(["---:" if one else "---" for one in right]),
        *(_row([escaped(cell.text) for cell in row]) for row in table.rows),
    ]
    return "\n".join([*lines, "", escaped(table.note)] if table.note else lines)


def _row(texts: list[str]) -> str:
    return f"| {' | '.join(texts)} |"


def escaped(text: str) -> str:
    """Return text with escaped Markdown characters."""
    return re.sub(r"([\\`*_{}\[\]<>|#])", r"\\\1", harmless(text).replace("\n", " "))
