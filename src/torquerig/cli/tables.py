"""Plain tables for the terminal."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill

WIDTH = 110


def grid(rows: Sequence[Sequence[str]]) -> str:
    """Return rows as aligned columns, the first row ruled off; columns of numbers are set to the right."""
    widths = [max(len(row[place]) for row in rows) for place in range(len(rows[0]))]
    right = [all(_numeric(row[place]) for row in rows[1:]) and len(rows) > 1 for place in range(len(widths))]
    lines = [
        "  ".join(
            cell.rjust(width) if to_right else cell.ljust(width)
            for cell, width, to_right in zip(row, widths, right, strict=True)
        ).rstrip()
        for row in rows
    ]
    return "\n".join([lines[0], "-" * max(len(line) for line in lines), *lines[1:]])


def wrapped(sentence: str) -> str:
    """Return a sentence in lines of at most ``WIDTH`` characters, the later ones set in."""
    return fill(sentence, WIDTH, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _numeric(cell: str) -> bool:
    try:
        float(cell.replace("%", "").strip() or "nan")
    except ValueError:
        return cell in ("-", "?")
    return True
