"""The compiled loop is made anew when any of its files changes."""

from __future__ import annotations

import inspect
import shutil
from pathlib import Path
from typing import Any

import pytest

from torquerig.simulation.kernel import loop, side_by_side, sources


def test_a_change_of_any_file_changes_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(Path(sources.__file__).parent, tmp_path / "kernel")
    monkeypatch.setattr(sources, "__file__", str(tmp_path / "kernel" / "sources.py"))
    before = sources.sources_key()
    for file in sorted((tmp_path / "kernel").glob("*.py")):
        file.write_text(file.read_text(encoding="utf-8") + "# changed\n", encoding="utf-8")
        assert sources.sources_key() != before, file.name
        before = sources.sources_key()


@pytest.mark.parametrize("compiled", [loop.advance, side_by_side.advance_together])
def test_both_loops_close_over_the_key(compiled: Any) -> None:
    """Numba's documented rule: what a function closes over is part of the key of its cache on disk."""
    assert inspect.getclosurevars(compiled.py_func).nonlocals["key"] == sources.sources_key()
