"""No workbook hangs, fills the memory or ends in a traceback; each bad one is one sentence with its place."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Callable
from pathlib import Path

import openpyxl
import pytest

from torquerig.errors import InputError
from torquerig.safe_workbook import column_letters, read_workbook

SHEET = "xl/worksheets/sheet1.xml"
ENTITIES = (
    b"<!DOCTYPE x [<!ENTITY a0 'aaaaaaaaaa'>"
    + b"".join(b"<!ENTITY a%d '%s'>" % (one, b"&a%d;" % (one - 1) * 10) for one in range(1, 9))
    + b"]>"
)
Edit = Callable[[str, bytes], bytes | None]


@pytest.fixture
def workbook(tmp_path: Path) -> Path:
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "Facts"
    for row in (["name", "price"], ["A", 100.5], ["B", None], ["C", "yes"]):
        sheet.append(row)
    book.create_sheet("Other").append([1])
    path = tmp_path / "book.xlsx"
    book.save(path)
    return path


def test_rows_that_hold_something_are_read_with_their_numbers(workbook: Path) -> None:
    book = read_workbook(workbook)
    assert book["Facts"] == ((1, ("name", "price")), (2, ("A", 100.5)), (3, ("B",)), (4, ("C", "yes")))
    assert [*read_workbook(workbook, ("Other", "Missing"))] == ["Other"]


@pytest.mark.parametrize(
    ("row", "column", "said"),
    [(1_048_576, 1, "A1048576"), (1, 16_384, "XFD1"), (1_048_576, 16_384, "XFD1048576"), (10_001, 3, "C10001")],
)
def test_an_entry_far_from_the_table_is_named(row: int, column: int, said: str, workbook: Path) -> None:
    book = openpyxl.load_workbook(workbook)
    book["Facts"].cell(row, column).value = "x"
    book.save(workbook)
    with pytest.raises(InputError, match=f"sheet 'Facts', cell {said}: this entry is far from the table"):
        read_workbook(workbook)


def test_empty_cells_and_stated_sizes_of_a_whole_sheet_cost_nothing(workbook: Path) -> None:
    whole = b'<dimension ref="A1:XFD1048576"/>'
    empty = (
        b'<row r="1048576"><c r="XFD1048576" s="0"/></row></sheetData>'
        b'<mergeCells count="1"><mergeCell ref="A1:XFD1048576"/></mergeCells>'
    )
    _edit(workbook, lambda _, xml: re.sub(rb"<dimension[^>]*>", whole, xml).replace(b"</sheetData>", empty))
    assert len(read_workbook(workbook)["Facts"]) == 4


def _bomb(name: str, xml: bytes) -> bytes:
    return xml + b" " * 200_000_000 if name == SHEET else xml


BAD: dict[str, tuple[Edit, str]] = {
    "a sheet that unpacks to 200 MB": (_bomb, "unpacks to 200 MB in"),
    "entities that grow": (lambda _, xml: xml.replace(b"<worksheet", ENTITIES + b"<worksheet", 1), "document type"),
    "entities of a file": (
        lambda _, xml: xml.replace(b"<worksheet", b"<!DOCTYPE x SYSTEM 'file:///etc/hosts'><worksheet", 1),
        "document type",
    ),
    "entities in UTF-16": (
        lambda name, xml: (ENTITIES.decode() + "<a/>").encode("utf-16") if name == SHEET else xml, "document type",
    ),
    "1e400": (lambda _, xml: xml.replace(b"100.5", b"1e400"), "sheet 'Facts', cell B2: inf is out of range"),
    "1e308": (lambda _, xml: xml.replace(b"100.5", b"-1e308"), "cell B2: -1e+308 is out of range"),
    "NaN": (lambda _, xml: xml.replace(b"100.5", b"NaN"), "is no whole Excel workbook"),
    "a word as number": (lambda _, xml: xml.replace(b"100.5", b"abc"), "is no whole Excel workbook"),
    "text that is not there": (
        lambda _, xml: xml.replace(b'<c r="B2" t="n"><v>100.5', b'<c r="B2" t="s"><v>99'), "is no whole Excel workbook",
    ),
    "half the XML": (lambda name, xml: xml[: len(xml) // 2] if name == SHEET else xml, "is no whole Excel workbook"),
    "no content types": (lambda name, xml: None if "Content" in name else xml, "is no whole Excel workbook"),
    "a formula without value": (
        lambda _, xml: xml.replace(b"<v>100.5</v>", b"<f>1+1</f>"), "cell B2: the formula =1+1 has no stored value",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_a_bad_workbook_is_one_sentence(case: str, workbook: Path) -> None:
    edit, said = BAD[case]
    _edit(workbook, edit)
    with pytest.raises(InputError) as refused:
        read_workbook(workbook, ("Facts", "Other"))
    assert said in str(refused.value)
    assert str(refused.value).startswith(str(workbook))
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("keeps", [slice(0, 0), slice(0, 1500), slice(1500, None), slice(10, None)])
def test_a_cut_archive_is_one_sentence(keeps: slice, workbook: Path) -> None:
    workbook.write_bytes(workbook.read_bytes()[keeps])
    with pytest.raises(InputError, match="is no"):
        read_workbook(workbook)


@pytest.mark.parametrize("first", range(40, 100, 15))
def test_flipped_bytes_are_read_or_refused(first: int, workbook: Path) -> None:
    content = bytearray(workbook.read_bytes())
    for place in range(first, len(content), 397):
        content[place] ^= 0xFF
    workbook.write_bytes(content)
    with pytest.raises(InputError, match="is no"):
        read_workbook(workbook)


def test_columns_have_the_letters_of_a_spreadsheet() -> None:
    assert [column_letters(column) for column in (0, 25, 26, 701, 702, 16_383)] == ["A", "Z", "AA", "ZZ", "AAA", "XFD"]


def _edit(path: Path, edit: Edit) -> None:
    with zipfile.ZipFile(path) as archive:
        parts = {name: edit(name, archive.read(name)) for name in archive.namelist()}
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            if content is not None:
                archive.writestr(name, content)


@pytest.mark.parametrize("at", ["B2", "D2"])
def test_a_formula_with_an_empty_text_as_result_is_an_empty_cell(at: str, workbook: Path) -> None:
    book = openpyxl.load_workbook(workbook)
    book["Facts"][at] = '=IF(A2="A","",1)'
    book.save(workbook)
    with pytest.raises(InputError, match=f"cell {at}: the formula .* has no stored value"):
        read_workbook(workbook)
    with zipfile.ZipFile(workbook) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    cell = f'<c r="{at}"'.encode()
    assert parts[SHEET].count(cell) == 1
    parts[SHEET] = parts[SHEET].replace(cell, cell + b' t="str"')  # as spreadsheet programs store the result ""
    with zipfile.ZipFile(workbook, "w") as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    assert read_workbook(workbook)["Facts"][1] == (2, ("A",) if at == "B2" else ("A", 100.5))
