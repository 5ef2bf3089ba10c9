"""The Excel form of a matrix: read back it is the same case, and its formulas follow what a buyer changes."""

# ruff: noqa: E501 (a table: one case in a row)

import warnings
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest

from torquerig.decide.cell import Cell, Origin, Override
from torquerig.decide.kesselring import kesselring
from torquerig.decide.matrix_analysis import analyse_matrix
from torquerig.decide.matrix_io.excel_layout import CRITERIA, FACTS, SETTINGS, SOURCES
from torquerig.decide.matrix_io.excel_matrix import read_excel_matrix
from torquerig.decide.matrix_io.matrix_file import matrix_from, read_matrix
from torquerig.errors import InputError
from torquerig.reporting.workbook.kesselring_sheet import FIRST, IDEAL
from torquerig.reporting.workbook.matrix_workbook import write_matrix_workbook

EXAMPLE = read_matrix(Path(__file__).resolve().parents[2] / "scenarios" / "matrix_example.yaml")
HAND = {
    ("servo A", "price"): Cell(low=700.0, high=900.0, by_hand=Override(value=650.0, reason="offer by phone")),
    ("present drive", "speed reserve"): Cell(value=1.4, by_hand=Override(points=2.0, reason="it stalls when cold")),
    ("servo A", "rotor inertia"): Cell(
        value=0.28, source="p. 4", evidence="DOC", fact="rotor inertia of A", metric="as it stands",
        origins=(Origin(name="J", shown="0.28 kg*cm^2", evidence="DOC", source="p. 4"), Origin(name="K")),
    ),
    ("servo A", "speed reserve"): Cell(value=1.6, low=1.2, high=1.9),
    ("induction motor B", "servo drive"): Cell(),
}  # fmt: skip
CASE = replace(EXAMPLE, draws=200, matrix=replace(EXAMPLE.matrix, cells={**EXAMPLE.matrix.cells, **HAND}))


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    made = tmp_path_factory.mktemp("matrix") / "drives.xlsx"
    write_matrix_workbook(made, analyse_matrix(CASE))
    return made


def test_the_workbook_read_back_is_the_same_case(path):
    again = matrix_from(read_excel_matrix(path))
    assert again.matrix.criteria == CASE.matrix.criteria
    for name in CASE.matrix.alternatives:
        for one in CASE.matrix.criteria:
            assert again.matrix.cell(name, one.name) == CASE.matrix.cell(name, one.name), (name, one.name)
    for key in ("baseline", "profile", "goal", "goal_words", "draws", "seed", "uncertainty", "cost"):
        assert getattr(again, key) == getattr(CASE, key)


def test_the_stored_values_are_those_of_the_engine(path):
    sheet = openpyxl.load_workbook(path, data_only=True)["Kesselring"]
    result, count = analyse_matrix(CASE).overall, len(analyse_matrix(CASE).overall.criteria)
    for row in range(len(result.alternatives)):
        cells = [cell.value for cell in sheet[FIRST + row + 1]]
        assert cells[1 : count + 1] == pytest.approx(result.middle[row].tolist())
        assert cells[count + 1] == pytest.approx(result.total[row])
    assert sheet.cell(IDEAL + 1, count + 2).value == pytest.approx(result.ideal)


def calculated(path, changes):
    """Calculate the sheet with a program that is none of ours, after changing entries; values by cell."""
    formulas = pytest.importorskip("formulas", reason="pip install formulas, which calculates workbooks")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = formulas.ExcelModel().loads(str(path)).finish()
        book = f"'[{path.name}]"
        found = model.calculate(
            inputs={f"{book}{sheet.upper()}'!{cell}": one for (sheet, cell), one in changes.items()}
        )
    return lambda cell: float(found[f"{book}KESSELRING'!{cell}"].value[0, 0])


@pytest.mark.long
@pytest.mark.parametrize(
    ("changes", "edit"),
    [
        ({}, {}),
        ({(CRITERIA, "D4"): 0.1}, {"weight": 0.1}),  # ripple
        ({(CRITERIA, "Q4"): 3.0}, {"knot": 3.0}),  # points of the second knot of ripple
        ({(FACTS, "H3"): 0.05}, {"ripple of servo A": 0.05}),
    ],
)
def test_a_changed_entry_gives_what_the_engine_gives(path, changes, edit):
    heads = [cell.value for cell in openpyxl.load_workbook(path)[CRITERIA][1]]
    assert (heads[3], heads[16]) == ("weight", "points 2")
    facts = openpyxl.load_workbook(path)[FACTS]
    assert (facts["H1"].value, facts["A3"].value) == ("ripple at the sensor high", "servo A")
    cell = calculated(path, changes)
    criteria, cells = list(CASE.matrix.criteria), dict(CASE.matrix.cells)
    place = next(row for row, one in enumerate(criteria) if one.name == "ripple at the sensor")
    ripple = criteria[place]
    if "weight" in edit:
        criteria[place] = replace(ripple, weight=edit["weight"])
    if "knot" in edit:
        knots = (ripple.value.knots[0], (ripple.value.knots[1][0], edit["knot"]), *ripple.value.knots[2:])
        criteria[place] = replace(ripple, value=replace(ripple.value, knots=knots))
    if "ripple of servo A" in edit:
        cells["servo A", ripple.name] = Cell(low=0.01, high=edit["ripple of servo A"])
    changed = replace(CASE.matrix, criteria=tuple(criteria), cells=cells)
    result = kesselring(changed.only(alternatives=analyse_matrix(CASE).overall.alternatives))
    best, worst = result.rank_range
    for row in range(len(result.alternatives)):
        line = FIRST + row + 1
        shown = [cell(f"{letter}{line}") for letter in "BCDEFGHIJKL"]
        assert shown[:4] == pytest.approx(result.middle[row].tolist())
        assert shown[4:] == pytest.approx(
            [result.total[row], result.share[row], result.ranks[row], result.total_low[row], result.total_high[row],
             best[row], worst[row]]
        )  # fmt: skip


def broken(path, tmp_path, change):
    book = openpyxl.load_workbook(path)
    change(book)
    target = tmp_path / "broken.xlsx"
    book.save(target)
    return target


def set_cell(sheet, cell, value):
    return lambda book: book[sheet].__setitem__(cell, value)


CASES = {
    "missing column of a criterion": (lambda book: book[FACTS].delete_cols(2), "sheet 'Facts': the column 'servo drive' is missing; add it to the first row"),
    "missing column": (lambda book: book[CRITERIA].delete_cols(4), "sheet 'Criteria': the column 'weight' is missing"),
    "misspelt column": (set_cell(CRITERIA, "D1", "wieght"), "the column 'weight' is missing; did you mean 'wieght'"),
    "missing sheet": (lambda book: book.remove(book[FACTS]), "the sheet 'Facts' is missing"),
    "unknown column": (set_cell(CRITERIA, "M1", "purpos"), "sheet 'Criteria', cell M1: unknown column 'purpos'; did you mean 'purpose'"),
    "double column": (set_cell(CRITERIA, "C1", "unit"), "cell C1: the column 'unit' occurs twice"),
    "negative weight": (set_cell(CRITERIA, "D4", -0.5), "sheet 'Criteria', cell D4: the weight -0.5 must be at least 0"),
    "all weights zero": (lambda book: [book[CRITERIA].cell(row, 4, 0) for row in range(2, 8)], "all weights are 0"),
    "points outside": (set_cell(CRITERIA, "O4", 7), "cell N4: 7 points are outside the scale 1..5"),
    "not monotone": (set_cell(CRITERIA, "O4", 2), "cell N4: the value function is not monotone"),
    "double criterion": (set_cell(CRITERIA, "A5", "servo drive"), "sheet 'Criteria', cell A5: the criterion 'servo drive' occurs twice"),
    "double alternative": (set_cell(FACTS, "A3", "present drive"), "sheet 'Facts', cell A3: the alternative 'present drive' occurs twice"),
    "nameless": (set_cell(FACTS, "A3", None), "sheet 'Facts', cell A3: the alternative has no name"),
    "baseline not there": (set_cell(SETTINGS, "B3", "servo B"), "sheet 'Settings', cell B3: the baseline 'servo B' is not in the matrix; did you mean 'servo A'"),
    "unknown setting": (set_cell(SETTINGS, "A3", "baselnie"), "sheet 'Settings', cell A3: unknown setting; did you mean 'baseline'"),
    "unknown source": (set_cell(SOURCES, "A2", "servo B"), "sheet 'Sources', cell A2: unknown alternative 'servo B'; did you mean 'servo A'"),
    "no reason": (lambda book: [book[SOURCES].cell(row, 12, None) for row in range(2, 12)] and book[SOURCES].delete_cols(12), "a cell set by hand needs its reason"),
    "text for a number": (set_cell(FACTS, "F3", "little"), "sheet 'Facts', cell F3: .*or write a bare number"),
    "interval upside down": (set_cell(FACTS, "G3", 9.0), "sheet 'Facts', cell F3: the interval 9..0.03 must run upwards"),
    "formula without value": (set_cell(CRITERIA, "D4", "=1-D5"), "cell D4: the formula =1-D5 has no stored value; open and save"),
}  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize(("change", "said"), CASES.values(), ids=CASES)
def test_a_broken_sheet_is_one_sentence_with_its_cell(path, tmp_path, change, said):
    target = broken(path, tmp_path, change)
    with pytest.raises(InputError, match=said) as raised:
        matrix_from(read_excel_matrix(target))
    assert str(raised.value).startswith(f"{target}: ")
    assert "\n" not in str(raised.value)


def test_names_of_earlier_versions_are_read_with_a_notice(path, tmp_path, capsys):
    def change(book):
        for sheet, old in ((CRITERIA, {"requirement min": "demand min"}), (SETTINGS, {"baseline": "datum"})):
            for row in book[sheet].iter_rows():
                for cell in row:
                    cell.value = old.get(cell.value, cell.value)

    assert matrix_from(read_excel_matrix(broken(path, tmp_path, change))) == matrix_from(read_excel_matrix(path))
    notices = capsys.readouterr().err
    assert "'demand min' is now 'requirement min'" in notices
    assert "'datum' is now 'baseline'" in notices


def test_text_forms_of_a_cell_are_read(path, tmp_path):
    target = broken(
        path, tmp_path, lambda book: (set_cell(FACTS, "B4", "no")(book), set_cell(FACTS, "F4", "2..5")(book))
    )
    case = matrix_from(read_excel_matrix(target))
    assert case.matrix.cell("induction motor B", "servo drive").bounds == (0, 0)
    assert case.matrix.cell("induction motor B", "ripple at the sensor").bounds == (2, 5)


def test_what_is_no_workbook_is_one_sentence(tmp_path):
    with pytest.raises(InputError, match="there is no such file"):
        read_excel_matrix(tmp_path / "none.xlsx")
    (tmp_path / "text.xlsx").write_text("no workbook", encoding="utf-8")
    with pytest.raises(InputError, match="is no Excel workbook"):
        read_excel_matrix(tmp_path / "text.xlsx")
