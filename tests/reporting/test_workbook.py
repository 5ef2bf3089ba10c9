import re

import openpyxl
import pytest

from torquerig.reporting.workbook.kesselring_sheet import FIRST, IDEAL, NORMALISED, WEIGHTS
from torquerig.reporting.workbook.study_workbook import write_workbook


@pytest.fixture(scope="module")
def path(runs, decided, answer, tmp_path_factory):
    made = tmp_path_factory.mktemp("book") / "matrices.xlsx"
    write_workbook(made, runs, decided, answer)
    return made


def test_the_sheets_stand_in_order(path):
    names = openpyxl.load_workbook(path).sheetnames
    assert names == ["Ranking", "Shares", "Elimination", "Pugh", "Kesselring", "Assumptions", "Trace", "Catalog"]


def test_the_trace_leads_from_each_catalog_value_to_the_points_of_each_cell(path, decided):
    book = openpyxl.load_workbook(path)
    rows = list(book["Trace"].iter_rows(values_only=True))
    head, told = rows[0], {row[:2]: dict(zip(rows[0], row, strict=True)) for row in rows[1:]}
    assert head[:3] == ("drive | filter", "criterion or requirement", "catalog values")
    assert len(told) == len(rows) - 1
    result = decided.overall
    for row, name in enumerate(result.alternatives):
        for column, criterion in enumerate(result.criteria):
            assert told[name, criterion]["points"].startswith(f"{result.middle[row, column]:.3g}")
    values = list(book["Catalog"].iter_rows(values_only=True))
    inertia = [row for row in values if row[1] == "rotor inertia of HDS6A-0104A"]
    assert [(row[0], row[3], row[5]) for row in inertia] == [("HDS6A-0104A 5:1", "SC", "reading error, disturbance")]


def test_the_stored_values_are_those_of_the_engine(path, decided):
    sheet = openpyxl.load_workbook(path, data_only=True)["Kesselring"]
    result, count = decided.overall, len(decided.overall.criteria)
    best, worst = result.rank_range
    for row, name in enumerate(result.alternatives):
        cells = [cell.value for cell in sheet[FIRST + row + 1]]
        assert cells[0] == name
        total, share, rank, low, high, first, last = cells[count + 1 : count + 8]
        assert (total, share, low, high) == pytest.approx(
            (result.total[row], result.share[row], result.total_low[row], result.total_high[row])
        )
        assert (rank, first, last) == (result.ranks[row], best[row], worst[row])
    assert sheet.cell(IDEAL + 1, count + 2).value == pytest.approx(result.ideal)
    shares = [sheet.cell(NORMALISED + 1, column).value for column in range(2, count + 2)]
    assert sum(shares) == pytest.approx(1)


def test_the_formulas_give_the_stored_values(path, decided):
    """Each formula is calculated here from the cells that it names, and must agree with the value beside it."""
    live, stored = (openpyxl.load_workbook(path, data_only=only)["Kesselring"] for only in (False, True))
    count, last = len(decided.overall.criteria), FIRST + len(decided.overall.alternatives)
    checked = 0
    for row in range(FIRST + 1, last + 1):
        for column in range(count + 2, count + 9):
            formula = live.cell(row, column).value
            assert formula.startswith("=")
            assert _calculated(formula, stored) == pytest.approx(stored.cell(row, column).value)
            checked += 1
    assert checked == 7 * len(decided.overall.alternatives)


def test_the_weights_are_numbers_that_totals_refer_to(path, decided):
    sheet = openpyxl.load_workbook(path)["Kesselring"]
    count = len(decided.overall.criteria)
    weights = [sheet.cell(WEIGHTS + 1, column).value for column in range(2, count + 2)]
    assert weights == pytest.approx(decided.overall.weights.tolist())
    assert f"$B${WEIGHTS + 1}:" in sheet.cell(FIRST + 1, count + 2).value


def test_pugh_counts_are_formulas_with_values(path, decided):
    live, stored = (openpyxl.load_workbook(path, data_only=only)["Pugh"] for only in (False, True))
    width = len(decided.pugh.criteria)
    for row, name in enumerate(decided.pugh.alternatives, start=2):
        signs = [stored.cell(row, column).value for column in range(2, width + 2)]
        assert signs == [str(sign) for sign in decided.pugh.signs(name)]
        for step, sign in enumerate(decided.pugh.counts(name)):
            assert f'="{sign}"' in live.cell(row, width + 2 + step).value
            assert stored.cell(row, width + 2 + step).value == signs.count(str(sign))


def test_unknowns_stay_unknown(path, decided):
    sheet = openpyxl.load_workbook(path, data_only=True)["Shares"]
    assert [cell.value for cell in sheet[4]][4:13] == ["?"] * 9


def _calculated(formula, sheet):
    """Calculate the few forms that the sheet uses, apart from the code that wrote them."""
    text = formula[1:].replace("$", "")
    match = re.fullmatch(r"SUMPRODUCT\((\w+:\w+),(\w+:\w+)\)", text)
    if match:
        return sum(a * b for a, b in zip(*(_values(part, sheet) for part in match.groups()), strict=True))
    match = re.fullmatch(r"([A-Z]+\d+)/([A-Z]+\d+)", text)
    if match:
        return sheet[match[1]].value / sheet[match[2]].value
    match = re.fullmatch(r"1\+SUMPRODUCT\(\((\w+:\w+)>(\w+)\+1e-09\)\*1\)(?:-\((\w+)>(\w+)\+1e-09\))?", text)
    above = sum(value > sheet[match[2]].value + 1e-9 for value in _values(match[1], sheet))
    itself = sheet[match[3]].value > sheet[match[4]].value + 1e-9 if match[3] else False
    return 1 + above - itself


def _values(area, sheet):
    return [cell.value for row in sheet[area] for cell in row]
