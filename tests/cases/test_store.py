"""Rows are stored once and whole, and nothing else is taken for them."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from tests.cases import work_functions as work
from torquerig.cases import Case, Column, Identity, read_rows
from torquerig.cases.parts import finished_parts
from torquerig.cases.store import Store, opened_store
from torquerig.errors import InputError


def rows_of(numbers: range, state: str = "done") -> list[dict[str, Any]]:
    """Return stored rows of the cases of these numbers."""
    listed = [work.cases(n + 1)[n] for n in numbers]
    start = [{"case": one.number, "seed": one.seed, "state": state, "error": None, **one.values} for one in listed]
    return [row | work.row_of(2.0, one) for row, one in zip(start, listed, strict=True)]


def stored(folder: Path, *parts: range) -> Path:
    """Return a folder in which these cases are stored, one part for each range."""
    with opened_store(folder, work.identity()) as store:
        for numbers in parts:
            store.save(rows_of(numbers))
    return folder


def test_rows_come_back_sorted_with_units(tmp_path: Path) -> None:
    folder = stored(tmp_path / "new" / "store", range(4, 7), range(4))
    frame = read_rows(folder)
    assert frame["case"].tolist() == list(range(7))
    assert frame["reading"].tolist() == [row["reading"] for row in rows_of(range(7))]
    pd.testing.assert_frame_equal(pd.read_parquet(folder / "rows").sort_values("case", ignore_index=True), frame)
    with opened_store(folder, work.identity()) as store:
        assert sorted(store.states) == list(range(7))
        assert store.schema.field("reading").metadata[b"unit"] == b"N*m"


def test_one_file_comes_of_many_and_is_the_same_whatever_they_were(tmp_path: Path) -> None:
    names = set()
    for name, parts in {
        "a": [range(6)],
        "b": [range(3, 6), range(3)],
        "c": [range(n, n + 1) for n in range(6)],
    }.items():
        with opened_store(stored(tmp_path / name, *parts), work.identity()) as store:
            store.merge()
            names.add(tuple(path.name for path in finished_parts(store.rows)))
        assert sorted(path.name for path in (tmp_path / name).iterdir()) == [".lock", "rows", "study.json"]
    assert len(names) == 1


def test_merged_parts_have_no_more_rows_than_they_may(tmp_path: Path) -> None:
    stored(tmp_path, range(5, 9), range(5))
    with opened_store(tmp_path, work.identity(), rows_per_part=4) as store:
        store.merge()
        assert [pd.read_parquet(path)["case"].tolist() for path in finished_parts(store.rows)] == [
            [0, 1, 2, 3],
            [4, 5, 6, 7],
            [8],
        ]


@pytest.mark.parametrize("damage", ["shorter", "a bit", "empty", "foreign name"])
def test_a_damaged_part_is_put_aside_and_costs_only_its_cases(damage: str, tmp_path: Path) -> None:
    path = finished_parts(stored(tmp_path, range(4), range(4, 7)) / "rows")[0]
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= damage == "a bit"
    path.write_bytes({"shorter": content[:-9], "empty": b""}.get(damage, content))
    if damage == "foreign name":
        path = path.rename(path.with_name("copy.parquet"))
    with opened_store(tmp_path, work.identity()) as store:
        assert sorted(store.states) == [4, 5, 6]
        (note,) = store.notes
        assert note == f"{path.name} was damaged; it is in {tmp_path}/damaged now and its cases are computed again"
    assert (tmp_path / "damaged" / path.name).exists()
    assert read_rows(tmp_path)["case"].tolist() == [4, 5, 6]


def test_a_case_that_is_there_twice_counts_once(tmp_path: Path) -> None:
    stored(tmp_path, range(4), range(2, 6))
    with opened_store(tmp_path, work.identity()) as store:
        assert sorted(store.states) == list(range(6))
    assert read_rows(tmp_path)["case"].tolist() == list(range(6))


@pytest.mark.parametrize("reached", ["partial", "merged", "rows gone", "exchanged"])
def test_a_merge_that_was_killed_is_finished_or_undone(reached: str, tmp_path: Path) -> None:
    stored(tmp_path, range(4), range(4, 7))
    with opened_store(stored(tmp_path / "whole", range(7)), work.identity()) as whole:
        new = whole.rows
    rows = tmp_path / "rows"
    new.rename(tmp_path / (".merged.999999999.partial" if reached == "partial" else "merged"))
    for path in sorted((tmp_path / "whole").iterdir()):
        path.unlink()
    (tmp_path / "whole").rmdir()
    if reached in {"rows gone", "exchanged"}:
        rows.rename(tmp_path / "replaced")
    if reached == "exchanged":
        (tmp_path / "merged").rename(rows)
    with opened_store(tmp_path, work.identity()) as store:
        assert sorted(store.states) == list(range(7))
        assert len(finished_parts(store.rows)) == (2 if reached == "partial" else 1)
    assert sorted(path.name for path in tmp_path.iterdir()) == [".lock", "rows", "study.json"]
    assert read_rows(tmp_path)["case"].tolist() == list(range(7))


def test_unfinished_cases_are_shown_and_tried_again(tmp_path: Path) -> None:
    with opened_store(tmp_path, work.identity()) as store:
        store.save(rows_of(range(3)))
        store.save_unfinished({"case": 3, "seed": 1003, "state": "unfinished", "error": "too long"})
        store.save(rows_of(range(4, 6)))
        store.merge()
    assert read_rows(tmp_path)["state"].tolist() == ["done"] * 3 + ["unfinished"] + ["done"] * 2
    with opened_store(tmp_path, work.identity()) as store:
        assert sorted(store.states) == [0, 1, 2, 4, 5]
    assert read_rows(tmp_path)["case"].tolist() == [0, 1, 2, 4, 5]


def test_a_second_writer_is_refused(tmp_path: Path) -> None:
    with (
        opened_store(tmp_path, work.identity()),
        pytest.raises(
            InputError, match=rf"is being written by process {os.getpid()} on .*; wait until it ends, or give"
        ),
        opened_store(tmp_path, work.identity()),
    ):
        pass
    with opened_store(tmp_path, work.identity()):
        assert read_rows(stored(tmp_path / "other", range(1)))["case"].tolist() == [0]


@pytest.mark.parametrize(
    ("other", "sentence"),
    [
        (
            work.identity(scenario="lift"),
            "holds another study: its scenario is wear rig, this study's is lift; go on in",
        ),
        (work.identity(draws="one by one"), "holds another study: its draws is not stated, this study's is one by one"),
        (Identity({"scenario": "wear rig"}, work.VALUES, work.RESULTS, {"numpy": "1.0"}), "was computed with numba "),
        (
            Identity({"scenario": "wear rig"}, work.VALUES, [Column("delay", "s")]),
            r"holds a study with other columns of results \(reading, hits\)",
        ),
    ],
)
def test_a_store_of_another_study_or_code_is_refused(other: Identity, sentence: str, tmp_path: Path) -> None:
    stored(tmp_path, range(2))
    with pytest.raises(InputError, match=sentence) as refused, opened_store(tmp_path, other):
        pass
    assert "folder" in str(refused.value)
    assert read_rows(tmp_path)["case"].tolist() == [0, 1]


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("study.json", "{", "study.json is no identity of a stored study"),
        ("study.json", '{"format": 0, "study": {}, "code": {}, "values": [], "results": []}', "has store format 0"),
        ("notes.txt", "mine", "holds other files and no study; give a new or empty folder"),
    ],
)
def test_a_folder_of_other_things_is_refused(name: str, content: str, sentence: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(InputError, match=sentence), opened_store(tmp_path, work.identity()):
        pass
    assert (tmp_path / name).read_text() == content


def test_a_table_that_gives_a_stored_case_other_values_is_refused(tmp_path: Path) -> None:
    with opened_store(stored(tmp_path, range(3)), work.identity()) as store:
        store.refuse_other_cases(work.cases(9))
        cases = work.cases(9)
        cases[1] = Case(1, cases[1].values, seed=5)
        with pytest.raises(
            InputError, match="case 1 was computed with seed 1001, now it has 5; go on in another folder"
        ):
            store.refuse_other_cases(cases)
        cases[1] = Case(1, {"load": 0.125, "motor": "x"}, seed=1001)
        with pytest.raises(InputError, match="case 1 was computed with motor 'motor 1', now it has 'x'"):
            store.refuse_other_cases(cases)


def test_a_full_disk_leaves_what_was_stored(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(handle: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with opened_store(stored(tmp_path, range(3), range(3, 5)), work.identity()) as store:
        monkeypatch.setattr(os, "fsync", full)
        with pytest.raises(OSError, match="No space left on device") as failed:
            store.save(rows_of(range(5, 9)))
        assert failed.value.filename == str(store.rows)
        store.merge()
        assert store.notes == [
            f"{tmp_path}: the parts were left as they are (No space left on device); all rows are there"
        ]
    monkeypatch.undo()
    assert sorted(path.name for path in tmp_path.iterdir()) == [".lock", "rows", "study.json"]
    assert read_rows(tmp_path)["case"].tolist() == list(range(5))


def test_an_empty_folder_has_no_rows(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="holds no rows of a study; run the study first"):
        read_rows(tmp_path)


def test_a_store_is_made_by_opening_it(tmp_path: Path) -> None:
    with opened_store(tmp_path / "store", work.identity()) as store:
        assert isinstance(store, Store)
        assert len(store.table()) == 0
