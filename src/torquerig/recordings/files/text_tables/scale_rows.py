"""Rows of factors and offsets between the names and the rows of a table."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from torquerig.errors import RecordingError
from torquerig.recordings.files.text_tables.block import Block
from torquerig.recordings.files.text_tables.cells import form_of, split_cells
from torquerig.recordings.files.text_tables.lines import TextLine

_FACTOR = re.compile(r"fa[ck]tor|scal|skal|gain|slope|steigung|sensitivity|empfindlichkeit|mult", re.IGNORECASE)
_OFFSET = re.compile(r"offset|zero|nullpunkt|bias", re.IGNORECASE)
# what changes nothing, as factor or offset
_ONE, _ZERO = re.compile(r"1([.,]0*)?"), re.compile(r"[+-]?0([.,]0*)?")


def refuse_scales(lines: Sequence[TextLine], block: Block, path: Path) -> None:
    """Raise RecordingError for a row of factors or offsets that may have to be applied to the numbers below it."""
    for line in lines:
        label, *cells = split_cells(line.text, block.separator)
        kind, nothing = ("factors", _ONE) if _FACTOR.search(label) else ("offsets", _ZERO)
        if kind == "offsets" and not _OFFSET.search(label):
            continue
        found = next((cell for cell in cells if form_of(cell) and not nothing.fullmatch(cell)), None)
        if found is not None:
            raise RecordingError(
                f"{path}:{line.number}: the row {label!r} holds {kind}, for example {found}, and the numbers below may "
                "be before or after them; apply them if they are before, and delete the row"
            )
