"""A study goes on where it was stopped, and its rows are the same as without the stop."""

from __future__ import annotations

import errno
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.cases import work_functions as work
from torquerig.cases import (
    Case,
    Column,
    Failed,
    Identity,
    Limits,
    Progress,
    StudyRun,
    StudyStopped,
    ThisMachine,
    ThisProcess,
    read_rows,
    run_cases,
)
from torquerig.errors import InputError


def run(folder: Path, count: int = 20, **named: Any) -> StudyRun:
    """Run the study of these tests."""
    settings: dict[str, Any] = {"identity": work.identity(), "engine": ThisProcess()} | named
    function = settings.pop("function", work.reading)
    return run_cases(function, settings.pop("inputs", 2.0), work.cases(count), folder=folder, **settings)


def bytes_of(folder: Path) -> dict[str, bytes]:
    """Return the bytes of all parts of a store."""
    return {path.name: path.read_bytes() for path in sorted((folder / "rows").iterdir())}


def test_the_store_is_the_same_bytes_whatever_the_workers_and_blocks(tmp_path: Path) -> None:
    run(tmp_path / "a", block_size=3, save_every=0.0)
    run(tmp_path / "b", block_size=8)
    run(tmp_path / "c", block_size=4, engine=ThisMachine(2), save_every=0.0)
    assert bytes_of(tmp_path / "a") == bytes_of(tmp_path / "b") == bytes_of(tmp_path / "c")
    assert len(bytes_of(tmp_path / "a")) == 1


def test_more_cases_are_added_and_only_they_are_computed(tmp_path: Path) -> None:
    assert run(tmp_path / "grown", 12).computed == 12
    grown, again = run(tmp_path / "grown", 30), run(tmp_path / "grown", 30)
    assert (grown.computed, grown.total, again.computed) == (18, 30, 0)
    run(tmp_path / "at once", 30)
    assert bytes_of(tmp_path / "grown") == bytes_of(tmp_path / "at once")
    assert run(tmp_path / "grown", 12).computed == 0


@pytest.mark.parametrize("after", [1, 7, 19])
def test_what_was_done_before_ctrl_c_is_kept(after: int, tmp_path: Path) -> None:
    def stop(progress: Progress) -> None:
        if progress.done == after:
            raise KeyboardInterrupt

    with pytest.raises(
        StudyStopped, match=f"interrupted; {after} of 20 cases are stored in .*, and the same command goes"
    ):
        run(tmp_path / "stopped", block_size=3, progress=stop)
    assert len(read_rows(tmp_path / "stopped")) == after
    assert run(tmp_path / "stopped").computed == 20 - after
    run(tmp_path / "whole")
    assert bytes_of(tmp_path / "stopped") == bytes_of(tmp_path / "whole")


def test_a_full_disk_is_one_sentence_and_costs_only_what_was_not_stored(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain, calls = os.fsync, []

    def full(handle: int) -> None:
        calls.append(handle)
        if len(calls) > 10:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        plain(handle)

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left on device; ") as failed:
        run(tmp_path / "full", block_size=2, save_every=0.0)
    monkeypatch.undo()
    kept = len(read_rows(tmp_path / "full"))
    assert 0 < kept < 20
    assert failed.value.strerror == (f"No space left on device; {kept} cases are stored and are not computed again")
    assert run(tmp_path / "full").computed == 20 - kept
    run(tmp_path / "whole")
    assert bytes_of(tmp_path / "full") == bytes_of(tmp_path / "whole")


def test_failed_cases_are_rows_and_are_final(tmp_path: Path) -> None:
    first = run(tmp_path, function=work.with_a_fault)
    assert (first.computed, first.failed, first.unfinished) == (20, 2, 0)
    assert run(tmp_path, function=work.with_a_fault).computed == 0
    failed = first.rows().set_index("case").loc[[5, 7]]
    assert failed["error"].tolist() == ["case 5: node 'drum' is not finite at 0.3 s", "it cannot be"]
    assert failed["reading"].isna().all()


def test_rows_are_stored_while_other_cases_take_long(tmp_path: Path) -> None:
    named: dict[str, Any] = {"function": work.waits_for_others, "inputs": tmp_path, "engine": ThisMachine(2)}
    assert run(tmp_path, 4, block_size=1, save_every=0.1, **named).failed == 0


def test_unfinished_cases_are_tried_again(tmp_path: Path) -> None:
    (tmp_path / "mark").mkdir()
    once = {"function": work.deadly_once, "inputs": str(tmp_path / "mark"), "engine": ThisMachine(1)}
    first = run(tmp_path / "store", limits=Limits(tries=1), block_size=1, **once)
    assert (first.computed, first.unfinished) == (19, 1)
    assert first.rows().set_index("case").loc[11, "state"] == "unfinished"
    again = run(tmp_path / "store", limits=Limits(tries=1), block_size=1, **once)
    assert (again.computed, again.unfinished) == (1, 0)
    assert set(again.rows()["state"]) == {"done"}


def test_answers_that_are_no_rows_fail(tmp_path: Path) -> None:
    results: dict[int, Any] = {
        0: 3.0,
        1: {"readng": 1.0},
        2: {"hits": 1.5},
        3: {"hits": 2**63},
        4: Failed("half a \ud800 character"),
        5: {"reading": float("nan")},
        6: {},
    }

    def answered(inputs: None, block: Sequence[Case]) -> list[Mapping[str, Any]]:
        return [results[case.number] for case in block]

    frame = run(tmp_path, 7, function=answered, inputs=None).rows()
    assert frame["error"].tolist()[:5] == [
        "the work function returned float, not a mapping of columns to values",
        "the work function returned 'readng', which is no column of the study; did you mean 'reading'?",
        "the work function returned hits = 1.5, which is not of the kind 'int'",
        "the work function returned hits = 9223372036854775808, which is not of the kind 'int'",
        "half a \\ud800 character",
    ]
    assert frame["state"].tolist() == ["failed"] * 5 + ["done"] * 2


def test_progress_counts_what_was_stored(tmp_path: Path) -> None:
    run(tmp_path, 6)
    seen: list[Progress] = []
    run(tmp_path, 10, progress=seen.append, block_size=2)
    assert [one.done for one in seen] == [7, 8, 9, 10]
    assert seen[-1].remaining == 0.0
    assert {one.total for one in seen} == {10}


@pytest.mark.parametrize(
    ("cases", "sentence"),
    [
        ([Case(0, {"load": 1.0, "motor": "x"}), Case(0, {"load": 2.0, "motor": "x"})], "case 0 is in the table twice"),
        ([Case(-1, {"load": 1.0, "motor": "x"})], "case -1 has no possible number"),
        ([Case(0, {"load": 1.0, "motor": "x"}, seed=-1)], "case 0: seed -1 cannot be used"),
        ([Case(0, {"load": 1.0})], "case 0 has no value for 'motor'"),
        ([Case(0, {"load": 1.0, "moter": "x"})], "did you mean 'motor'|no value for 'motor'"),
        ([Case(0, {"load": "heavy", "motor": "x"})], "case 0: load is 'heavy'; give a value of the kind 'float'"),
        ([Case(0, {"load": float("nan"), "motor": "x"})], "case 0: load is nan; give a finite number, or None"),
        ([Case(0, {"load": np.float32("inf"), "motor": "x"})], "case 0: load is inf; give a finite number, or None"),
        ([Case(0, {"load": 10**40, "motor": "x"})], "case 0: load is 1000.*; give a value of the kind 'float'"),
        ([Case(0, {"load": 1.0, "motor": "\ud800"})], "case 0: motor is '.ud800'; give a value of the kind 'str'"),
        ([Case(0, {"load": True, "motor": "x"})], "case 0: load is True; give a value of the kind 'float'"),
    ],
)
def test_an_impossible_table_is_refused_before_anything_is_written(
    cases: list[Case], sentence: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=sentence):
        run_cases(work.reading, 2.0, cases, folder=tmp_path / "store", identity=work.identity(), engine=ThisProcess())
    assert not (tmp_path / "store").exists()


def test_columns_of_one_name_are_refused() -> None:
    with pytest.raises(InputError, match="column 'error': the engine writes that column"):
        Identity({}, [], [Column("error")])
    with pytest.raises(InputError, match="column 'load': there is another of that name"):
        Identity({}, [Column("load")], [Column("load")])
