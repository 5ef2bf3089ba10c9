"""The notebooks run from top to bottom, as a user runs them; .ci/docs runs them all as well."""

import ast
import json
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[2] / "examples" / "notebooks").glob("*.ipynb"))


def cells(notebook):
    """Return the code cells of a notebook, each as text."""
    data = json.loads(notebook.read_text())
    return ["".join(cell["source"]) for cell in data["cells"] if cell["cell_type"] == "code"]


def run(notebook):
    """Run all cells in one name space; show the value of a cell's last line as a notebook does."""
    names = {"__name__": "__main__"}
    for number, text in enumerate(cells(notebook)):
        parsed = ast.parse(text, filename=f"{notebook.name}, cell {number}")
        last = parsed.body.pop() if parsed.body and isinstance(parsed.body[-1], ast.Expr) else None
        exec(compile(parsed, f"{notebook.name}, cell {number}", "exec"), names)
        if last is not None:
            shown = eval(compile(ast.Expression(last.value), f"{notebook.name}, cell {number}", "eval"), names)
            forms = [getattr(shown, form)() for form in ("_repr_html_", "_repr_png_") if hasattr(shown, form)]
            assert not forms or any(forms)
    return names


def test_there_are_three():
    assert [one.stem for one in NOTEBOOKS] == ["diagnose_a_recording", "select_a_drive", "validate_a_filter"]


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda one: one.stem)
def test_a_notebook_is_committed_without_outputs(notebook):
    data = json.loads(notebook.read_text())
    assert all(not cell.get("outputs") for cell in data["cells"])


@pytest.mark.full
def test_the_filter_notebook_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = run(NOTEBOOKS[2])
    assert names["best"] != "none"


@pytest.mark.full
def test_the_drive_notebook_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = run(NOTEBOOKS[1])
    assert names["result"].ranking["rank"].notna().any()


@pytest.mark.full
def test_the_diagnosis_notebook_names_the_concealed_effect(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = run(NOTEBOOKS[0])
    assert [finding.mechanism for finding in names["answer"].findings] == ["gear_mesh"]
    assert names["answer"].fit.after < names["answer"].fit.before
