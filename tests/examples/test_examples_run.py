"""Every example runs as its docstring says and draws its picture."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).resolve().parents[2] / "examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=[example.stem for example in EXAMPLES])
def test_example_draws_its_picture(example: Path, tmp_path: Path) -> None:
    picture = tmp_path / "picture.svg"
    run = subprocess.run([sys.executable, str(example), str(picture)], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert picture.read_text(encoding="utf-8").count("<path") > 20
