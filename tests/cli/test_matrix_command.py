"""``torquerig matrix``: files in and out, traces, edits; bad input is one sentence and exit code 2."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main
from torquerig.reporting.pdf import CHROMIUM

EXAMPLE = shipped_scenarios() / "matrix_example.yaml"
TABLES = str(shipped_scenarios() / "reference_tables.yaml")


def run(*arguments):
    try:
        main(arguments)
    except SystemExit as stop:
        return stop.code
    return 0


def test_what_is_written_is_read_again_with_the_same_result(tmp_path, capsys):
    assert (
        run(
            "matrix",
            str(EXAMPLE),
            *(part for end in ("xlsx", "yaml") for part in ("--out", str(tmp_path / f"m.{end}"))),
        )
        == 0
    )
    told = capsys.readouterr().out
    for ending in ("xlsx", "yaml"):
        assert run("matrix", str(tmp_path / f"m.{ending}")) == 0
        again = capsys.readouterr().out
        assert [line for line in again.splitlines() if "   at " not in line] == [
            line for line in told.splitlines() if "   at " not in line
        ]


def test_one_cell_is_traced_and_an_edit_is_told(tmp_path, capsys):
    assert run("matrix", str(EXAMPLE), "--trace", "servo A", "price") == 0
    told = capsys.readouterr().out
    assert told.startswith("servo A / price\n")
    assert "two quotations" in told
    edited = tmp_path / "edited.yaml"
    edited.write_text(EXAMPLE.read_text(encoding="utf-8").replace("weight: 0.5", "weight: 0.05"), encoding="utf-8")
    assert run("matrix", str(edited), "--before", str(EXAMPLE)) == 0
    assert "criteria.ripple at the sensor.weight: 0.5 -> 0.05" in capsys.readouterr().out


def test_motors_of_the_catalog_fill_a_criterion(tmp_path, capsys):
    path = tmp_path / "m.yaml"
    path.write_text(
        "criteria:\n  rotor inertia: {unit: kg*cm^2, better: less, catalog: rotor_inertia, weight: 1,"
        " points: [[0, 5], [2, 1]]}\nmotors: {new: HDS6A-0104A, old: bldc-12n14p}\n"
        "alternatives: {new: {}, old: {}}\n",
        encoding="utf-8",
    )
    assert run("matrix", str(path), "--trace", "new", "rotor inertia") == 0
    told = " ".join(capsys.readouterr().out.split())
    for word in ("catalog rotor inertia of HDS6A-0104A", "catalog value, unchanged", "value function", "verdict"):
        assert word in told


def edited(tmp_path, old, new):
    text = EXAMPLE.read_text(encoding="utf-8")
    assert old in text
    path = tmp_path / "bad.yaml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    return str(path)


BAD = {
    "negative weight": (("weight: 0.5", "weight: -0.5"), "criteria.ripple at the sensor.weight: the weight -0.5"),
    "scores outside the scale": (("[[0, 5]", "[[0, 7]"), "7 points are outside the scale 1..5"),
    "unknown criterion": (("    price: 400", "    prise: 400"), "motor B.prise: unknown criterion; did you mean"),
    "unknown motor": (("seed: 1 ", "motors: {servo A: HDS6A-0104B} "), "servo A: there is no motor 'HDS6A-0104B'"),
    "duplicate name": (("  servo A:", "  present drive:"), "the key 'present drive' is already in line"),
    "no such baseline": (("baseline: present drive", "baseline: servo B"), "yaml:19: baseline: the baseline 'servo B'"),
    "not monotone": (("[0.02, 4]", "[0.02, 0.5]"), "the value function is not monotone: from 0.02 to 0.1"),
    "override without reason": (("    price: 400", "    price: {value: 4, by_hand: {points: 3}}"), "needs its reason"),
}  # fmt: skip


@pytest.mark.parametrize(("change", "said"), BAD.values(), ids=BAD)
def test_a_bad_matrix_is_one_sentence_and_exit_code_2(change, said, tmp_path, capsys):
    assert run("matrix", edited(tmp_path, *change)) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.startswith("torquerig: ")
    assert shown.err.count("\n") == 1
    assert said in shown.err


def test_all_weights_zero_and_a_sheet_without_a_column_are_exit_code_2(tmp_path, capsys):
    import openpyxl

    text = EXAMPLE.read_text(encoding="utf-8")
    for weight in ("0.5", "0.2", "0.1"):
        text = text.replace(f"weight: {weight}\n", "weight: 0\n")
    (tmp_path / "zero.yaml").write_text(text, encoding="utf-8")
    assert run("matrix", str(tmp_path / "zero.yaml")) == 2
    assert "criteria: all weights are 0; give at least one" in capsys.readouterr().err
    assert run("matrix", str(EXAMPLE), "--out", str(tmp_path / "m.xlsx")) == 0
    capsys.readouterr()
    book = openpyxl.load_workbook(tmp_path / "m.xlsx")
    book["Criteria"].delete_cols(4)
    book.save(tmp_path / "m.xlsx")
    assert run("matrix", str(tmp_path / "m.xlsx")) == 2
    shown = capsys.readouterr()
    assert "m.xlsx: sheet 'Criteria': the column 'weight' is missing" in shown.err
    assert (shown.out, shown.err.count("\n")) == ("", 1)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((str(EXAMPLE), "--out", "m.pdf"), "m.pdf: a matrix is written as .html, .md, .xlsx, .yaml"),
        ((str(EXAMPLE), "--out", "there.md"), "there.md: is there already; choose another name"),
        ((str(EXAMPLE), "--pdf"), "--pdf prints the page of the matrix; name one with --out"),
        ((str(EXAMPLE), "--pdf", "--out", "m.md"), "--pdf prints the page of the matrix; name one with --out"),
        ((str(EXAMPLE), "--pdf", "--out", "there.html"), "there.pdf: is there already"),
        ((str(EXAMPLE), "--out", "no/m.md"), "there is no folder no; make it first"),
        ((str(EXAMPLE), "--trace", "servo B", "price"), "'servo B' is not in the matrix; did you mean 'servo A'"),
        ((str(EXAMPLE), "--trace", "servo A", "prise"), "unknown criterion 'prise'; did you mean 'price'"),
        ((str(EXAMPLE), "--before", "none.yaml"), "none.yaml: there is no such file"),
        (
            (TABLES, "--out", "m.md"),
            "is a file of published tables; --out, --trace and --before need a decision matrix",
        ),
        (("none.xlsx",), "none.xlsx: there is no such file"),
    ],
)
def test_a_bad_call_writes_nothing(arguments, said, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("there.md").write_text("kept", encoding="utf-8")
    Path("there.pdf").write_text("kept", encoding="utf-8")
    assert run("matrix", *arguments) == 2
    shown = capsys.readouterr()
    assert (shown.out, shown.err.count("\n")) == ("", 1)
    assert said in shown.err
    assert Path("there.md").read_text(encoding="utf-8") == "kept"
    assert sorted(one.name for one in tmp_path.iterdir()) == ["there.md", "there.pdf"]


def test_a_matrix_is_worked_out_without_plotting_and_read_without_a_compiler():
    code = (
        "import sys; from pathlib import Path; from torquerig.decide.matrix_io.matrix_file import read_matrix; "
        f"case = read_matrix(Path({str(EXAMPLE)!r})); heavy = {{'numba', 'matplotlib', 'pandas', 'openpyxl'}}; "
        "assert not heavy & set(sys.modules), heavy & set(sys.modules); "
        "from torquerig.decide.matrix_analysis import analyse_matrix; analyse_matrix(case); "
        "assert 'matplotlib' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.skipif(not any(map(shutil.which, CHROMIUM)), reason="no Chromium in PATH")
def test_pdf_prints_the_page_of_the_matrix(tmp_path, capsys):
    page = tmp_path / "decision.html"
    assert run("matrix", str(EXAMPLE), "--out", str(page), "--pdf") == 0
    assert (tmp_path / "decision.pdf").read_bytes().startswith(b"%PDF")
    assert f"wrote {tmp_path / 'decision.pdf'}" in capsys.readouterr().err
    assert page.is_file()
