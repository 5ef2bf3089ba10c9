"""The text of the matrix command, for the shipped files."""

from pathlib import Path

import pytest

from torquerig.decide.matrix_io.computed_tables import computed_tables, survivors
from torquerig.decide.matrix_io.matrix_file import read_matrix
from torquerig.decide.matrix_io.matrix_report import matrix_report
from torquerig.errors import InputError

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def line_of(text, start, *, after=""):
    part = text[text.index(after) :]
    return next(line.split() for line in part.splitlines() if line.startswith(start))


def test_published_tables_stand_printed_beside_recomputed():
    text = matrix_report(SCENARIOS / "reference_tables.yaml")
    assert line_of(text, "SUM as printed", after="Table IV")[3:] == ["-3", "-1", "-1", "1", "-1"]
    assert line_of(text, "SUM recalculated", after="Table IV")[-5:] == ["-3", "-1", "-1", "1", "-1"]
    assert line_of(text, "net with ? either way", after="Table V ")[-5:] == ["-4..0", "-2..2", "-2..2", "-4..0", "0..4"]
    assert line_of(text, "Rank as printed", after="Table III")[3:] == ["2", "1", "1", "4", "3"]
    assert line_of(text, "Sum as printed", after="Table VI (")[3:] == ["4.25", "2.85", "2.75", "2.15", "2.6"]
    assert line_of(text, "Sum recalculated", after="Table VI (")[2:] == ["4.25", "2.85", "2.45", "1.85"]
    assert line_of(text, "Sum recalculated", after="Table VI, cut")[2:] == [
        "4.25",
        "2.85",
        "2.75",
        "2.15",
        "1.15..3.35",
    ]
    assert "allows 14 sets of values" in text
    assert "Errors in the tables: 37 findings" in text
    assert "\x1b" not in text


def test_ones_own_matrix_runs_through_the_three_engines_and_the_lints():
    text = matrix_report(SCENARIOS / "matrix_example.yaml")
    assert line_of(text, "servo A", after="Elimination")[-2:] == ["+", "open"]
    assert "missing: the gearbox efficiency at peak torque of servo" in text
    assert "servo drive must be yes: it is no" in text
    assert line_of(text, "servo drive", after="Pugh against")[-3:] == ["S", "S", "-"]
    assert "left out, because a requirement eliminates it: induction motor B" in text
    assert "price inside the technical rating" in text
    assert text == matrix_report(SCENARIOS / "matrix_example.yaml")


def test_an_eliminated_alternative_is_not_rated():
    case = read_matrix(SCENARIOS / "matrix_example.yaml")
    assert survivors(case.matrix).alternatives == ("present drive", "servo A")
    assert computed_tables(case).table("Kesselring").alternatives == ("present drive", "servo A")


def test_a_matrix_of_unknowns_alone_still_gives_intervals(tmp_path):
    path = tmp_path / "m.yaml"
    path.write_text(
        "criteria:\n  x: {weight: 1, points: [[0, 1], [1, 5]], requirement: {min: 0}}\n"
        "alternatives:\n  a: {}\n  b: {x: '?'}\ndraws: 2000\n",
        encoding="utf-8",
    )
    text = matrix_report(path)
    assert line_of(text, "T ", after="Kesselring")[-2:] == ["1..5", "1..5"]
    assert line_of(text, "a ", after="Elimination")[-1] == "open"


def test_a_missing_file_is_one_sentence(tmp_path):
    with pytest.raises(InputError, match="there is no such file"):
        matrix_report(tmp_path / "none.yaml")
