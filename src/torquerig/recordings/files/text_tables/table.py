"""A text table: opened, and its columns in pieces."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from torquerig.recordings.files.text_tables.columns import ColumnPlan, plan_columns
from torquerig.recordings.files.text_tables.footer import Footer, without_footer
from torquerig.recordings.files.text_tables.layout import Layout, find_layout
from torquerig.recordings.files.text_tables.parsing import Parsed, RowParser
from torquerig.recordings.files.text_tables.source import TextSource


@dataclass(frozen=True, kw_only=True)
class TextTable:
    """A text file whose layout is known.

    Parameters
    ----------
    source : TextSource
    layout : Layout
    plan : ColumnPlan
        The columns that are read.
    """

    source: TextSource
    layout: Layout
    plan: ColumnPlan

    def notes(self) -> tuple[str, ...]:
        """Return what the first lines show about encoding, layout and time stamps."""
        note = self.source.note()
        return ((note,) if note else ()) + self.layout.notes + self.plan.notes

    def units(self) -> dict[str, str]:
        """Return the units of the columns that are read, as written; times from stamps are in s."""
        units = {name: unit for name, unit in self.layout.units.items() if name in self.plan.names}
        return units | ({self.plan.stamps.name: "s"} if self.plan.stamps else {})

    def pieces(self, wanted: Sequence[str], step: int) -> Iterator[tuple[Parsed, Footer | None]]:
        """Yield the columns ``wanted`` of about ``step`` bytes at a time, the last with the footer below the rows."""
        parser = RowParser(self.layout, wanted, self.plan.stamps)
        line = self.layout.first_line
        for body, is_last in self.source.line_blocks(step, start=self.layout.start):
            rows, footer = without_footer(body, line, self.layout) if is_last else (body, None)
            yield parser.parse(rows, line), footer
            line += body.count(b"\n")

    def missing_note(self, missing: Counter[str]) -> str:
        """Return a sentence about missing cells; empty where there are none."""
        if not missing:
            return ""
        counts = ", ".join(f"{count} of {name}" for name, count in missing.items())
        words = f" ({', '.join(self.layout.missing[:4])})" if self.layout.missing else ""
        return f"cells without a number{words} are missing samples: {counts}"


def open_table(source: TextSource, step: int) -> TextTable:
    """Return the table of a text file; its first ``step`` bytes determine the layout.

    Raises
    ------
    RecordingError
        As :func:`find_layout`.
    """
    head = b""
    for data in source.blocks(step):
        head += data
        if len(head) >= step:
            head = head[: head.rfind(b"\n") + 1] or head
            break
    layout = find_layout(head.rstrip(b"\0"), source.path)
    return TextTable(source=source, layout=layout, plan=plan_columns(layout))
