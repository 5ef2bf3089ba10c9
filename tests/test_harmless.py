"""Foreign text cannot act on a terminal or in a spreadsheet."""

from __future__ import annotations

import pytest

from torquerig.harmless import csv_cell, harmless


@pytest.mark.parametrize(
    "text",
    ["\x1b[31mred", "\x1b]0;title\x07", "\x9b2J", "a\rb", "a\x08b", "\u202egnp", "\ud800", "a\x00b", "\x7f", "\x0c"],
)
def test_what_acts_on_a_terminal_is_shown_as_escape(text: str) -> None:
    assert harmless(text).isprintable()
    assert "\\" in harmless(text)


@pytest.mark.parametrize("text", ["Nm·µ²Ω –", "a\tb\nc\r\n", "Drehmoment äöü", "扭矩", "🙂", ""])
def test_other_text_stays(text: str) -> None:
    assert harmless(text) == text


@pytest.mark.parametrize("text", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "=", "-1e5x"])
def test_a_formula_becomes_text(text: str) -> None:
    assert csv_cell(text) == (f"'{text}" if len(text) > 1 else text)


@pytest.mark.parametrize("text", ["1.5", "-1.5", "+2", "-1e-5", "-12.5%", "-", "?", "torque", "", "a=b"])
def test_numbers_and_words_stay(text: str) -> None:
    assert csv_cell(text) == text
