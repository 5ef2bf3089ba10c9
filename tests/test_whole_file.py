"""A file is there whole or as it was, and nothing is left beside it."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest

from torquerig.whole_file import whole_file


def test_what_is_complete_takes_the_place_of_what_stood_there(tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text("old", encoding="utf-8")
    with whole_file(path) as partial:
        partial.write_text("new", encoding="utf-8")
        assert path.read_text(encoding="utf-8") == "old"
        assert partial.suffix == ".html"
    assert path.read_text(encoding="utf-8") == "new"
    assert [*tmp_path.iterdir()] == [path]


def test_what_fails_leaves_what_stood_there_and_nothing_beside_it(tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(FileNotFoundError), whole_file(path) as partial:
        partial.write_text((tmp_path / "nothing").read_text(encoding="utf-8"), encoding="utf-8")
    with pytest.raises(UnicodeEncodeError), whole_file(path) as partial:
        partial.write_text("half a page \ud800", encoding="utf-8")
    assert path.read_text(encoding="utf-8") == "old"
    assert [*tmp_path.iterdir()] == [path]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_a_pipe_stays_a_pipe(tmp_path: Path) -> None:
    pipe, heard = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: heard.append(pipe.read_text(encoding="utf-8")))
    reader.start()
    with whole_file(pipe) as partial:
        partial.write_text("told", encoding="utf-8")
    reader.join(timeout=10)
    assert heard == ["told"]
    assert pipe.is_fifo()
