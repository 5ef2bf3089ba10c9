"""Damaged text tables, workbooks and gzip files: one sentence or numbers; no traceback, no hang, no gigabyte."""

import gzip
import resource
import time
import zipfile
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest

from tests.recordings.files.text_tables.made_tables import dialects
from torquerig.errors import TorquerigError
from torquerig.recordings.files.reading import READERS

LONGEST = 10.0  # s, for one file
MOST_MEMORY = 2**20  # KiB, beyond what the process had before
SNIPPETS = (
    b",", b";", b"\t", b" ", b'"', b"\r", b"\n\n", b"\0", b"\xff\xfe", b"\xef\xbb\xbf", b"nan", b"1e400", b"-", b"#",
    b"OVLD", b"1.234,5", b"1,234", b"\xe2\x88\x92", b"\xa0", b"12:61:99", b"2021-13-45", b"sep=x\n", b"=1+1", b"'",
    b"\x1b[2J", b"Rate: 1e300 Hz\n", b"99999999999999999999", b"31.02.2021 10:00:00", b"0x1F", b"+", b"e", b"Units: \n",
)  # fmt: skip


def mutated(content: bytes, others: list[bytes], rng: np.random.Generator) -> bytes:
    data = bytearray(content)
    for _ in range(int(rng.integers(1, 6))):
        kind, place = int(rng.integers(8)), int(rng.integers(len(data) + 1))
        stop = min(place + int(rng.integers(1, 200)), len(data))
        if kind == 0 and place < len(data):
            data[place] ^= 1 << int(rng.integers(8))
        elif kind == 1:
            del data[place:stop]
        elif kind == 2:
            data[place:place] = SNIPPETS[int(rng.integers(len(SNIPPETS)))]
        elif kind == 3:
            data[place:place] = bytes(data[place:stop]) * int(rng.integers(1, 20))
        elif kind == 4:
            other = others[int(rng.integers(len(others)))]
            data[place:place] = other[: int(rng.integers(1, 800))]
        elif kind == 5:
            del data[place:]
        elif kind == 6:
            one, two = (b",;\t |.\n"[int(rng.integers(7))] for _ in range(2))
            data[:] = data.replace(bytes([one]), bytes([two]))
        else:
            data[place:stop] = rng.integers(0, 256, stop - place).astype(np.uint8).tobytes()
    return bytes(data)


def read(path: Path) -> None:
    began = time.monotonic()
    try:
        table = READERS[path.suffix](path)
        refusal, lengths = path.name, {values.size for values in table.columns.values()}
    except TorquerigError as error:
        refusal, lengths = str(error), set()
    assert path.name in refusal
    assert "\n" not in refusal
    assert len(lengths) <= 1
    assert time.monotonic() - began < LONGEST


def fuzz(folder: Path, count: int) -> None:
    rng = np.random.default_rng(56)
    files = list(dialects().values())
    texts = [content for ending, content in files if not ending.endswith((".gz", ".xlsx"))]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for number in range(count):
        ending, content = files[number % len(files)]
        path = folder / f"run{ending}"
        if ending.endswith(".gz") and rng.random() < 0.5:
            path.write_bytes(gzip.compress(mutated(gzip.decompress(content), texts, rng)))
        else:
            path.write_bytes(mutated(content, texts, rng))
        read(path)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MOST_MEMORY


@pytest.mark.long
def test_some_hundred_damaged_files(tmp_path: Path) -> None:
    fuzz(tmp_path, 240)


@pytest.mark.full
def test_thousands_of_damaged_files(tmp_path: Path) -> None:
    fuzz(tmp_path, 12_000)


@pytest.mark.parametrize(
    "content",
    [
        b"a" * 40_000_000,
        b"1," * 10_000_000,
        b"word word\n" * 300_000,
        b"1 of 2 words here\n" * 200_000,
        b"1;2\n" + b'"' * 1_000_000,
        b"x," * 20_000 + b"\n" + b"1," * 20_000 + b"\n",
        bytes(1_000_000),
        b"\n" * 5_000_000,
    ],
    ids=["one line", "one row", "words", "sentences", "quotes", "columns", "zeros", "empty lines"],
)
@pytest.mark.long
def test_large_nonsense_is_quick(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "run.csv"
    path.write_bytes(content)
    read(path)


@pytest.mark.parametrize("line", [b"\0", b"0,0\n", b"0.001;1,5\n"])
def test_a_gzip_bomb_is_refused(tmp_path: Path, line: bytes) -> None:
    path = tmp_path / "run.csv.gz"
    # joined files of one repeated line, each 1 MiB unpacked, 4.9 GiB in all
    path.write_bytes(gzip.compress(line * (2**20 // len(line))) * 5000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(TorquerigError, match=r"unpacks to more than|is binary"):
        READERS[".gz"](path)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MOST_MEMORY


def test_a_gzip_file_of_numbers_is_read(tmp_path: Path) -> None:
    values = np.random.default_rng(1).standard_normal(60_000)
    text = "torque_Nm\n" + "\n".join(f"{value:.12g}" for value in values)
    (tmp_path / "run.csv.gz").write_bytes(gzip.compress(text.encode(), compresslevel=1))
    assert READERS[".gz"](tmp_path / "run.csv.gz").columns["torque_Nm"] == pytest.approx(values, abs=1e-9)


def workbook_with(sheet: bytes) -> bytes:
    content = dialects()["workbook"][1]
    file = BytesIO()
    with zipfile.ZipFile(BytesIO(content)) as old, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as new:
        for part in old.infolist():
            new.writestr(part.filename, sheet if part.filename.endswith("sheet2.xml") else old.read(part))
    return file.getvalue()


HEAD = (
    b'<?xml version="1.0"?>{}<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>'
)
END = b"</sheetData></worksheet>"
SHEETS = {
    "bomb": HEAD.replace(b"{}", b"") + b" " * 100_000_000,
    "document type": HEAD.replace(b"{}", b'<!DOCTYPE a [<!ENTITY b "c">]>') + END,
    "cut": HEAD.replace(b"{}", b"") + b'<row r="1"><c r="A1"><v>1</v>',
    "last row": HEAD.replace(b"{}", b"")
    + b'<row r="1048576"><c r="XFD1048576"><v>1</v></c></row></sheetData></worksheet>',
    "no number": HEAD.replace(b"{}", b"") + b'<row r="1"><c r="A1"><v>1e999</v></c></row></sheetData></worksheet>',
}


@pytest.mark.parametrize("kind", SHEETS)
def test_a_nasty_workbook_costs_one_sentence(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "run.xlsx"
    path.write_bytes(workbook_with(SHEETS[kind]))
    read(path)
    if kind in ("bomb", "document type", "cut"):
        with pytest.raises(TorquerigError):
            READERS[".xlsx"](path)
