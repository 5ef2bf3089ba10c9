"""Every example of the gallery runs and draws a picture with something in it; .ci/docs runs them all as well."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).resolve().parents[2] / "examples").glob("*.py"))
DRAWN = """
import runpy, sys
from matplotlib.figure import Figure
made = runpy.run_path(sys.argv[1])
figures = [one for one in made.values() if isinstance(one, Figure)]
assert figures, "no figure"
figures[-1].savefig(sys.argv[2])
"""


@pytest.mark.full
@pytest.mark.parametrize("example", EXAMPLES, ids=[example.stem for example in EXAMPLES])
def test_example_draws_its_picture(example: Path, tmp_path: Path) -> None:
    picture = tmp_path / "picture.svg"
    command = [sys.executable, "-c", DRAWN, str(example), str(picture)]
    headless = {**os.environ, "MPLBACKEND": "Agg"}
    run = subprocess.run(command, capture_output=True, text=True, check=False, env=headless, cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    assert picture.read_text(encoding="utf-8").count("<path") > 20


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 3
