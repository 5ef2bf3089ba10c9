"""The rig program stands apart: a proof with the simulator's own equations would prove nothing."""

import ast
from pathlib import Path

import pytest

PROOF = Path(__file__).resolve().parents[2] / "proof"
GENERATOR = sorted([
    *(path for folder in ("rig_program", "fleet", "strangers") for path in (PROOF / folder).rglob("*.py")),
    PROOF / "trials.py", PROOF / "riddle.py",
])  # fmt: skip


def imported(path: Path) -> set[str]:
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module or "")
            assert node.level == 0, f"{path.name} imports relatively"
    return names


@pytest.mark.parametrize("path", GENERATOR, ids=lambda path: str(path.relative_to(PROOF)))
def test_no_file_of_the_generator_imports_torquerig_or_the_scores(path):
    assert not {name for name in imported(path) if name.split(".")[0] in {"torquerig", "importlib"}}
    assert not {name for name in imported(path) if name.startswith("proof.scoring")}


def test_numba_is_imported_in_the_kernel_alone():
    assert {path.name for path in GENERATOR if "numba" in imported(path)} == {"kernel.py"}


def test_the_list_of_generator_files_is_not_empty():
    assert len(GENERATOR) > 80
