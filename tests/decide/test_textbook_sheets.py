"""Sheets in the forms of textbooks and works standards: groups, heads of two lines, results of many names, legends."""

import random
from pathlib import Path

import openpyxl
import pytest

from tests.decide.drawn_sheets import write_sheet
from torquerig.api.decision_matrix import matrix
from torquerig.cli import main
from torquerig.decide.matrix_io.matrix_report import published_tables_text
from torquerig.decide.matrix_io.written_sheet import reading
from torquerig.decide.matrix_io.written_sheet.grid import Grid
from torquerig.errors import InputError

GROUPS = [
    ["Pugh-Matrix Antrieb"],
    ["", "Kriterium", "Gewichtung", "Riemen", "Zahnrad", "Direkt"],
    ["Technisch", "Welligkeit", 3, "D", "+", "++"],
    [None, "Steifigkeit", 2, "A", "+", "+"],
    [None, "Lebensdauer", 2, "T", "S", "+"],
    ["Wirtschaftlich", "Kosten", 3, "U", "-", "--"],
    [None, "Montage", 1, "M", "S", "-"],
    ["", "Summe +", None, None, 2, 3],
    ["", "Summe -", None, None, 1, 2],
    ["", "Summe S", None, None, 2, 0],
    ["", "Gesamt", None, None, 1, 1],
]
SCREENING = [
    ["", "Concepts"],
    ["Selection Criteria", "A lever", "B cam", "C screw", "D (reference) wedge"],
    ["Handling", 0, "\u2013", "\u2013", 0],
    ["Wear", "+", 0, "\u2013", 0],
    ["Cost", "+", "+", 0, 0],
    ["Sum +\u2019s", 2, 1, 0, 0],
    ["Sum 0\u2019s", 1, 1, 1, 3],
    ["Sum \u2013\u2019s", 0, 1, 2, 0],
    ["Net Score", 2, 0, -2, 0],
    ["Rank", 1, 2, 4, 2],
    ["Continue?", "Yes", "Combine", "No", "No"],
]
TWO_LINES = [
    ["Bewertung"],
    ["Bewertungskriterium", "g", "Variante 1", None, "Variante 2", None, "Ideal", None],
    ["", None, "p", "g\u00b7p", "p", "g\u00b7p", "p", "g\u00b7p"],
    ["Wirkungsgrad", 0.4, 3, 1.2, 2, 0.8, 4, 1.6],
    ["Baugr\u00f6\u00dfe", 0.6, 2, 1.2, 4, 2.4, 4, 2.4],
    ["Summe", 1, None, 2.4, None, 3.2, None, 4],
    ["Wertigkeit", None, None, 0.6, None, 0.8, None, 1],
]
PER_CENT = [
    ["Nutzwertanalyse"],
    ["Kriterien", "Gewicht", "Variante A", "", "Variante B", ""],
    ["", "", "Punkte", "gewichtet", "Punkte", "gewichtet"],
    ["Kosten", "30 %", 8, "2,4", 5, "1,5"],
    ["Qualit\u00e4t", "70 %", "6", "4,2", 9, "6,3"],
    ["Gesamtnutzen", "100 %", "", "6,6", "", "7,8"],
]
NUMBERED = [
    ["Nr.", "Criterion", "Unit", "Weight", "A", "B", "Remarks"],
    [1, "Cost", "EUR", 2, 3, 4, "B is cheap"],
    [2, "Noise", "dB", 3, 2, 1, None],
    [3, "Mass", "kg", 5, 1, 4, "see 3.2"],
    ["", "Total", None, 10, 17, 31],
    ["", "Average", None, None, 1.7, 3.1],
    [],
    ["Points", "Meaning"],
    [0, "unsatisfactory"],
    [4, "very good"],
]
SHEETS = {
    "groups and the word datum": (GROUPS, {"Direkt": 1, "Zahnrad": 1}, 5, 4),
    "screening": (SCREENING, {"A lever": 2, "B cam": 0, "C screw": -2}, 3, 5),
    "a head of two lines": (TWO_LINES, {"Variante 2": 3.2, "Variante 1": 2.4}, 2, 2),
    "per cent": (PER_CENT, {"Variante B": 7.8, "Variante A": 6.6}, 2, 1),
    "numbers, units, remarks, legend": (NUMBERED, {"B": 31, "A": 17}, 3, 2),
}


@pytest.mark.parametrize(("rows", "totals", "criteria", "agreeing"), SHEETS.values(), ids=SHEETS)
def test_a_sheet_of_this_form_is_read_to_its_written_results(tmp_path, rows, totals, criteria, agreeing):
    result = matrix(write_sheet(tmp_path / "x.xlsx", rows, name="Blatt 3"))
    assert {row.alternative: row.total for row in result.ranking.itertuples()} == pytest.approx(totals)
    (table,) = result.tables.tables
    assert len(table.rows) == criteria
    assert sum("agrees with the cells" in one for one in result.understood) == agreeing
    assert not result.differences


def test_the_ideal_gives_the_scale_and_the_share(tmp_path):
    result = matrix(write_sheet(tmp_path / "x.xlsx", TWO_LINES))
    assert result.ranking["share_of_ideal"].tolist() == pytest.approx([0.8, 0.6])
    assert "points scale: up to 4, by the ideal in G3" in result.understood


def test_what_is_no_part_of_the_matrix_is_listed(tmp_path):
    said = "\n".join(matrix(write_sheet(tmp_path / "x.xlsx", NUMBERED)).understood)
    assert "numbers or marks that are not part of the matrix: A2 '1', A3 '2', A4 '3', A9 '0', A10 '4'" in said
    assert "text that was not read: A1 'Nr.', C1 'Unit', G1 'Remarks'" in said


@pytest.mark.parametrize(
    "rows",
    [
        [["Criterion", "A", "B"], ["Cost", 3, 4], ["Noise", 4, 1], ["Aufaddiert", 7, 5]],
        [["Criterion", "Weight", "A", "B"], ["Cost", 0.6, 3, 4], ["Noise", 0.4, 4, 1], ["Wert", 1, 3.4, 2.8]],
        [["Criterion", "A", "Datum"], ["Cost", "+", "S"], ["Noise", "+", "S"], ["Zwischenstand", 2, 0]],
    ],
)
def test_a_result_of_an_unknown_name_is_no_silent_criterion(tmp_path, rows):
    with pytest.raises(InputError, match=r"cell A4: .* may be a criterion, or the .* of those above, which it equals"):
        matrix(write_sheet(tmp_path / "x.xlsx", rows))
    renamed = matrix(write_sheet(tmp_path / "x.xlsx", [*rows[:3], ["Sum", *rows[3][1:]]]))
    assert len(renamed.tables.tables[0].rows) == 2


def test_the_mass_of_an_alternative_is_no_weight_of_a_criterion(tmp_path):
    rows = [["", "Cost", "Noise", "Weight", "Sum"], ["A", 3, 4, 5, 12], ["B", 1, 2, 3, 6]]
    result = matrix(write_sheet(tmp_path / "x.xlsx", rows))
    assert [row.criterion for row in result.tables.tables[0].rows] == ["Cost", "Noise", "Weight"]
    with pytest.raises(InputError, match="nothing in the sheet decides it"):
        matrix(write_sheet(tmp_path / "x.xlsx", [row[:4] for row in rows]))


SUSPECT = {
    "weights that are no numbers": (
        [["Criterion", "Weight", "A", "B"], ["Cost", "x3", 3, 4], ["Noise", "x2", 4, 1]],
        "cell B2: the weight 'x3' is no number",
    ),
    "shares under another name": (
        [["Criterion", "Rel", "A", "B"], ["Cost", 0.6, 3, 4], ["Noise", 0.4, 2, 1]],
        "cell B1: 'Rel' may be an alternative or the weights",
    ),
    "factors that the sums follow": (
        [["Criterion", "Faktor", "A", "B"], ["Cost", 3, 3, 4], ["Noise", 2, 4, 1], ["Sum", "", 17, 14]],
        "cell B1: 'Faktor' may be an alternative or the weights",
    ),
    "points with words": (
        [["Criterion", "Weight", "A", "B", "C"], ["Cost", 0.6, "3 Punkte", 4, 1], ["Noise", 0.4, "2 Punkte", 1, 3]],
        "cell C2: '3 Punkte' is neither a mark nor points",
    ),
    "words between the alternatives": (
        [["Criterion", "A", "B", "C"], ["Cost", 3, "good", 4], ["Noise", 2, "poor", 1]],
        "cell C2: 'good' is neither a mark nor points",
    ),
    "values next to points": (
        [["Criterion", "Weight", "A", "A points"], ["Cost [EUR]", 0.6, 300, 3], ["Noise [dB]", 0.4, 55, 2]],
        "cell C2: 300 points are outside the scale 0..10",
    ),
    "a result with a weight": (
        [["Criterion", "Weight", "A", "B"], ["Cost", 0.5, 3, 4], ["Noise", 0.3, 2, 1], ["Score", 0.2, 4, 1]],
        "cell A4: 'Score' is the name of a result, but has a weight and other values",
    ),
    "a result of another name": (
        [["Criterion", "Weight", "A", "B"], ["Cost", 0.5, 3, 4], ["Noise", 0.5, 2, 1], ["Endwert", None, 2.5, 2.5]],
        "cell B4: the weight is missing; .* or name the line sum, mean or rank if it is a result",
    ),
    "a scale that runs down": (
        [["scale 4 to 0"], ["Criterion", "A", "B"], ["Cost", 3, 4], ["Noise", 2, 1]],
        "the points scale 4 to 0 must run upwards",
    ),
}


@pytest.mark.parametrize(("rows", "said"), SUSPECT.values(), ids=SUSPECT)
def test_a_column_that_may_be_something_else_is_refused(tmp_path, rows, said):
    with pytest.raises(InputError, match=said):
        matrix(write_sheet(tmp_path / "x.xlsx", rows))


def test_the_remedies_for_hidden_weights_are_right_if_followed(tmp_path):
    rows = SUSPECT["factors that the sums follow"][0]
    named = matrix(write_sheet(tmp_path / "x.xlsx", [["Criterion", "Weight", "A", "B"], *rows[1:]]))
    assert {row.alternative: row.total for row in named.ranking.itertuples()} == {"A": 17, "B": 14}
    assert not named.differences
    weights = ("Weight", 1, 1, None)
    plain = matrix(write_sheet(tmp_path / "x.xlsx", [[*row, one] for row, one in zip(rows, weights, strict=True)]))
    assert {row.alternative: row.total for row in plain.ranking.itertuples()} == {"A": 7, "B": 5, "Faktor": 5}


def test_a_result_of_the_datum_other_than_zero_is_told(tmp_path):
    rows = [["Criterion", "Datum", "A"], ["Cost", "S", "+"], ["Noise", "S", "-"], ["Sum", 3, 0]]
    (said,) = matrix(write_sheet(tmp_path / "x.xlsx", rows)).differences
    assert said == "difference: the datum in B4 has 3; compared with itself it has 0"


@pytest.mark.parametrize("first", [True, False])
def test_a_sheet_of_other_numbers_next_to_a_matrix_is_named_and_left_out(tmp_path, first):
    path = write_sheet(tmp_path / "x.xlsx", GROUPS, name="Pugh")
    book = openpyxl.load_workbook(path)
    data = book.create_sheet("Daten", 0 if first else 1)
    for row in (["Motor", "Power [W]", "Price"], ["A", 120, 300], ["B", 90, 250]):
        data.append(row)
    book.save(path)
    result = matrix(path)
    assert [table.name for table in result.tables.tables] == ["Pugh"]
    assert any(one.startswith("sheet 'Daten': is no matrix and was not read") for one in result.understood)
    data["A1"] = "Criterion"
    book.save(path)
    with pytest.raises(InputError, match="sheet 'Daten', cell B2: 120 points are outside the scale"):
        matrix(path)


def test_the_summary_says_that_the_datum_is_better_than_all(tmp_path):
    rows = [["Criterion", "Now (datum)", "A"], ["Cost", "S", "-"], ["Noise", "S", "S"]]
    said = matrix(write_sheet(tmp_path / "x.xlsx", rows)).summary()
    assert said == "Tabelle1: A ranked first by pugh, but worse than the baseline Now (datum)"


def test_a_share_in_per_cent_is_compared(tmp_path):
    rows = [["Criterion", "Weight", "A", "Ideal"], ["Cost", 0.5, 3, 4], ["Noise", 0.5, 2, 4]]
    for name, value in (("Wertigkeit in %", 62.5), ("Wertigkeit [%]", "62,5 %"), ("T/T_max", 0.625)):
        said = matrix(write_sheet(tmp_path / "x.xlsx", [*rows, [name, None, value, None]])).understood
        assert any("T/T_max" in one and "agrees with the cells" in one for one in said), name


def test_a_full_sheet_of_any_text_is_refused_soon(monkeypatch):
    cells = {(row, column): "ab" if (row + column) % 2 else 1 for row in range(150) for column in range(80)}
    grid = Grid(path=Path("x.xlsx"), sheet="T", cells=cells)
    monkeypatch.setattr(reading, "workbook_grids", lambda _: [grid])
    assert "nothing in the sheet decides it" in _said(grid)


def test_the_command_says_first_how_it_read_the_sheet(tmp_path, capsys):
    path = write_sheet(tmp_path / "x.xlsx", GROUPS)
    assert _code("matrix", str(path)) == 0
    shown = capsys.readouterr().out
    assert shown.startswith("How the sheet was read\n")
    assert "datum: 'Riemen' in D2" in shown
    assert "weighted SUM" in shown
    assert _code("matrix", str(path), "--trace", "Direkt", "Kosten") == 2
    assert "need a decision matrix" in capsys.readouterr().err


def _code(*arguments):
    try:
        main(arguments)
    except SystemExit as stop:
        return stop.code
    return 0


WORDS = (
    "Cost", "Noise", "Sum", "Rank", "Weight", "weight [%]", "datum", "Belt (datum)", "ideal", "Criterion", "Concept A",
    "S", "+", "-", "--", "++", "?", "1,5", "2,5 %", "20 %", "\u2014", "\u2212", "T/T_max", "Average", "scale 4 to 0",
    "g", "unit", "[kg]", "\x1b[31m", "1e400", "x" * 300, "1,000", "=", "%", "[", "(", 0, 1, 2, -1, 3, 4, 0.5, 100, 1e15,
    1e300, True,
)  # fmt: skip


def _scrambled(seed):
    rng = random.Random(seed)
    height, width = rng.randint(1, 9), rng.randint(1, 7)
    cells = {(row, column): rng.choice(WORDS) for row in range(height) for column in range(width)}
    if seed % 3:
        cells |= {
            (0, column): f"{rng.choice(['A', 'Weight', 'datum', 'E', 'ideal'])} {column}" for column in range(width)
        }
        cells |= {(row, 0): f"{rng.choice(['Cost', 'Sum', 'Rank', 'Weight'])} {row % 5}" for row in range(height)}
        pool = rng.choice([("+", "-", "S", 0, "?", "--"), (0, 1, 2, 3, 4, "2,5"), (0.2, 0.5, 1)])
        cells |= {(row, column): rng.choice(pool) for row in range(1, height) for column in range(1, width)}
    return {spot: cell for spot, cell in cells.items() if rng.random() < 0.95}


@pytest.mark.parametrize("block", range(4))
def test_a_scrambled_sheet_is_read_or_one_sentence(monkeypatch, block):
    for seed in range(100 * block, 100 * block + 100):
        grid = Grid(path=Path("x.xlsx"), sheet="T", cells=_scrambled(seed))
        monkeypatch.setattr(reading, "workbook_grids", lambda _, one=grid: [one])
        said = _said(grid)
        assert "\n" not in said, seed
        assert not said or said.startswith("x.xlsx"), seed


def _said(grid):
    """Return the sentence of a refusal, empty where the sheet is read."""
    try:
        published_tables_text(reading.read_written_sheet(grid.path).tables)
    except InputError as error:
        return str(error)
    return ""
