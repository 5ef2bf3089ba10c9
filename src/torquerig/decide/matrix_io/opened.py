"""Any file with a decision matrix: published tables, a matrix of facts, or a sheet as people write them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from torquerig.decide.matrix_io.matrix_table import TableSet
from torquerig.document import Document, read_document
from torquerig.errors import InputError

WORKBOOKS = (".xlsx", ".xlsm")
TEXT_SHEETS = (".csv", ".tsv", ".txt")


@dataclass(frozen=True, kw_only=True)
class OpenedMatrix:
    """What a file holds: either ``document``, a matrix of criteria and facts, or ``tables`` of marks and points.

    Parameters
    ----------
    document : Document or None
    tables : TableSet or None
    understood : tuple of str
        How a sheet without fixed form was read, in sentences.
    """

    document: Document | None = None
    tables: TableSet | None = None
    understood: tuple[str, ...] = ()


def open_matrix(path: Path) -> OpenedMatrix:
    """Read a file of any form that ``torquerig matrix`` knows.

    A workbook with the sheets Criteria and Facts has the form that the program writes; every other workbook and a CSV
    file is read by its shape. A YAML file with ``tables:`` holds published tables, else a decision matrix.

    Raises
    ------
    InputError
        With file, line or cell, and remedy; also for the scenario of a rig.
    """
    ending = path.suffix.lower()
    if ending in WORKBOOKS:
        from torquerig.decide.matrix_io.excel_matrix import has_own_form, read_excel_matrix

        if has_own_form(path):
            return OpenedMatrix(document=read_excel_matrix(path))
    if ending in (*WORKBOOKS, *TEXT_SHEETS):
        from torquerig.decide.matrix_io.written_sheet.reading import read_written_sheet

        sheet = read_written_sheet(path)
        return OpenedMatrix(tables=sheet.tables, understood=sheet.understood)
    document = read_document(path)
    if isinstance(document.data, dict) and "rig" in document.data:
        raise InputError(
            f"{path}: is the scenario of a rig, not a matrix; use torquerig compare, or torquerig.compare in Python"
        )
    if isinstance(document.data, dict) and "tables" in document.data:
        from torquerig.decide.matrix_io.published_tables import tables_from

        return OpenedMatrix(tables=tables_from(document))
    return OpenedMatrix(document=document)
