"""Text of foreign files made harmless: control characters for terminals and pages, formulas for spreadsheets."""

from __future__ import annotations

import re

# C0 and C1 control characters but tab and line feed, marks that reverse the direction of text, halves of characters
_ACTING = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?%?")
FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r")


def harmless(text: str) -> str:
    r"""Return the text with each character that would act on a terminal as its escape, such as ``\x1b``.

    A carriage return before a line feed stays.

    Examples
    --------
    >>> harmless("torque\x1b[31m")
    'torque\\x1b[31m'
    """
    return _ACTING.sub(_escaped, text) if _ACTING.search(text) else text


def _escaped(found: re.Match[str]) -> str:
    if found[0] == "\r" and found.string[found.end() : found.end() + 1] == "\n":
        return "\r"
    return found[0].encode("unicode_escape", "backslashreplace").decode("ascii")


def csv_cell(text: str) -> str:
    """Return the text of a CSV cell, with an apostrophe before it where a spreadsheet would take it for a formula.

    Source: OWASP, CSV injection. Numbers and a lone ``-`` or ``+`` stay as they are.

    Examples
    --------
    >>> csv_cell("=1+1"), csv_cell("-0.5"), csv_cell("-")
    ("'=1+1", '-0.5', '-')
    """
    starts = text.startswith(FORMULA_STARTS) and len(text) > 1
    return f"'{text}" if starts and not _NUMBER.fullmatch(text) else text
