"""Plain tables: alignment, ruling, cutting."""

from __future__ import annotations

import pytest

from torquerig.plain_table import cut, fixed, grid, wrapped


def test_columns_of_numbers_stand_to_the_right_and_signs_do_not() -> None:
    table = grid([["name", "value", "sign"], ["a", "1.5", "+"], ["bb", "-", "-"], ["c", "10 %", "-"]])
    assert table.splitlines() == [
        "name  value  sign",
        "-----------------",
        "a       1.5  +",
        "bb        -  -",
        "c      10 %  -",
    ]


def test_a_column_of_nothing_but_marks_holds_no_numbers() -> None:
    assert grid([["drive", "x"], ["a", "-"], ["b", "?"]]).splitlines()[2] == "a      -"


def test_stated_columns_go_before_detection() -> None:
    assert grid([["n", "text"], ["1", "a"]], right={1}).splitlines()[2] == "1     a"


def test_long_texts_are_cut_and_wrapped() -> None:
    assert cut("abcdef", 4) == "abc…"
    assert all(len(line) <= 120 for line in wrapped("word " * 100).splitlines())


@pytest.mark.parametrize(("value", "scale", "shown"), [
    (1.20077, 1.2, "1.20077"), (0.17161, 1.2, "0.17161"), (0.0017161, 0.012, "0.0017161"), (171.61, 1200.0, "171.61"),
    (1.2e6, 1.2e6, "1200000"), (0.0, 0.0, "0.00000"), (3e-9, 2e-9, "0.00000000300000"),
])  # fmt: skip
def test_numbers_have_the_digits_of_their_scale(value: float, scale: float, shown: str) -> None:
    assert fixed(value, scale=scale, digits=6) == shown
