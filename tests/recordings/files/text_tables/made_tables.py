"""One table of numbers, written in the dialects of loggers, Excel, LabVIEW and MATLAB."""

from collections.abc import Callable
from datetime import datetime, timedelta
from io import BytesIO

import numpy as np
import openpyxl

ROWS = 40
TIME = np.arange(ROWS) / 1000
TORQUE = np.round(2 + 0.2 * np.sin(np.arange(ROWS)), 4)
SPEED = np.round(1234.5 + 3 * np.cos(np.arange(ROWS) / 5), 2)
NAMES = ("Time [s]", "Torque [Nm]", "Speed [rpm]")
START = datetime(2021, 5, 12, 10, 11, 12)
NUMBERS = [(f"{a:.3f}", f"{b:.4f}", f"{c:.2f}") for a, b, c in zip(TIME, TORQUE, SPEED, strict=True)]


def text(
    separator: str = ",", *, decimal: str = ".", names: tuple[str, ...] = NAMES, rows: list[tuple[str, ...]] = NUMBERS,
    before: str = "", after: str = "", end: str = "\n", trailing: str = "",
) -> str:  # fmt: skip
    """Return the table; ``before`` and ``after`` are lines around it, ``trailing`` is at the end of each line."""
    lines = [separator.join(names) + trailing] if names else []
    lines += [separator.join(row).replace(".", decimal) + trailing for row in rows]
    return (before + "\n".join(lines) + "\n" + after).replace("\n", end)


def with_cells(place: int, cell: Callable[[int], str]) -> list[tuple[str, ...]]:
    """Return the rows with one more cell each, or with the time replaced where ``place`` is negative."""
    rows = [list(row) for row in NUMBERS]
    for number, row in enumerate(rows):
        if place < 0:
            row[0] = cell(number)
        else:
            row.insert(place, cell(number))
    return [tuple(row) for row in rows]


def moment(number: int) -> datetime:
    """Return the time of a row."""
    return START + timedelta(milliseconds=number)


def iso(number: int) -> str:
    """Return the time of a row as ISO 8601 writes it."""
    return moment(number).isoformat(timespec="milliseconds")


def grouped(sign: str, point: str) -> list[tuple[str, ...]]:
    """Return the rows with thousands grouped by ``sign``."""
    return [
        (a.replace(".", point), b.replace(".", point), f"{float(c):,.2f}".replace(".", "?").replace(",", sign)
         .replace("?", point))
        for a, b, c in NUMBERS
    ]  # fmt: skip


UNITS_ROW = "Time;Torque;Speed\ns;Nm;rpm\n" + text(";", names=(), decimal=",")
PREAMBLE = "Recorder 5\nOperator: Smith\nDate: 12.05.2021 10:11:12\nChannels: 3\n\n"
STAMPED = ("Timestamp", *NAMES[1:])
PLAIN = {
    "comma": text(),
    "semicolon": text(";"),
    "semicolon, decimal comma": text(";", decimal=","),
    "tab": text("\t"),
    "tab, decimal comma": text("\t", decimal=","),
    "bar": text("|"),
    "comma and blank": text(", "),
    "blanks": text("   ", names=("Time_s", "Torque_Nm", "Speed_rpm")),
    "aligned, blanks in names": text("   ", decimal=","),
    "CR LF": text(end="\r\n"),
    "CR": text(end="\r"),
    "blank lines": text().replace("\n", "\n\n"),
    "trailing semicolons": text(";", decimal=",", trailing=";"),
    "trailing semicolons below the names": text(";", trailing=";").replace("]; \n", "]\n").replace("rpm];", "rpm]"),
    "quoted": "\n".join(",".join(f'"{cell}"' for cell in row) for row in (NAMES, *NUMBERS)),
    "quoted decimal commas": "\n".join(
        ",".join(f'"{cell}"' for cell in row) for row in (NAMES, *((a, b, c) for a, b, c in NUMBERS))
    ).replace(".", ","),
    "sep=": text(";", decimal=",", before="sep=;\n"),
    "round brackets": text(names=("Time (s)", "Torque (Nm)", "Speed (rpm)")),
    "slashes": text(";", names=("Zeit / s", "Torque / Nm", "Speed / rpm")),
    "line feed in names": text(names=('"Time\n[s]"', '"Torque\n[Nm]"', '"Speed\n[rpm]"')),
    "units row": UNITS_ROW,
    "units row in brackets": UNITS_ROW.replace("s;Nm;rpm", "[s];[Nm];[rpm]"),
    "preamble": text(before=PREAMBLE),
    "preamble with commas": text(before="File,run.csv,Version,3\nRange,20,N m\n"),
    "long preamble": text(before="".join(f"Setting {number}: {number * 3} ok\n" for number in range(900))),
    "preamble with a small table": text(before="point,volt\n1,0.5\n2,1.0\n3,1.5\n\n"),
    "comments": text(before="# rig 3\n% no load\n// 5 A, 3 V\n"),
    "quoted comment": text(before='"# Test started, vbus = 14.9 V"\n'),
    "names in a comment": text(before="# ", decimal="."),
    "footer": text(after="\nEnd of file\nSamples: 40\n"),
    "footer of figures": text(";", decimal=",", after="Max;2,2;1237,5\nMean;2,0;1234,5\n"),
    "comment between the rows": text().replace("\n0.020", "\n# knock at 3 s\n0.020"),
    "states": text(names=(*NAMES, "state"), rows=with_cells(3, lambda number: f"S{number % 3}")),
    "words": text(names=("Run Name", *NAMES), rows=with_cells(0, lambda _: "run A")),
    "empty column": text(names=(*NAMES, "remark"), rows=with_cells(3, lambda _: "")),
    "remark in one row": text(names=(*NAMES, "remark"), rows=with_cells(3, lambda n: "knock 2" if n == 7 else "")),
    "number of the row": text(names=("", *NAMES), rows=with_cells(0, str)),
    "thousands by commas": text(";", rows=grouped(",", ".")),
    "thousands by points": text(";", rows=grouped(".", ",")),
    "thousands by apostrophes": text(";", rows=grouped("'", ".")),
    "quoted thousands": text(rows=[(a, b, f'"{c}"') for a, b, c in grouped(",", ".")]),
    "plus signs": text(rows=[tuple(f"+{cell}" for cell in row) for row in NUMBERS]),
    "ISO stamps": text(names=STAMPED, rows=with_cells(-1, iso)),
    "ISO stamps with zone": text(names=STAMPED, rows=with_cells(-1, lambda n: iso(n) + "+02:00")),
    "day first": text("\t", names=STAMPED, rows=with_cells(-1, lambda n: f"{moment(n):%d.%m.%Y %H:%M:%S.%f}")),
    "month first": text(names=STAMPED, rows=with_cells(-1, lambda n: f"{moment(n):%m/%d/%Y %I:%M:%S.%f %p}")),
    "comma before milliseconds": text(";", names=STAMPED, rows=with_cells(-1, lambda n: f"{moment(n):%H:%M:%S,%f}")),
    "name of the month": text(names=STAMPED, rows=with_cells(-1, lambda n: f"{moment(n):%d-%b-%Y %H:%M:%S.%f}")),
    "date and clock": text(names=("Date", "Time", *NAMES[1:]), rows=[
        (f"{moment(n):%d.%m.%Y}", f"{moment(n):%H:%M:%S.%f}", *row[1:]) for n, row in enumerate(NUMBERS)]),
    "stamps between blanks": text(" ", names=("Time", "Torque_Nm", "Speed_rpm"), rows=with_cells(
        -1, lambda n: f"{moment(n):%Y-%m-%d %H:%M:%S.%f}")),
    "milliseconds": text(names=("Time [ms]", *NAMES[1:]), rows=with_cells(-1, str)),
}  # fmt: skip


def dialects() -> dict[str, tuple[str, bytes]]:
    """Return ending and bytes of each file, by what is special about it."""
    import gzip

    made = {kind: (".csv", one.encode()) for kind, one in PLAIN.items()}
    made["byte order mark"] = (".csv", b"\xef\xbb\xbf" + text().encode())
    made["UTF-16"] = (".txt", text("\t", decimal=",").encode("utf-16"))
    made["UTF-16 big"] = (".txt", b"\xfe\xff" + text("\t").encode("utf-16-be"))
    made["UTF-16 without mark"] = (".csv", text(";").encode("utf-16-le"))
    made["latin-1"] = (".asc", text(before="Prüfstand 5 µm, 20 °C\n\n", after="Ende der Prüfung\n").encode("latin-1"))
    made["zeros at the end"] = (".dat", text().encode() + bytes(300))
    made["gzip"] = (".csv.gz", gzip.compress(text(";", decimal=",").encode()))
    made["two joined gzip files"] = (
        ".txt.gz",
        gzip.compress(text().encode()[:700]) + gzip.compress(text().encode()[700:]),
    )
    made["workbook"] = (".xlsx", workbook(stamped=False))
    made["workbook with dates"] = (".xlsx", workbook(stamped=True))
    return made


def workbook(*, stamped: bool) -> bytes:
    """Return an Excel workbook with a first sheet of words, and the table below a title and above a remark."""
    book = openpyxl.Workbook()
    book.active.append(["Test of the rig", "May"])
    sheet = book.create_sheet("Data")
    sheet.append(["Torque test 12"])
    sheet.append([])
    sheet.append(["Timestamp" if stamped else "Time", "Torque", "Speed", "remark"])
    sheet.append([None if stamped else "s", "Nm", "rpm"])
    for number, row in enumerate(zip(TIME, TORQUE, SPEED, strict=True)):
        sheet.append([moment(number) if stamped else row[0], *row[1:], "start" if number == 0 else None])
    sheet.append(["made by hand"])
    file = BytesIO()
    book.save(file)
    return file.getvalue()
