"""Cells of a text table: numbers with decimal sign and thousands separator, missing values, words."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

MISSING = (
    "", "nan", "-nan", "+nan", "na", "n/a", "n.a.", "#n/a", "#na", "null", "none", "nil", "missing",
    "ovld", "ovl", "ol", "-ol", "+ol", "overload", "overrange", "over range", "overflow", "ovfl", "ufl",
    "underflow", "underrange", "underload", "open", "error", "err", "invalid", "bad",
    "1.#inf", "-1.#inf", "+1.#inf", "1.#ind", "-1.#ind", "1.#qnan", "-1.#qnan", "1.#snan", "-1.#snan",
    "#div/0!", "#value!", "#ref!", "#name?", "#num!", "#null!", "#wert!", "#bezug!", "#zahl!",
    "-", "--", "---", "----", "-----", "------", "*", "**", "***", "****", "?", "??", "???", ".", "..",
)  # fmt: skip
"""Cells, in lower case, that stand for a missing number: of loggers, Excel, LabVIEW and Microsoft's C library."""

_POINT = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
# 1.0D+00, an exponent of Fortran
_FORTRAN = re.compile(r"(?<=[0-9.])[dD](?=[+-][0-9]{2,3}$)")
_COMMA = re.compile(r"[+-]?(?:[0-9]+(?:,[0-9]+)?|,[0-9]+)(?:[eE][+-]?[0-9]+)?")
_INTEGER = re.compile(r"[+-]?[0-9]+")
# 1.234,5 or 1.234.567; 1,234.5 or 1,234,567: more than one reading is not possible
_GROUPED_BY_POINT = re.compile(r"[+-]?[1-9][0-9]{0,2}(?:(?:\.[0-9]{3})+,[0-9]+|(?:\.[0-9]{3}){2,})")
_GROUPED_BY_COMMA = re.compile(r"[+-]?[1-9][0-9]{0,2}(?:(?:,[0-9]{3})+\.[0-9]+|(?:,[0-9]{3}){2,})")
_ONE_GROUP = {sign: re.compile(rf"[+-]?[1-9][0-9]{{0,2}}\{sign}[0-9]{{3}}") for sign in ",."}
_FORMS = {
    "integer": _INTEGER, "groups by point": _GROUPED_BY_POINT, "groups by comma": _GROUPED_BY_COMMA,
    "one group by point": _ONE_GROUP["."], "point": _POINT, "one group": _ONE_GROUP[","], "comma": _COMMA,
}  # fmt: skip
# the group signs of Switzerland and France are never decimal signs
_OTHER_GROUPS = re.compile(r"(?<=[0-9])['\u2019\u00a0\u202f](?=[0-9]{3}(?![0-9]))")
_INFINITE = ("inf", "+inf", "-inf", "infinity", "-infinity", "+infinity", "\u221e", "-\u221e")

ONE_READING = (
    "write numbers without a sign between thousands; if it is a decimal sign, write a point and separate the cells by "
    "tabs"
)
"""What to do where a number has two readings."""


@dataclass(frozen=True)
class Dialect:
    """The separator of the cells, the decimal sign of the numbers, and the sign between groups of thousands."""

    separator: str
    decimal: str
    thousands: str = ""

    def cells(self, line: str) -> list[str]:
        """Return the cells of one line, without blanks and quotes around them."""
        return split_cells(line, self.separator)

    def number(self, cell: str) -> float | None:
        """Return the number in a cell, NaN where it is missing, None where it is not a number."""
        lowered = cell.lower()
        if lowered in MISSING:
            return float("nan")
        if lowered in _INFINITE:
            return float("-inf" if lowered.startswith("-") else "inf")
        text = _plain(cell)
        # once the decimal sign is known, 1.234,5 has one reading, and 1.234 only where groups are usual
        other = "." if self.decimal == "," else ","
        grouped = _GROUPED_BY_POINT if other == "." else _GROUPED_BY_COMMA
        if grouped.fullmatch(text) or (self.thousands == other and _ONE_GROUP[other].fullmatch(text)):
            text = text.replace(other, "")
        if (_COMMA if self.decimal == "," else _POINT).fullmatch(text) is None:
            return None
        return float(text.replace(self.decimal, "."))


def split_cells(line: str, separator: str) -> list[str]:
    """Return the cells of one line, without blanks and quotes around them; a blank stands for any run of blanks."""
    if separator == " ":
        line = " ".join(line.split()) if '"' not in line else line.strip()
    if '"' not in line:
        return [cell.strip() for cell in line.strip("\r\n").split(separator)]
    try:
        row = next(csv.reader([line.strip("\r\n")], delimiter=separator, skipinitialspace=True), [""])
    except csv.Error:
        row = line.split(separator)
    return [cell.strip() for cell in row]


def form_of(cell: str) -> str:
    """Return the form of a number as it is written; empty where the cell is no number.

    ``integer``, ``point`` (1.5), ``comma`` (1,5), ``one group`` (1,234: 1234 or 1.234), ``one group by point``
    (1.234: 1.234 or 1234), ``groups by point`` (1.234,5) or ``groups by comma`` (1,234.5).
    """
    text = _plain(cell)
    return next((form for form, pattern in _FORMS.items() if pattern.fullmatch(text)), "")


def _plain(cell: str) -> str:
    text = _OTHER_GROUPS.sub("", cell.replace("\u2212", "-"))
    return _FORTRAN.sub("E", text) if "." in text else text


def is_missing(cell: str) -> bool:
    """Return whether the cell stands for a missing number; an infinite one counts."""
    return cell.lower() in MISSING or cell.lower() in _INFINITE


def two_readings(cell: str) -> str:
    """Return both readings of a number with one group, ``1234 or 1.234``; empty for every other cell."""
    form = form_of(cell)
    if form not in ("one group", "one group by point"):
        return ""
    plain = cell.replace(",", ".")
    return f"{plain.replace('.', '')} or {plain}"


def signs_of(forms: Iterable[str]) -> tuple[str, str] | None:
    """Return decimal sign and thousands separator that the forms of all numbers determine; None where they do not.

    Where cells of both signs occur, the more frequent form decides, and the others are faulty cells.
    """
    count = Counter(forms)
    point = count["point"] + count["groups by comma"]
    comma = count["comma"] + count["groups by point"]
    if not point and not comma:
        return None if count["one group"] or count["one group by point"] else (".", "")
    if point >= comma:
        return ".", "," if count["groups by comma"] or count["one group"] else ""
    return ",", "." if count["groups by point"] or count["one group by point"] else ""
