"""The size of the diagnosis in lines and hand-set numbers: today's figures, which may only fall."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "src" / "torquerig" / "inference"
MOST_LINES, MOST_NUMBERS = 17105, 660  # issue 60 asks for 9000 and 150


def lines(folder: Path) -> int:
    return sum(len(path.read_text(encoding="utf-8").splitlines()) for path in folder.rglob("*.py"))


def numbers(folder: Path) -> int:
    """Return how many numbers are written in constants of modules and classes, and in defaults of arguments."""
    return sum(
        sum(1 for _ in _numbers_in(ast.parse(path.read_text(encoding="utf-8")))) for path in folder.rglob("*.py")
    )


def _numbers_in(tree: ast.Module) -> Iterator[ast.Constant]:
    """Yield the numbers of assignments outside functions, and of defaults; 0 and 1 are no choice."""
    stated: list[ast.AST] = []
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef)):
            assigned = [each for each in node.body if isinstance(each, (ast.Assign, ast.AnnAssign))]
            stated += [each.value for each in assigned if each.value is not None]
        elif isinstance(node, ast.arguments):
            stated += [each for each in (*node.defaults, *node.kw_defaults) if each is not None]
    for value in stated:
        for one in ast.walk(value):
            if isinstance(one, ast.Constant) and type(one.value) in (int, float) and one.value not in (0, 1):
                yield one


def test_the_diagnosis_does_not_grow():
    assert lines(FOLDER) <= MOST_LINES
    assert numbers(FOLDER) <= MOST_NUMBERS


def test_numbers_of_constants_and_defaults_count(tmp_path):
    text = "A, B = 3.5, 1\nclass C:\n    x: float = 2.0\ndef f(n=7, *, k=0):\n    return 99 * n\n"
    (tmp_path / "one.py").write_text(text)
    assert numbers(tmp_path) == 3
    assert lines(tmp_path) == 5
