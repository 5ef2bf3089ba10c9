"""The lines at the top of a text file."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from torquerig.recordings.files.text_tables.source import decoded

_COMMENT_SIGNS = ("#", "%", "//")
# a quoted cell goes over no more lines than this
_LONGEST_CELL = 6


@dataclass(frozen=True)
class TextLine:
    """A line with its number in the file, from 1, its text, and the bytes where it starts and ends."""

    number: int
    text: str
    start: int
    end: int

    def is_comment(self) -> bool:
        """Return whether it starts with #, % or //, in quotes or not."""
        return is_comment(self.text)


def is_comment(text: str) -> bool:
    """Return whether a line starts with #, % or //, in quotes or not."""
    return text.lstrip(' \t"').startswith(_COMMENT_SIGNS)


def first_lines(head: bytes, most: int) -> list[TextLine]:
    """Return the first ``most`` lines; a quoted cell that goes over several lines is one line."""
    lines = []
    physical = _physical(head)
    for line in physical:
        joined = [line]
        if line.text.count('"') % 2:
            for later in physical:
                joined.append(later)
                if later.text.count('"') % 2 or len(joined) == _LONGEST_CELL:
                    break
        whole = len(joined) > 1 and sum(one.text.count('"') for one in joined) % 2 == 0
        if whole:
            text = " ".join(one.text for one in joined)
            lines.append(TextLine(line.number, text, line.start, joined[-1].end))
        else:
            lines += joined
        if len(lines) >= most:
            break
    return lines


def _physical(head: bytes) -> Iterator[TextLine]:
    start, number = 0, 0
    while start < len(head):
        stop = head.find(b"\n", start)
        end = len(head) if stop < 0 else stop + 1
        number += 1
        yield TextLine(number, decoded(head[start:end]).rstrip("\r\n\0"), start, end)
        start = end
