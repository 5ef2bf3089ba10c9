"""The layout of a text table: where its rows, names and units are, and what each column holds."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import distinct
from torquerig.recordings.files.text_tables.block import EMPTY, NUMBER, STAMP, WORDS, Block, find_block
from torquerig.recordings.files.text_tables.cells import (
    ONE_READING,
    Dialect,
    form_of,
    is_missing,
    signs_of,
    split_cells,
    two_readings,
)
from torquerig.recordings.files.text_tables.header import Header, read_header
from torquerig.recordings.files.text_tables.lines import TextLine, first_lines
from torquerig.recordings.files.text_tables.preamble import Preamble, read_preamble
from torquerig.recordings.files.text_tables.scale_rows import refuse_scales

UNNAMED = "(unnamed)"
# rows that settle the layout; where the first lines hold fewer, more lines are looked at, up to the last number
_ENOUGH, _FIRST_LINES, _MOST_LINES = 50, 400, 25_600
# the first part of a file, in which its rows must begin [bytes]
_LONGEST_PREAMBLE = 2**22
# digits of a group of thousands
_GROUP = 3


@dataclass(frozen=True, kw_only=True)
class Layout:
    """How a text table is written.

    Parameters
    ----------
    path : Path
        For messages.
    dialect : Dialect
        Separator, decimal sign and thousands separator.
    names : tuple of str
        One distinct name for each cell of a row; ``(unnamed)`` where the header has none.
    families : tuple of str
        ``number``, ``stamp``, ``words`` or ``empty`` for each column.
    first_line, start : int
        The number of the first row's line, from 1, and the byte where it begins.
    rows : tuple of tuple of str
        The cells of the first rows.
    rate : float or None
        [Hz], where the lines above the names state it.
    units : mapping of str to str
        As written, by name.
    notes : tuple of str
    missing : tuple of str
        The words that stand for missing numbers in the first rows.
    decimal : str
        The decimal sign that the first rows show; empty where they hold whole numbers only.
    other_decimal : frozenset of str
        The columns whose numbers have the other decimal sign, point or comma.
    """

    path: Path
    dialect: Dialect
    names: tuple[str, ...]
    families: tuple[str, ...]
    first_line: int
    start: int
    rows: tuple[tuple[str, ...], ...]
    rate: float | None = None
    units: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    decimal: str = ""
    other_decimal: frozenset[str] = frozenset()

    def column(self, name: str) -> list[str]:
        """Return the cells of one column in the first rows."""
        place = self.names.index(name)
        return [row[place] for row in self.rows]

    def of_family(self, family: str) -> list[str]:
        """Return the names of the columns of one family."""
        return [name for name, one in zip(self.names, self.families, strict=True) if one == family]


def find_layout(head: bytes, path: Path) -> Layout:
    """Return the layout that fits most of the lines in ``head``, complete lines from the start of the file.

    Raises
    ------
    RecordingError
        Where there is no row of numbers; where names and rows have different numbers of columns; where a comma may
        separate thousands or decimals.
    """
    most = _FIRST_LINES
    head = head if len(head) <= _LONGEST_PREAMBLE else head[: head.rfind(b"\n", 0, _LONGEST_PREAMBLE) + 1]
    while True:
        lines = first_lines(head, most)
        block = find_block(lines)
        reaches_on = block is not None and block.last >= len(lines) - _ENOUGH // 2
        is_enough = block is not None and block.rows >= _ENOUGH and 2 * block.share >= 1
        if len(lines) < most or most >= _MOST_LINES or (reaches_on and is_enough):
            break
        most *= 8
    if block is None:
        is_empty = all(not line.text.strip() for line in lines)
        problem = "nothing in it" if is_empty else "no samples: there is no row of numbers"
        raise RecordingError(
            f"{path}: the table has {problem}; put a line with the names of the "
            "columns at the top, for example time_s,torque_V,encoder_count, and the numbers below it"
        )
    return _layout(lines, block, path)


def _layout(lines: Sequence[TextLine], block: Block, path: Path) -> Layout:
    header = read_header(lines, block)
    block, header = _one_column(lines, block, header)
    if header.wrong is not None:
        _refuse_width(header.wrong, lines[block.first], block, path)
    refuse_scales(header.between, block, path)
    cells = [(line, split_cells(line.text, block.separator)) for line in lines[block.first : block.last + 1]]
    rows = [(line, row) for line, row in cells if block.fits(row)]
    wide = [(line, split_cells(line.text, block.separator)) for line in lines[block.first :]]
    dialect = _dialect([(line, row) for line, row in wide if len(row) == block.width], block, path)
    decimal = _decimal_sign(rows, block, dialect)
    preamble = read_preamble(header.above, decimal=decimal)
    names = tuple(distinct([name or UNNAMED for name in header.names] or _bare_names(block.families)))
    other = frozenset(names[place] for place in _other_decimal(rows, block, dialect))
    used = [row[place] for _, row in rows for place, one in enumerate(block.families) if one == NUMBER]
    missing = tuple(dict.fromkeys(cell for cell in used if cell and is_missing(cell) and cell.lower() != "nan"))
    return Layout(
        path=path, dialect=dialect, names=names, families=block.families, first_line=lines[block.first].number,
        start=lines[block.first].start, rows=tuple(tuple(row) for _, row in rows), rate=preamble.rate,
        units=_units(names, block, header, preamble), notes=_notes(header, dialect, preamble, names, other),
        missing=missing, decimal=decimal, other_decimal=other,
    )  # fmt: skip


def _one_column(lines: Sequence[TextLine], block: Block, header: Header) -> tuple[Block, Header]:
    """Return the block with one column of decimal commas, where commas split it in two and a single name stands above.

    Without a name, whole numbers with one comma are read as two columns only where the first one rises.
    """
    if block.separator != "," or block.width != 2 or set(block.families) != {NUMBER} or header.names:
        return block, header
    cells = [split_cells(line.text, ",") for line in lines[block.first : block.last + 1]]
    rows = [row for row in cells if len(row) == 2]
    whole = all(form_of(cell) == "integer" or not cell for row in rows for cell in row)
    single = Block(separator=";", families=(NUMBER,), first=block.first, last=block.last, rows=block.rows)
    if not whole or any(not row[1].isdigit() for row in rows):
        return block, header
    alone = read_header(lines, single)
    firsts = [int(row[0]) for row in rows if row[0]]
    rises = all(later > one for one, later in pairwise(firsts))
    return (single, alone) if alone.names or not rises else (block, header)


def _refuse_width(wrong: TextLine, row: TextLine, block: Block, path: Path) -> None:
    names, cells = split_cells(wrong.text, block.separator), split_cells(row.text, block.separator)
    whole = block.separator == "," and len(cells) > 1 and all(cell.lstrip("+-").isdigit() for cell in cells)
    hint = " (if the commas are decimal signs, separate the cells by semicolons)" if whole else ""
    if len(names) > len(cells):
        raise RecordingError(
            f"{path}:{wrong.number}: the line has {len(names)} names and the rows below it {len(cells)} columns; write "
            "one name for each column, in quotes where it has a blank"
        )
    count = f"{len(cells)} cell{'s' * (len(cells) != 1)}"
    raise RecordingError(
        f"{path}:{row.number}: the row has {count} and the table {len(names)} columns; complete or delete the row{hint}"
    )


def _dialect(rows: Sequence[tuple[TextLine, list[str]]], block: Block, path: Path) -> Dialect:
    """Return the dialect that all numbers of the rows determine; RecordingError where two readings remain."""
    columns = [place for place, family in enumerate(block.families) if family == NUMBER]
    cells = {place: [row[place] for _, row in rows] for place in columns}
    forms = {place: [form_of(cell) for cell in column] for place, column in cells.items()}
    every = Counter(form for column in forms.values() for form in column if form)
    if block.separator != ";" or _has_long_integers(cells, forms):
        # only where semicolons separate cells may a point separate thousands: commas would be decimal signs
        is_comma = every["comma"] or every["groups by point"]
        every["point"] += 0 if is_comma else every.pop("one group by point", 0)
    signs = signs_of(every.elements())
    for place, column in forms.items():
        # 1,234 together with 987 or 1,234.5 in its column has thousands; alone it may be a decimal comma
        group, others = _GROUPS["," if signs is None or signs[0] == "." else "."]
        group = "one group by point" if signs is None and "one group" not in every else group
        proper = "point" if group == "one group by point" else "comma"
        if group not in column or (signs is not None and (others | {proper}) & set(column)):
            continue
        line, row = rows[column.index(group)]
        raise RecordingError(f"{path}:{line.number}: {row[place]!r} may be {two_readings(row[place])}; {ONE_READING}")
    return Dialect(block.separator, *(signs or (".", "")))


# by the sign between thousands: the form with two readings, those that show thousands in its column
_GROUPS = {
    ",": ("one group", {"integer", "point", "groups by comma"}),
    ".": ("one group by point", {"integer", "comma", "groups by point"}),
}


def _decimal_sign(rows: Sequence[tuple[TextLine, Sequence[str]]], block: Block, dialect: Dialect) -> str:
    """Return the decimal sign that the rows show, empty where they hold whole numbers only."""
    places = [place for place, family in enumerate(block.families) if family == NUMBER]
    is_whole = all(form_of(row[place]) in ("integer", "") for _, row in rows for place in places)
    return "" if is_whole else dialect.decimal


def _other_decimal(rows: Sequence[tuple[TextLine, Sequence[str]]], block: Block, dialect: Dialect) -> list[int]:
    """Return the places of the columns all of whose numbers have the other decimal sign, half of them or more."""
    form, group = ("point", "one group by point") if dialect.decimal == "," else ("comma", "one group")
    found = []
    for place, family in enumerate(block.families):
        forms = Counter(form_of(row[place]) for _, row in rows if row[place]) if family == NUMBER else Counter[str]()
        if set(forms) <= {form, group, "integer", ""} and 2 * forms[form] >= max(forms.total(), 1):
            found.append(place)
    return found


def _has_long_integers(cells: Mapping[int, list[str]], forms: Mapping[int, list[str]]) -> bool:
    """Return whether a column with 1.234 has 1234 too, which shows that points do not separate thousands."""
    return any(
        "one group by point" in column and any(form == "integer" and len(cell.lstrip("+-0")) > _GROUP
                                                for form, cell in zip(column, cells[place], strict=True))
        for place, column in forms.items()
    )  # fmt: skip


def _bare_names(families: Sequence[str]) -> list[str]:
    """Return the names of a table without a header: time and volts, as in the reference report, Appendix A."""
    used = len(families)
    while used and families[used - 1] == EMPTY:
        used -= 1
    if used <= 2 and all(family == NUMBER for family in families[:used]):
        return ["time_s", "torque_V"][-used:] + [""] * (len(families) - used)
    return [f"column_{number}" for number in range(1, len(families) + 1)]


def _units(names: Sequence[str], block: Block, header: Header, preamble: Preamble) -> dict[str, str]:
    units = {name: unit for name, unit in zip(names, header.units, strict=False) if unit and name != UNNAMED}
    unit_less = [name for name in _signals(names, block) if name not in units]
    for name in unit_less:
        if name.lower() in preamble.named_units:
            units[name] = preamble.named_units[name.lower()]
    if preamble.units and not header.units:
        numbers = [name for name, family in zip(names, block.families, strict=True) if family == NUMBER]
        for several in (unit_less, numbers):
            if len(preamble.units) == len(several):
                units |= dict(zip(several, preamble.units, strict=True))
                break
    return units


def _signals(names: Sequence[str], block: Block) -> list[str]:
    from torquerig.recordings.names.time_column import time_column

    numbers = [name for name, family in zip(names, block.families, strict=True) if family == NUMBER]
    time = time_column(numbers)
    return [name for name in numbers if time is None or name != time.name]


def _notes(
    header: Header, dialect: Dialect, preamble: Preamble, names: Sequence[str], other: frozenset[str]
) -> tuple[str, ...]:
    parts = []
    if header.names and (header.names_line > 1 or header.units_line):
        parts.append(f"names in line {header.names_line}")
    if header.units_line:
        parts.append(f"units in line {header.units_line}")
    if not header.names:
        parts.append(f"there is no line of names, and the columns are called {', '.join(names[:4])}")
    if header.between:
        parts.append(f"the numbers in line {', '.join(str(one.number) for one in header.between)} are no samples")
    if dialect.decimal == ",":
        parts.append("the comma is the decimal sign")
    if other:
        sign = "point" if dialect.decimal == "," else "comma"
        parts.append(f"the {sign} is the decimal sign of {', '.join(one for one in names if one in other)}")
    if dialect.thousands:
        parts.append(f"{'the comma' if dialect.thousands == ',' else 'the point'} separates thousands")
    return ((", ".join(parts),) if parts else ()) + preamble.notes


__all__ = ["EMPTY", "NUMBER", "STAMP", "UNNAMED", "WORDS", "Layout", "find_layout"]
