"""Excel workbooks: the first sheet that holds a table of numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from datetime import date, time, timedelta
from pathlib import Path
from zipfile import BadZipFile, ZipFile

from torquerig.errors import RecordingError
from torquerig.recordings.files.csv import table_of
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.text_tables.source import TextSource

# the unpacked workbook [bytes]: a full sheet of a million rows and ten columns has about 400 MB
_LARGEST = 2**29
# unpacked bytes per packed byte of one part; sheets of numbers have 5 to 20, a bomb up to 1030
_LARGEST_RATIO = 200
# parts below this size are not judged by their ratio [bytes]
_JUDGED = 2**22
# columns and rows without a cell between them after which the rest is a stray cell [1]
_WIDEST, _FARTHEST = 1024, 10_000
_DAMAGED = (BadZipFile, KeyError, ValueError, TypeError, IndexError, AttributeError, OSError, EOFError, SyntaxError)


def read_xlsx(path: Path, only: Collection[str] = ()) -> Table:
    """Read the first sheet that holds rows of numbers, as :func:`~torquerig.recordings.files.csv.read_csv`.

    Formulas are read as the values that Excel saved. Dates and times are time stamps.

    Raises
    ------
    RecordingError
        For a damaged workbook, one that unpacks to more than 512 MiB or 200 times its size, and one without a table.
    """
    problems = []
    for title, text in _sheets(path):
        try:
            table = table_of(TextSource(path=path, content=text), only)
        except RecordingError as error:
            problems.append(f"the sheet {title!r}: {str(error).removeprefix(f'{path}:')}")
            continue
        if table.columns:
            return Table(
                columns=table.columns, rates=table.rates, units=table.units, skipped=table.skipped,
                notes=(f"the sheet {title!r} is read", *table.notes),
            )  # fmt: skip
        problems.append(f"the sheet {title!r} has no column of numbers")
    raise RecordingError(f"{path}: {'; '.join(problems[:3]) or 'the workbook has no sheet'}; save the table as CSV")


def _sheets(path: Path) -> Iterator[tuple[str, bytes]]:
    """Yield title and text of each sheet, rows as lines and cells separated by tabs."""
    import warnings

    import openpyxl

    _check_size(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of styles and extensions that do not matter here
            book = openpyxl.load_workbook(path, read_only=True, data_only=True)
            try:
                for sheet in book.worksheets:
                    sheet.reset_dimensions()
                    yield sheet.title, _text(sheet.iter_rows(values_only=True))
            finally:
                book.close()
    except RecordingError:
        raise
    except _DAMAGED as error:
        reason = " ".join(str(error).split())[:100]
        raise RecordingError(
            f"{path}: is not a whole Excel workbook ({reason}); open it in Excel and save it again"
        ) from error


def _check_size(path: Path) -> None:
    """Refuse a bomb, and XML with a document type, before anything is unpacked."""
    try:
        with ZipFile(path) as archive:
            parts = archive.infolist()
            whole = sum(part.file_size for part in parts)
            large = [part for part in parts if part.file_size > _JUDGED]
            packed_much = any(part.file_size > _LARGEST_RATIO * max(part.compress_size, 1) for part in large)
            if whole > _LARGEST or packed_much:
                raise RecordingError(
                    f"{path}: the workbook unpacks to {whole / 2**20:.0f} MiB, which is too much to read; save the "
                    "table as CSV"
                )
            for part in parts:
                with archive.open(part) as file:
                    if b"<!DOCTYPE" in file.read(2**12):
                        raise RecordingError(f"{path}: its XML has a document type; save it again in Excel")
    except (BadZipFile, OSError, EOFError, ValueError, NotImplementedError, RuntimeError) as error:
        raise RecordingError(
            f"{path}: is not a whole Excel workbook ({error}); open it in Excel and save it again"
        ) from error


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
