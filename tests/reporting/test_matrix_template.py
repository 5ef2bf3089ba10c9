"""The workbook to fill in: read back it has the numbers of its formulas, and new rows enter them."""

import warnings

import openpyxl
import pytest

from torquerig.api.decision_matrix import matrix
from torquerig.cli import main
from torquerig.decide.matrix_io.matrix_table import Method
from torquerig.reporting.workbook.template import FIRST, HEADER, ROWS, example_table, write_template

METHODS = ("pugh", "kesselring")
NEW = HEADER + 2 + 4  # the first empty row, from 1


@pytest.fixture(scope="module", params=METHODS)
def template(request, tmp_path_factory):
    path = tmp_path_factory.mktemp("template") / "drives.xlsx"
    write_template(path, request.param)
    return request.param, path


def test_the_template_is_read_to_its_example(template):
    method, path = template
    result = matrix(path)
    (table,), wanted = result.tables.tables, example_table(Method(method))
    assert (table.method.value, table.alternatives, table.baseline) == (method, wanted.alternatives, wanted.baseline)
    assert [(row.criterion, row.entries, row.weight) for row in table.rows] == [
        (row.criterion, row.entries, row.weight) for row in wanted.rows
    ]
    assert sum("agrees with the cells" in one for one in result.understood) == 3
    assert not result.differences
    if method == "kesselring":
        assert (table.profile.p_min, table.profile.p_max) == (0, 4)


def test_lists_and_ranges_reach_over_the_empty_rows(template):
    method, path = template
    sheet = openpyxl.load_workbook(path).active
    checks = {str(one.sqref): one for one in sheet.data_validations.dataValidation}
    last = HEADER + ROWS + 1
    weights = checks[f"B{HEADER + 2}:B{last}"]
    assert (weights.type, weights.formula1, weights.formula2) == ("decimal", "0", "1")
    lists = [one.formula1 for one in checks.values() if one.type == "list"]
    assert sorted(lists) == (['"++,+,S,-,--,?"', '"S"'] if method == "pugh" else ['"0,1,2,3,4,?"'])
    assert all(str(one.sqref).endswith(str(last)) for one in checks.values())


def filled_in(path, target, changes):
    """Write entries as a person does; the stored results get lost."""
    book = openpyxl.load_workbook(path)
    for name, value in changes.items():
        book.active[name] = value
        if isinstance(value, str):
            book.active[name].data_type = "s"
    book.save(target)
    return target


def calculated(path, method):
    """Return the value of a cell as calculated by a program that is none of ours."""
    formulas = pytest.importorskip("formulas", reason="pip install formulas, which calculates workbooks")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = formulas.ExcelModel().loads(str(path)).finish().calculate()
    return lambda cell: found[f"'[{path.name}]{method.upper()}'!{cell}"].value[0, 0]


def with_results(path, target, method):
    """Write the results in the place of their formulas, as a spreadsheet program stores them."""
    cell, book = calculated(path, method), openpyxl.load_workbook(path)
    for row in book.active.iter_rows(max_row=HEADER):
        for one in row:
            if isinstance(one.value, str) and one.value.startswith("="):
                found = cell(one.coordinate)
                one.value = str(found) if isinstance(found, str) else float(found)
    book.save(target)
    return target


ENTRIES = {"pugh": ("S", "+", "--", "++"), "kesselring": (4, 0, 3, 1)}


@pytest.mark.long
@pytest.mark.parametrize("weights", [(0.4, 0.1), (0.1, 0.4)])
def test_a_new_row_enters_the_formulas_and_is_read_to_the_same_numbers(template, tmp_path, weights):
    method, path = template
    changes = {f"B{HEADER + 2}": weights[0], f"A{NEW}": "service life", f"B{NEW}": weights[1]}
    changes |= {f"{'CDEF'[place]}{NEW}": one for place, one in enumerate(ENTRIES[method])}
    filled = filled_in(path, tmp_path / "filled.xlsx", changes)
    result = matrix(with_results(filled, tmp_path / "saved.xlsx", method))
    assert result.tables.tables[0].rows[-1].criterion == "service life"
    assert sum("agrees with the cells" in one for one in result.understood) == 3
    assert not result.differences
    assert result.tables.tables[0].weights == pytest.approx((weights[0], 0.2, 0.3, 0.1, weights[1]))


@pytest.mark.long
def test_an_unknown_cell_leaves_the_result_open_and_never_counts_as_zero(template, tmp_path):
    method, path = template
    cell = calculated(filled_in(path, tmp_path / "filled.xlsx", {f"D{HEADER + 2}": "?"}), method)
    assert {str(cell(f"D{row}")) for row in (5, 6, 7)} == {"open"}
    assert float(cell("E6")) > 0
    assert FIRST == 2


def test_the_command_writes_a_template_once(tmp_path, capsys):
    path = tmp_path / "drives.xlsx"
    for method in METHODS:
        assert main_code("matrix", "--template", method, str(path)) == (0 if method == "pugh" else 2)
    assert "is there already" in capsys.readouterr().err
    assert main_code("matrix", "--template", "kesselring", str(path), "--force") == 0
    assert main_code("matrix", str(path)) == 0
    assert "read as a Kesselring matrix" in capsys.readouterr().out
    assert main_code("matrix", "--template", "pugh", str(tmp_path / "drives.csv")) == 2
    assert "give it the ending .xlsx" in capsys.readouterr().err
    assert main_code("matrix", "--template", "pugh", str(tmp_path / "x.xlsx"), "--out", "y.md") == 2


def main_code(*arguments):
    try:
        main(arguments)
    except SystemExit as stop:
        return stop.code
    return 0
