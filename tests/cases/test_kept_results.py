"""Kept results: read whole or not at all, within a limit, and no obstacle whatever happens to their folder."""

from __future__ import annotations

import errno
import os
import pickle
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path, PurePosixPath

import numpy as np
import pytest

from torquerig.cases import identity
from torquerig.cases.content import content_digest
from torquerig.cases.kept_folder import kept_folder, kept_limit, size_text
from torquerig.cases.kept_results import KeptResults, opened_results
from torquerig.cases.kept_values import bytes_of, value_of
from torquerig.errors import InputError
from torquerig.metrics.figure import Figure
from torquerig.parameter import Estimate


def key(number: int) -> str:
    return content_digest(number)


def test_what_was_kept_is_read_by_another_object_and_nothing_else_is(tmp_path: Path) -> None:
    KeptResults(tmp_path / "made").put(key(1), b"one")
    kept = KeptResults(tmp_path / "made")
    assert kept.get(key(1)) == b"one"
    assert kept.get(key(2)) is None
    assert (kept.found, kept.notes) == (1, [])
    assert (tmp_path / "made" / "CACHEDIR.TAG").read_bytes().startswith(b"Signature: 8a477f597d28d172789f06886806bc55")


@pytest.mark.parametrize("damage", [lambda held: held[:-1], lambda held: held[:10], lambda held: held + b"x",
                                    lambda held: held.replace(b"one", b"two"), lambda held: b""])  # fmt: skip
def test_a_damaged_result_is_removed_with_a_note(tmp_path: Path, damage) -> None:
    kept = KeptResults(tmp_path)
    kept.put(key(1), b"one")
    (entry,) = kept.entries()
    entry.path.write_bytes(damage(entry.path.read_bytes()))
    assert kept.get(key(1)) is None
    assert not entry.path.exists()
    assert kept.notes == [f"{entry.path}: this kept result was damaged; it was removed and is computed again"]


def test_a_result_under_the_name_of_another_is_damaged(tmp_path: Path) -> None:
    kept = KeptResults(tmp_path)
    kept.put(key(1), b"one")
    kept.put(key(2), b"two")
    first, second = kept._path(key(1)), kept._path(key(2))
    second.write_bytes(first.read_bytes())
    assert kept.get(key(2)) is None


def test_the_limit_removes_what_was_used_longest_ago(tmp_path: Path) -> None:
    with opened_results(tmp_path, limit=3500) as kept:
        for number in range(3):
            kept.put(key(number), bytes(1000))
            os.utime(kept._path(key(number)), (number, number))
        assert kept.get(key(0)) is not None  # used now
        kept.put(key(3), bytes(1000))
    assert [KeptResults(tmp_path).get(key(number)) is not None for number in range(4)] == [True, False, True, True]


def test_a_result_larger_than_the_limit_is_not_kept_and_removes_nothing(tmp_path: Path) -> None:
    kept = KeptResults(tmp_path, limit=2000)
    kept.put(key(1), bytes(1000))
    kept.put(key(2), bytes(3000))
    kept.trim()
    assert (kept.get(key(1)) is not None, kept.get(key(2))) == (True, None)


@pytest.mark.parametrize(
    ("number", "said"), [(errno.ENOSPC, "No space left on device"), (errno.EROFS, "Read-only file system")]
)
def test_a_disk_that_takes_nothing_is_one_note_and_the_rest_is_still_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, said: str
) -> None:
    kept = KeptResults(tmp_path)
    kept.put(key(1), b"one")

    def full(path: Path, content: bytes) -> int:
        path.touch()
        raise OSError(number, os.strerror(number), str(path))

    monkeypatch.setattr(Path, "write_bytes", full)
    for more in (2, 3):
        kept.put(key(more), b"more")
    assert kept.get(key(1)) == b"one"
    (note,) = kept.notes
    assert note.startswith(f"{tmp_path}: results are not kept ({said}); make room there, or name another folder")
    assert [path.name for path in tmp_path.rglob("*partial*")] == []


def test_a_file_in_the_place_of_the_folder_is_a_note(tmp_path: Path) -> None:
    place = tmp_path / "file"
    place.write_text("mine")
    with opened_results(place) as kept:
        assert kept.key("kind", 1) == KeptResults(tmp_path / "other").key("kind", 1)
        kept.put(key(1), b"one")
        assert kept.get(key(1)) is None
    assert len(kept.notes) == 1
    assert place.read_text() == "mine"


def test_clear_removes_results_alone_and_by_age(tmp_path: Path) -> None:
    kept = KeptResults(tmp_path)
    for number in range(3):
        kept.put(key(number), bytes(10))
    old = time.time() - 1000
    os.utime(kept._path(key(0)), (old, old))
    (tmp_path / "results" / "notes.txt").write_text("mine")
    (tmp_path / "thesis.txt").write_text("mine")
    assert kept.clear(unused_for=500)[0] == 1
    assert kept.clear()[0] == 2
    assert list(kept.entries()) == []
    assert {path.name for path in tmp_path.rglob("*.txt")} == {"notes.txt", "thesis.txt"}


def fill(folder: Path) -> list[str]:
    with opened_results(folder, limit=20_000) as kept:
        for turn in range(3):
            for number in range(40):
                content = kept.get(key(number))
                assert content in (None, bytes([number]) * 1000), (turn, number)
                kept.put(key(number), bytes([number]) * 1000)
        return kept.notes


def test_processes_share_a_folder_while_it_is_over_its_limit(tmp_path: Path) -> None:
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        assert list(pool.map(fill, [tmp_path] * 2)) == [[], []]
    assert sum(one.size for one in KeptResults(tmp_path).entries()) <= 20_000


def test_what_a_killed_process_left_is_removed(tmp_path: Path) -> None:
    kept = KeptResults(tmp_path)
    kept.put(key(1), b"one")
    left = kept._path(key(1)).with_name(f".{key(1)[2:]}.99999999.partial")
    left.write_bytes(b"hal")
    with opened_results(tmp_path) as again:
        again.put(key(1), b"one")
    assert not left.exists()


def test_a_key_depends_on_kind_content_and_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = KeptResults(tmp_path)
    keys = [kept.key("drive", 1), kept.key("drive", 1.0), kept.key("drive", True), kept.key("picture", 1)]
    here = dict(identity.code_here(tmp_path / "sources.json"))
    for name in ("numpy", "scipy", "numba", "python", identity.SOURCES):
        monkeypatch.setattr("torquerig.cases.kept_results.code_here", lambda _, name=name: here | {name: "other"})
        keys.append(kept.key("drive", 1))
    assert len(set(keys)) == len(keys)


def test_the_digest_of_the_sources_is_remembered_by_the_state_of_their_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    memory, whole = tmp_path / "new" / "sources.json", identity.sources_digest()
    assert identity.remembered_digest(memory) == whole
    with monkeypatch.context() as patched:
        patched.setattr(identity, "sources_digest", lambda: "read again")
        assert identity.remembered_digest(memory) == whole
        states = [("a.py", 1, 2, 3)]
        patched.setattr(identity, "_states", lambda folder: states)
        assert identity.remembered_digest(memory) == "read again"
    memory.write_text("[no JSON")
    assert identity.remembered_digest(memory) == whole


def test_equal_values_have_one_digest_and_different_ones_have_another() -> None:
    values = [1, 1.0, True, "1", b"1", None, [1], [[1]], {"a": 1}, {"a": 1, "b": 2}, {"b": 2, "a": 1}, (),
              np.array([1.0]), np.array([[1.0]]), np.array([1]), PurePosixPath("1"), Figure(value=1.0),
              Figure(value=1.0, rests_on=(("a", Estimate(1.0)),)), Estimate(1.0), float("nan"), -0.0, 0.0]  # fmt: skip
    digests = [content_digest(value) for value in values]
    assert len(set(digests)) == len(values)
    assert digests == [content_digest(pickle.loads(pickle.dumps(value))) for value in values]
    assert content_digest("ab", "c") != content_digest("a", "bc")
    with pytest.raises(TypeError, match="function"):
        content_digest(key)


class Harm:
    """What a foreign file would have run."""

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return os.mkdir, ("harm",)


def test_a_value_is_read_back_and_a_foreign_class_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    figure = Figure(value=1.0, unit="N*m")
    classes = {"torquerig.metrics.figure:Figure"}
    assert value_of(bytes_of({"a": [figure, None]}), classes) == {"a": [figure, None]}
    monkeypatch.chdir(tmp_path)
    for foreign in (bytes_of(Harm()), bytes_of(Estimate(1.0))):
        with pytest.raises(pickle.UnpicklingError, match="is no part of a kept result"):
            value_of(foreign, classes)
    assert list(tmp_path.iterdir()) == []


def test_the_folder_is_stated_or_of_the_environment_or_of_the_platform(monkeypatch: pytest.MonkeyPatch) -> None:
    assert kept_folder(Path("here"), {"TORQUERIG_CACHE": "there"}) == Path("here")
    assert kept_folder(None, {"TORQUERIG_CACHE": "there"}) == Path("there")
    assert kept_folder(None, {"TORQUERIG_CACHE": "none"}) is None
    monkeypatch.setenv("XDG_CACHE_HOME", "/some/cache")
    if os.name == "posix" and os.uname().sysname == "Linux":
        assert kept_folder(None, {}) == Path("/some/cache/torquerig")


def test_a_file_is_no_folder_of_results(tmp_path):
    file = tmp_path / "notes.txt"
    file.write_text("mine")
    for stated, environment in ((file, {}), (None, {"TORQUERIG_CACHE": str(file)})):
        with pytest.raises(InputError, match="is a file; name a folder"):
            kept_folder(stated, environment)
    assert file.read_text() == "mine"


def test_the_limit_is_a_size_with_its_unit() -> None:
    assert kept_limit({"TORQUERIG_CACHE_LIMIT": "1.5 MB"}) == 1_500_000
    assert kept_limit({}) == 2 * 2**30
    with pytest.raises(InputError, match="TORQUERIG_CACHE_LIMIT=much: this is no size; write a number with its unit"):
        kept_limit({"TORQUERIG_CACHE_LIMIT": "much"})
    assert [size_text(size) for size in (0, 2**20, 3 * 2**30)] == ["0.0 KiB", "1.0 MiB", "3.00 GiB"]
