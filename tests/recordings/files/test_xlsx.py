"""Excel workbooks with several sheets: the longest table is read, and the others are noted."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files.xlsx import read_xlsx

INFO = [["Project", "X"], ["Rate", 2000]]


def data(rows: int) -> list[list[object]]:
    return [["time_s", "torque_Nm"], *([index / 2000, 2 + index % 7] for index in range(rows))]


def book(path: Path, **sheets: list[list[object]]) -> Path:
    made = openpyxl.Workbook()
    made.remove(made.worksheets[0])
    for title, rows in sheets.items():
        sheet = made.create_sheet(title)
        for row in rows:
            sheet.append(row)
    made.save(path)
    return path


@pytest.mark.parametrize("turned", [True, False])
def test_the_sheet_with_the_longest_table_is_read(tmp_path: Path, turned: bool) -> None:
    sheets = {"Info": INFO, "Data": data(60)}
    path = book(tmp_path / "run.xlsx", **(dict(reversed(sheets.items())) if turned else sheets))
    table = read_xlsx(path)
    assert list(table.columns) == ["time_s", "torque_Nm"]
    assert table.columns["torque_Nm"].size == 60
    assert table.notes[0] == "the sheet 'Data' is read"


def test_another_sheet_of_data_is_noted(tmp_path: Path) -> None:
    table = read_xlsx(book(tmp_path / "run.xlsx", One=data(40), Two=data(60), Three=data(20)))
    assert table.columns["torque_Nm"].size == 60
    assert "other sheets with numbers are not read: 'One' (40 rows), 'Three' (20 rows)" in table.notes[1]


def test_a_faulty_cell_of_the_longest_sheet_is_refused(tmp_path: Path) -> None:
    rows = data(60)
    rows[30][1] = "2x7"
    path = book(tmp_path / "run.xlsx", Info=INFO, Data=rows)
    with pytest.raises(RecordingError, match="2x7"):
        read_xlsx(path)
