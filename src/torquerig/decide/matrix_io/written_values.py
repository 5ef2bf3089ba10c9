"""Numbers, weights and Pugh marks as people write them: decimal commas, per cent, Unicode minus and dashes."""

from __future__ import annotations

import re
from math import isfinite
from typing import Any

from torquerig.decide.matrix_io.matrix_table import UNKNOWN

LEVELS = {"++": 2, "+": 1, "S": 0, "-": -1, "--": -2}
"""Pugh marks and their numbers; ``++`` and ``--`` count double."""
LONG_DASHES = "\u2014\u2015"
_SIGNS = str.maketrans({
    **dict.fromkeys("\u2010\u2011\u2012\u2013\u2212\ufe58\ufe63\uff0d\u2014\u2015", "-"), "\uff0b": "+",
    **dict.fromkeys(" \t\r\n\u00a0\u2009\u202f", None),
})  # fmt: skip
_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)")
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")
_SPELLINGS = {"s": "S", "0": "S", "=": "S", "0.0": "S", "+1": "+", "1": "+", "-1": "-", "2": "++", "+2": "++",
              "-2": "--", "+0": "S", "-0": "S"}  # fmt: skip


def number_of(value: Any) -> float | None:
    """Return the number in a cell, or None; a comma is a decimal comma, and every dash is a minus."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value) if isfinite(value) else None
    if not isinstance(value, str):
        return None
    text = value.translate(_SIGNS)
    return float(text.replace(",", ".")) if _NUMBER.fullmatch(text) and len(text) < 40 else None


def may_be_thousands(value: Any) -> bool:
    """Return whether a text such as ``1,250`` may be a thousand or a decimal number."""
    return isinstance(value, str) and _THOUSANDS.fullmatch(value.translate(_SIGNS).removesuffix("%")) is not None


def weight_of(value: Any) -> tuple[float, bool] | None:
    """Return a weight as it counts, and whether it was written in per cent; None where it is no number.

    ``20 %`` is 0.2, so that weights in per cent sum to 1. ``20`` stays 20, and ``0,2`` is 0.2.
    """
    text = value.translate(_SIGNS) if isinstance(value, str) else value
    is_percent = isinstance(text, str) and text.endswith("%")
    number = number_of(text[:-1] if is_percent else text)
    return None if number is None else (number / 100 if is_percent else number, is_percent)


def pugh_mark(value: Any) -> str | None:
    """Return a mark as one of ``++ + S - -- ?``, or None where the cell is no mark.

    Numbers from -2 to 2, ``s``, ``0`` and ``=`` (S), the Unicode minus and all dashes are read.
    """
    if isinstance(value, bool) or value is None:
        return None
    text = f"{value:g}" if isinstance(value, int | float) else str(value).translate(_SIGNS)
    text = text.replace(",", ".")
    if re.fullmatch(r"[+-]?\d+\.0*", text):
        text = text.partition(".")[0]
    mark = _SPELLINGS.get(text, text)
    return mark if mark in LEVELS or mark == UNKNOWN else None
