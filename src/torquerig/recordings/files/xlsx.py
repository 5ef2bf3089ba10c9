"""Excel workbooks: the sheet that holds the longest table of numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from datetime import date, time, timedelta
from pathlib import Path
from warnings import catch_warnings, simplefilter
from zipfile import ZipFile

from torquerig.errors import RecordingError
from torquerig.recordings.files.csv import table_of
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.text_tables.parsing import FaultyCellError
from torquerig.recordings.files.text_tables.source import TextSource

# the unpacked sheets [bytes]: half a million rows of ten columns; read, they take four times as much memory
_LARGEST = 2**28
# the other parts, of which openpyxl makes objects: styles and shared words [bytes]
_LARGEST_OTHERS = 2**25
# unpacked bytes per packed byte of one part; sheets of numbers have 5 to 20, a bomb up to 1030
_LARGEST_RATIO = 200
# parts below this size are not judged by their ratio [bytes]
_JUDGED = 2**22
# columns of a table, and empty rows after which the rest is a stray cell [1]
_WIDEST, _FARTHEST = 1024, 10_000
_SAVE_AGAIN = "open it in Excel and save it again"


def read_xlsx(path: Path, only: Collection[str] = ()) -> Table:
    """Read the sheet with the longest table of numbers, as :func:`~torquerig.recordings.files.csv.read_csv`.

    Formulas are read as the values that Excel saved. Dates and times are time stamps. Other sheets are noted.

    Raises
    ------
    RecordingError
        For a damaged workbook, one that unpacks to more than 256 MiB or 200 times its size, and one without a table;
        for a cell that is no number in a sheet that is longer than the others.
    """
    tables: dict[str, Table] = {}
    problems: dict[str, str] = {}
    faulty: dict[FaultyCellError, int] = {}
    for title, text in _sheets(path):
        try:
            table = table_of(TextSource(path=path, content=text), only)
        except RecordingError as error:
            faulty |= {error: text.count(b"\n")} if isinstance(error, FaultyCellError) else {}
            problems[title] = str(error).removeprefix(f"{path}:")
        else:
            tables |= {title: table} if table.columns else {}
            problems |= {} if table.columns else {title: " it has no column of numbers"}
    sizes = {title: _rows(table) for title, table in tables.items()}
    for one, rows in faulty.items():
        if rows > max(sizes.values(), default=0):
            raise one
    if not tables:
        listed = "; ".join(f"the sheet {title!r}:{problem}" for title, problem in list(problems.items())[:3])
        raise RecordingError(f"{path}: {listed or 'the workbook has no sheet'}; save the table as CSV")
    return _longest(tables, sizes)


def _longest(tables: Mapping[str, Table], sizes: Mapping[str, int]) -> Table:
    """Return the table of the sheet with the most rows, with a note about the others."""
    read = max(sizes, key=lambda title: sizes[title])
    others = [f"{title!r} ({rows} row{'s' * (rows != 1)})" for title, rows in sizes.items() if title != read]
    notes = [f"the sheet {read!r} is read"]
    if others:
        notes.append(f"other sheets with numbers are not read: {', '.join(others)}; save one as CSV to read it")
    found = tables[read]
    return Table(
        columns=found.columns, rates=found.rates, units=found.units, skipped=found.skipped,
        notes=(*notes, *found.notes),
    )  # fmt: skip


def _rows(table: Table) -> int:
    return max(values.size for values in table.columns.values())


def _sheets(path: Path) -> Iterator[tuple[str, bytes]]:
    """Yield title and text of each sheet, rows as lines and cells separated by tabs."""
    import openpyxl

    _check_parts(path)
    try:
        # opened here, because openpyxl 3.1.0 leaves a damaged file open
        with catch_warnings(), path.open("rb") as raw:
            simplefilter("ignore")  # of styles and extensions that do not matter here
            book = openpyxl.load_workbook(raw, read_only=True, data_only=True)
            texts = []
            for sheet in book.worksheets:
                sheet.reset_dimensions()  # the stated ones may be those of an empty sheet of a million rows
                texts.append((sheet.title, _text(sheet.iter_rows(values_only=True))))
            book.close()
    except Exception as error:  # openpyxl has no error of its own for what is damaged
        raise RecordingError(f"{path}: is no whole Excel workbook ({_reason(error)}); {_SAVE_AGAIN}") from None
    yield from texts


def _check_parts(path: Path) -> None:
    """Refuse a bomb, and XML with a document type, before anything is read from it."""
    try:
        with ZipFile(path) as archive:
            parts = archive.infolist()
            sheets = sum(part.file_size for part in parts if "/worksheets/" in part.filename)
            others = sum(part.file_size for part in parts if part.filename.endswith((".xml", ".rels"))) - sheets
            large = [part for part in parts if part.file_size > _JUDGED]
            packed_much = any(part.file_size > _LARGEST_RATIO * max(part.compress_size, 1) for part in large)
            if sheets > _LARGEST or others > _LARGEST_OTHERS or packed_much:
                raise RecordingError(
                    f"{path}: the workbook unpacks to {(sheets + others) / 2**20:.0f} MiB, which is too much to read; "
                    "save the table as CSV"
                )
            if any(_has_document_type(archive, part.filename) for part in parts):
                raise RecordingError(f"{path}: its XML has a document type; {_SAVE_AGAIN}")
    except RecordingError:
        raise
    except Exception as error:  # zipfile and zlib have several, and a damaged directory gives any
        raise RecordingError(f"{path}: is no whole Excel workbook ({_reason(error)}); {_SAVE_AGAIN}") from None


def _has_document_type(archive: ZipFile, name: str) -> bool:
    """Return whether a part of XML has a document type, which can repeat text without end."""
    if not name.lower().endswith((".xml", ".rels")):
        return False
    before = b""
    with archive.open(name) as file:
        while data := file.read(2**20):
            text = before + data.replace(b"\0", b"").lower()  # UTF-16 has a NUL in each letter
            if b"<!doctype" in text or b"<!entity" in text:
                return True
            before = text[-16:]
    return False


def _reason(error: Exception) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0][:100]


def _text(rows: Iterable[tuple[object, ...]]) -> bytes:
    lines: list[str] = []
    empty = 0
    for row in rows:
        if all(cell is None for cell in row[:_WIDEST]):
            empty += 1
            if empty > _FARTHEST:
                break
            lines.append("")
            continue
        empty = 0
        lines.append("\t".join(_cell(cell) for cell in row[:_WIDEST]).rstrip("\t"))
    width = max((line.count("\t") for line in lines), default=0)
    return "\n".join(line + "\t" * (width - line.count("\t")) if line else "" for line in lines).encode()


def _cell(cell: object) -> str:
    if isinstance(cell, int | float):
        return repr(cell)
    if isinstance(cell, date | time):
        return cell.isoformat()
    if isinstance(cell, timedelta):
        seconds = cell.total_seconds()
        return f"{int(seconds // 3600):02d}:{int(seconds // 60 % 60):02d}:{seconds % 60:09.6f}" if seconds >= 0 else ""
    return "" if cell is None else " ".join(str(cell).replace('"', "'").split())
