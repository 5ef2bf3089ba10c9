"""Decision sheets as people write them: read by their shape, told back, refused where two readings are possible."""

import csv
import re

import numpy as np
import pytest

from tests.decide.drawn_sheets import drawn_sheet, write_sheet
from torquerig.api.decision_matrix import matrix
from torquerig.decide.matrix_io.written_sheet.reading import read_written_sheet
from torquerig.decide.matrix_io.written_values import pugh_mark, weight_of
from torquerig.errors import InputError

PUGH = [
    ["Concept selection 2024"],
    [],
    ["", "Weight", "Belt (datum)", "Gear", "Direct"],
    ["Cost", "20 %", "S", "+", "\u2212\u2212"],
    ["Noise", "0,5", "S", "\u2013", "++"],
    ["Mass", "30%", "S", "s", "+"],
    [],
    ["Sum", None, 0, 0, 1],
    ["Rank", None, None, 2, 1],
]
POINTS = [
    ["Kriterium", "Gewichtung", "A", "B"],
    ["Preis [EUR]", 0.2, "3,5", 4],
    ["L\u00e4rm [dB]", 0.3, 2, 1],
    ["Masse [kg]", 0.5, 1, 4],
    ["Summe", 1, "1,8", 3.1],
    [],
    ["Skala 0 bis 4"],
]


def read(tmp_path, rows, **options):
    return read_written_sheet(write_sheet(tmp_path / "sheet.xlsx", rows, **options))


def turned(rows):
    width = max(map(len, rows))
    return [list(column) for column in zip(*[[*row, *[None] * (width - len(row))] for row in rows], strict=True)]


def changed(rows, **cells):
    """Return the rows with cells such as ``C4`` replaced."""
    made = [[*row] for row in rows]
    for name, value in cells.items():
        made[int(name[1:]) - 1][ord(name[0]) - ord("A")] = value
    return made


@pytest.mark.parametrize(
    ("cells", "mark"),
    [
        (("++", "+ +", 2, 2.0, "+2", "\uff0b\uff0b"), "++"),
        (("+", 1, "1", "+1", " + "), "+"),
        (("S", "s", 0, "0", "=", 0.0), "S"),
        (("-", "\u2212", "\u2013", "\u2010", "\u2011", -1, "\u22121", "-1,0"), "-"),
        (("--", "\u2212\u2212", "\u2013\u2013", "- -", -2), "--"),
        (("better", 3, 0.5, "+++", "+-", True, None, "", 1e300), None),
    ],
)
def test_every_spelling_of_a_mark_is_read(cells, mark):
    assert {pugh_mark(cell) for cell in cells} == {mark}


@pytest.mark.parametrize(
    ("cell", "weight"),
    [("20 %", 0.2), ("20%", 0.2), ("12,5 %", 0.125), ("0,2", 0.2), (20, 20), ("20", 20), ("a lot", None), (True, None)],
)
def test_a_weight_in_per_cent_is_a_fraction(cell, weight):
    assert (weight_of(cell) or (None,))[0] == weight


@pytest.mark.parametrize("turn", [False, True])
def test_a_weighted_pugh_sheet_shows_the_plain_and_the_weighted_sum(tmp_path, turn):
    rows = turned(PUGH[2:]) if turn else PUGH
    result = matrix(write_sheet(tmp_path / "sheet.xlsx", rows, name="Tabelle 7"))
    found = {row.alternative: (row.total, round(row.weighted, 9), row.rank) for row in result.ranking.itertuples()}
    assert found == {"Direct": (1, 0.9, 1), "Gear": (0, -0.3, 2)}
    (table,) = result.tables.tables
    assert (table.baseline, table.weights) == ("Belt (datum)", (0.2, 0.5, 0.3))
    assert not result.differences
    said = "\n".join(result.understood)
    for word in ("Pugh", "in per cent", "they count in the weighted sum", "datum: 'Belt (datum)'", "unweighted sum"):
        assert word in said


@pytest.mark.parametrize(
    ("rows", "cells"),
    [
        (PUGH, ("D3:E3 (Gear, Direct)", "criteria: A4:A6", "weights: B4:B6", "'Sum' in A8", "'Rank' in A9", "in C3")),
        (turned(PUGH[2:]), ("A4:A5 (Gear, Direct)", "B1:D1", "B2:D2", "'Sum' in F1", "'Rank' in G1", "in A3")),
        (POINTS, ("C1:D1 (A, B)", "A2:A4", "B2:B4", "'Summe' in A5", "scale: 0 to 4", "A7 'Skala 0 bis 4'")),
    ],
)
def test_what_was_understood_names_the_cells(tmp_path, rows, cells):
    said = "\n".join(read(tmp_path, rows).understood)
    assert [one for one in cells if one not in said] == []


def test_a_kesselring_sheet_with_decimal_commas_is_read(tmp_path):
    result = matrix(write_sheet(tmp_path / "x.xlsx", POINTS))
    rows = {row.alternative: (round(row.total, 9), round(row.share_of_ideal, 9)) for row in result.ranking.itertuples()}
    assert rows == {"B": (3.1, 0.775), "A": (1.8, 0.45)}
    assert result.summary() == "Tabelle1: B ranked first by kesselring"


def test_without_a_scale_the_sums_are_known_and_the_share_is_not(tmp_path):
    result = matrix(write_sheet(tmp_path / "x.xlsx", POINTS[:5]))
    assert result.ranking["share_of_ideal"].isna().all()
    assert "points scale: not stated" in result.understood


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        ({"E8": 3}, "difference: 'Sum' in A8: Direct: the sheet has 3, the cells give 1 (the unweighted sum"),
        ({"D9": 1, "E9": 2}, "difference: 'Rank' in A9: the ranks do not follow from the cells: Gear 1 (computed 2)"),
        ({"A8": "weighted sum", "D8": "-0,3", "E8": 0.8}, "Direct: the sheet has 0.8, the cells give 0.9"),
        ({"B8": "90 %"}, "difference: the sum of the weights in B8 is 0.9, the weights sum to 1"),
        (
            {"A8": "Number of +", "C8": 0, "D8": 1, "E8": 4},
            "Direct: the sheet has 4, the cells give 2 (the count",
        ),
    ],
)
def test_a_total_that_differs_is_told(tmp_path, cells, said):
    differences = [one for one in read(tmp_path, changed(PUGH, **cells)).understood if one.startswith("difference")]
    assert len(differences) == 1
    assert said in differences[0]


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        ({"A8": "weighted sum", "D8": "-0,3", "E8": "0,9"}, "'weighted sum' in A8 is the weighted sum, and agrees"),
        ({"D8": -30, "E8": 90}, "'Sum' in A8 is 100 times the weighted sum"),
        ({"A8": "\u03a3 +", "D8": 1, "E8": 2}, "is the count of +, and agrees"),
        ({"A8": "Anzahl \u2212", "D8": 1, "E8": 1}, "is the count of -, and agrees"),
    ],
)
def test_a_total_of_any_kind_is_recognised(tmp_path, cells, said):
    understood = "\n".join(read(tmp_path, changed(PUGH, **cells)).understood)
    assert said in understood
    assert "difference: 'S" not in understood.replace("'Rank'", "")


def test_weighted_points_next_to_the_points_are_no_alternatives(tmp_path):
    rows = [
        ["", "", "A", None, "B", None],
        ["Criterion", "Weight", "P", "P x G", "P", "P x G"],
        ["c1", 0.5, 3, 1.5, 4, 2],
        ["c2", 0.3, 2, 0.6, 4, 1.2],
        ["c3", 0.2, 1, 0.2, 0, 0.1],
        ["Total", 1, None, 2.3, None, 3.2],
    ]
    result = matrix(write_sheet(tmp_path / "x.xlsx", rows, merged=("C1:D1", "E1:F1")))
    assert {row.alternative: row.total for row in result.ranking.itertuples()} == pytest.approx({"A": 2.3, "B": 3.2})
    assert [one.what for one in result.findings if "products" in one.lint] == ["B: 0.2 x 0 is 0, printed is 0.1"]


def test_two_sheets_are_two_tables_and_a_page_of_text_is_said_not_to_be_one(tmp_path):
    import openpyxl

    path = write_sheet(tmp_path / "x.xlsx", PUGH)
    book = openpyxl.load_workbook(path)
    for row in POINTS:
        (book["Punkte"] if "Punkte" in book.sheetnames else book.create_sheet("Punkte")).append(row)
    book.create_sheet("Notes").append(["only", "text"])
    book.save(path)
    result = read_written_sheet(path)
    assert [(table.name, table.method.value) for table in result.tables.tables] == [
        ("Tabelle1", "pugh"), ("Punkte", "kesselring"),
    ]  # fmt: skip
    assert "sheet 'Notes': has no matrix and was not read" in result.understood


@pytest.mark.parametrize(("separator", "codec"), [(";", "utf-8-sig"), ("\t", "utf-16"), (";", "cp1252")])
def test_a_sheet_saved_as_text_is_the_same(tmp_path, separator, codec):
    rows = [[str(cell).replace("\u2212", "-") if cell is not None else "" for cell in row] for row in PUGH]
    path = tmp_path / "sheet.csv"
    path.write_bytes("\r\n".join(separator.join(row) for row in rows).encode(codec))
    assert read_written_sheet(path).tables.tables[0].column("Direct") == ("--", "++", "+")


@pytest.mark.parametrize("separator", [";", "\t", ","])
@pytest.mark.parametrize("seed", range(8))
def test_a_shuffled_layout_as_text_gives_the_same_numbers(tmp_path, separator, seed):
    drawn = drawn_sheet(seed)
    path = tmp_path / "sheet.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, delimiter=separator).writerows(drawn.rows)
    result = matrix(path)
    assert {row.alternative: row.total for row in result.ranking.itertuples()} == pytest.approx(drawn.totals)
    assert bool(result.differences) == drawn.differs


@pytest.mark.parametrize("line", ["Cost,0,5,S,+,cheap", "Cost,0.5,S,+,\nSum,1,0,2,5,x"])
def test_a_decimal_comma_among_separating_commas_is_refused(tmp_path, line):
    path = tmp_path / "sheet.csv"
    rows = ["Criterion,Weight,Datum,A,Remarks", "Noise,0.5,S,-,quiet", "Mass,0.5,S,S,same", "Wear,0.5,S,+,less"]
    path.write_text("\n".join([*rows, line]), encoding="utf-8")
    with pytest.raises(InputError, match=r"sheet.csv:\d: has 6 cells where most lines have 5; a decimal comma"):
        read_written_sheet(path)


GRID = [["", "Belt", "Gear", "Direct"], ["Cost", 1, 2, 1], ["Noise", 2, 0, 1]]
REFUSED = {
    "nothing decides": (GRID, r"alternatives may be 'Belt', 'Gear', 'Direct' \(row 1\) or 'Cost', 'Noise'"),
    "contradiction": (
        [["", "Weight", "A", "Sum"], ["Cost", "50 %", 1, 1], ["Noise", "50 %", 2, 2]],
        r"may be the criteria \(.*Weight.*B1.*\) or the alternatives \('Sum' in D1",
    ),
    "weight or mass": ([["", "Weight", "B"], ["Cost", 3, 4], ["Noise", 2, 1]], "nothing in the sheet decides it"),
    "zeros or a datum": (changed(GRID, A1="Criterion", C2=0), r"0 to 2 may be points, or Pugh marks with 'Gear'"),
    "two datums": (changed(PUGH, C3="Belt", D4="S", D5="S"), r"datum may be 'Belt' or 'Gear'.*add '\(datum\)'"),
    "two named datums": (changed(PUGH, D3="Reference"), "C3 and D3 both name the datum"),
    "datum not S": (changed(PUGH, C5="+"), r"cell C5: the datum 'Belt \(datum\)' has '\+'"),
    "points in marks": (changed(PUGH, D4=4), r"cell D4: '4' is no Pugh mark.*has the Pugh mark"),
    "a word": (changed(PUGH, D4="good"), "cell D4: 'good' is neither a mark nor points"),
    "long dash": (changed(PUGH, D5="\u2014", D6="-"), "cell D5: the long dash .* may be - or --"),
    "percent and plain": (changed(PUGH, B5=50), "cell B5: '50' may be a weight of 50 or of as many per cent"),
    "weight missing": (changed(PUGH, B5=None), "cell B5: the weight is missing"),
    "weight a thousand": (changed(POINTS, B2="1,250"), "cell B2: '1,250' may be 1.25 or 1250"),
    "negative weight": (changed(POINTS, B2=-1), "cell B2: the weight -1 must be at least 0"),
    "zero weights": (changed(POINTS, B2=0, B3=0, B4=0), "cell B2: all weights are 0"),
    "outside the scale": (changed(POINTS, D2=7), "cell D2: 7 points are outside the scale 0..4"),
    "no name of a row": (changed(PUGH, A5=None), "cell A5: the values of C?D?5?.* have no name|have no name"),
    "no name of a column": (changed(POINTS, D1=None), "D2:D5: these values have no name"),
    "names twice": (changed(POINTS, D1="A"), "the name 'A' occurs twice, over D2:D4 and C2:C4"),
    "criterion twice": (changed(POINTS, A3="Preis [EUR]"), "cell A3: the criterion 'Preis .EUR.' occurs twice"),
    "half a row": (changed(PUGH, D5=None, E5=None), "cell A5: 'Noise' has 0 of 2 values"),
    "unknown without scale": (changed(POINTS[:5], D2="?"), "cell D2: the points are unknown, and the sheet"),
    "subtotals": ([*PUGH[:8], ["Price", "10 %", "S", "+", "-"]], "cell A9: 'Price' comes after the sum 'Sum' in A8"),
    "a second table": (
        [*POINTS, [], *[[*[None] * 8, *row] for row in POINTS[:4]]], "there is a second table at I9"
    ),
    "no table": ([["only"], ["text", 5]], "has no decision matrix; write the alternatives in one row"),
}  # fmt: skip


@pytest.mark.parametrize(("rows", "said"), REFUSED.values(), ids=REFUSED)
def test_what_has_two_readings_or_none_is_refused_with_its_cell(tmp_path, rows, said):
    with pytest.raises(InputError) as raised:
        read(tmp_path, rows)
    assert re.search(said, str(raised.value)), str(raised.value)
    assert "\n" not in str(raised.value)


def test_an_ambiguous_sheet_is_read_after_its_remedy(tmp_path):
    assert read(tmp_path, changed(GRID, A1="criterion")).tables.tables[0].alternatives == ("Belt", "Gear", "Direct")
    assert read(tmp_path, changed(GRID, A1="alternative")).tables.tables[0].alternatives == ("Cost", "Noise")


def outcome(path):
    try:
        return matrix(path)
    except InputError:
        return None


@pytest.mark.parametrize("seed", range(40))
def test_a_shuffled_layout_gives_the_same_numbers_or_a_refusal(tmp_path, seed):
    drawn = drawn_sheet(seed)
    result = outcome(write_sheet(tmp_path / "x.xlsx", drawn.rows))
    if result is None:
        assert seed in REFUSED_LAYOUTS
        return
    (table,) = result.tables.tables
    assert table.method.value == drawn.method
    assert [row.criterion for row in table.rows] == drawn.criteria
    assert {row.alternative: row.total for row in result.ranking.itertuples()} == pytest.approx(drawn.totals)
    if drawn.weights is not None:
        assert np.allclose(table.weights, drawn.weights)
    assert bool(result.differences) == drawn.differs


REFUSED_LAYOUTS = (10,)  # points without weights, corner and totals, in which nothing names the alternatives
