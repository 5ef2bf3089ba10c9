"""A file is there whole or as it was, and nothing is left beside it."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from torquerig.whole_file import refuse_unwritable, whole_file, whole_files


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


def test_two_files_are_exchanged_together(tmp_path: Path) -> None:
    table, sheet = _old_pair(tmp_path)
    with whole_files([table, sheet]) as (one, other):
        one.write_text("new table")
        assert table.read_text() == "old table"
        other.write_text("new sheet")
    assert (table.read_text(), sheet.read_text()) == ("new table", "new sheet")
    assert sorted(tmp_path.iterdir()) == [table, sheet]


@pytest.mark.parametrize("fails_at", [1, 2])
def test_a_pair_comes_back_where_one_of_two_cannot_be_exchanged(
    fails_at: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    table, sheet = _old_pair(tmp_path)
    plain, calls = Path.replace, []

    def failing(self: Path, target: Path) -> Path:
        if ".partial" in self.name:
            calls.append(self)
            if len(calls) == fails_at:
                raise OSError(errno.ENOSPC, "no space", str(self))
        return plain(self, target)

    monkeypatch.setattr(Path, "replace", failing)
    with pytest.raises(OSError, match="No space left on device") as failed:
        _write_new_pair(table, sheet)
    assert failed.value.filename == str((table, sheet)[fails_at - 1])
    assert (table.read_text(), sheet.read_text()) == ("old table", "old sheet")
    assert sorted(tmp_path.iterdir()) == [table, sheet]


KILLED = """
import os, signal, sys
from pathlib import Path
from torquerig.whole_file import whole_files
plain, calls = Path.replace, []
def dying(self, target):
    calls.append(self)
    if len(calls) == int(sys.argv[1]):
        os.kill(os.getpid(), signal.SIGKILL)
    return plain(self, target)
Path.replace = dying
with whole_files([Path("run.csv"), Path("run.yaml")]) as (one, other):
    one.write_text("new table")
    other.write_text("new sheet")
"""


@pytest.mark.skipif(os.name == "nt", reason="Windows has no kill that leaves no chance")
@pytest.mark.parametrize("at", [1, 2])
def test_what_a_killed_run_left_is_cleared_by_the_next(at: int, tmp_path: Path) -> None:
    table, sheet = _old_pair(tmp_path)
    killed = subprocess.run([sys.executable, "-c", KILLED, str(at)], cwd=tmp_path, check=False)
    assert killed.returncode == -9
    assert len([*tmp_path.iterdir()]) > 2
    with whole_file(tmp_path / "other.html") as partial:
        partial.write_text("page")
        assert (table.read_text(), sheet.read_text()) == ("old table", "old sheet")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["other.html", "run.csv", "run.yaml"]


def test_what_a_running_process_writes_is_left_alone(tmp_path: Path) -> None:
    mine, running = tmp_path / f".run.{os.getpid()}.partial.csv", tmp_path / f".run.{os.getppid()}.partial.csv"
    foreign = [tmp_path / name for name in ("run.1.partial.csv", ".run.partial.csv", ".run.x.partial.csv", ".hidden")]
    for path in (mine, running, *foreign):
        path.write_text("kept")
    with whole_file(tmp_path / "page.html") as partial:
        partial.write_text("page")
    assert all(path.read_text() == "kept" for path in (mine, running, *foreign))


@pytest.mark.parametrize(
    "error",
    [
        OSError(errno.ENOSPC, "No space left on device"),
        OSError("Can't write data (file write failed: errno = 28, error message = 'No space left on device')"),
        RuntimeError(OSError(errno.ENOSPC, "No space left on device")),
    ],
    ids=["plain", "in words", "wrapped"],
)
def test_a_full_disk_names_the_file_that_was_to_be_written(error: Exception, tmp_path: Path) -> None:
    path = tmp_path / "page.html"

    def failing() -> None:
        with whole_file(path) as partial:
            partial.write_text("half")
            raise error

    with pytest.raises(OSError, match="No space left on device") as failed:
        failing()
    assert (failed.value.errno, failed.value.filename) == (errno.ENOSPC, str(path))
    assert [*tmp_path.iterdir()] == []


def test_a_place_that_cannot_be_written_to_is_refused_before(tmp_path: Path) -> None:
    refuse_unwritable(tmp_path / "new" / "folder" / "page.html")
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="directory"):
        refuse_unwritable(tmp_path / "file" / "page.html")
    with pytest.raises(OSError, match="too long"):
        refuse_unwritable(tmp_path / f"{'x' * 300}.html")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def _old_pair(folder: Path) -> tuple[Path, Path]:
    table, sheet = folder / "run.csv", folder / "run.yaml"
    table.write_text("old table")
    sheet.write_text("old sheet")
    return table, sheet


def _write_new_pair(table: Path, sheet: Path) -> None:
    with whole_files([table, sheet]) as (one, other):
        one.write_text("new table")
        other.write_text("new sheet")
