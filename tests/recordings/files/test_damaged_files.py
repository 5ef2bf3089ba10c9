"""Hundreds of damaged copies of a recording of each format, in a process of its own: each one is read or refused."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.recordings.files.damaged_files import FORMATS

SCRIPT = Path(__file__).with_name("damaged_files.py")


def fails(form: str, count: int, seed: int) -> str:
    """Return what failed, with the number of the copy; a crash or a hang ends the process."""
    if form == "mdf":
        pytest.importorskip("asammdf", reason="asammdf is not installed")
    done = subprocess.run(
        [sys.executable, str(SCRIPT), form, str(count), str(seed)], capture_output=True, text=True, check=False
    )
    return "" if done.returncode == 0 else f"exit {done.returncode}\n{done.stdout}\n{done.stderr[-2000:]}"


@pytest.mark.long
@pytest.mark.parametrize("form", FORMATS)
def test_many_damaged_copies(form: str) -> None:
    assert fails(form, 400 if form != "mdf" else 10, 2) == ""


@pytest.mark.full
@pytest.mark.parametrize("form", FORMATS)
def test_thousands_of_damaged_copies(form: str) -> None:
    assert fails(form, 6000 if form != "mdf" else 100, 3) == ""
