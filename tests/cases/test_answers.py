"""Every case gets one answer, whatever happens to the workers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest

from tests.cases import work_functions as work
from torquerig.cases import Answer, Case, Limits, ThisMachine, ThisProcess, answers
from torquerig.cases.worker import packed, started_worker
from torquerig.errors import InputError


def all_of(*arguments: Any, **named: Any) -> dict[int, Answer]:
    """Return all answers by the number of their case, each of which must be there once."""
    found = list(answers(*arguments, **named))
    assert set(Counter(one.case.number for one in found).values()) == {1}
    return {one.case.number: one for one in found}


def test_answers_do_not_depend_on_blocks_and_workers() -> None:
    cases = work.cases(21)
    here = all_of(work.reading, 2.0, cases, engine=ThisProcess(), block_size=1)
    for size in (4, 8, 100):
        found = all_of(work.reading, 2.0, cases, engine=ThisProcess(), block_size=size)
        assert {n: one.value for n, one in found.items()} == {n: one.value for n, one in here.items()}
    there = all_of(work.reading, 2.0, cases, engine=ThisMachine(2), block_size=5)
    assert {n: one.value for n, one in there.items()} == {n: one.value for n, one in here.items()}
    assert {one.state for one in there.values()} == {"done"}


def test_an_error_is_of_the_case_that_raises_it() -> None:
    found = all_of(work.with_a_fault, 2.0, work.cases(16), engine=ThisProcess(), block_size=8)
    assert {n: one.error for n, one in found.items() if one.state == "failed"} == {
        5: "case 5: node 'drum' is not finite at 0.3 s",
        7: "it cannot be",
    }
    assert sum(one.state == "done" for one in found.values()) == 14


def test_an_error_of_the_program_is_named_with_its_place() -> None:
    def wrong(inputs: Any, block: Sequence[Case]) -> list[Mapping[str, Any]]:
        return [{"reading": 1 / 0} for _ in block]

    (one,) = all_of(wrong, None, work.cases(1), engine=ThisProcess()).values()
    assert one.error is not None
    assert one.error.startswith("ZeroDivisionError: division by zero (test_answers.py:")


def test_a_work_function_that_answers_too_little_fails() -> None:
    (one, _) = all_of(lambda inputs, block: [], None, work.cases(2), engine=ThisProcess()).values()
    assert (one.state, one.error) == ("failed", "the work function returned 0 answers for 1 cases")


def test_a_case_that_never_ends_is_given_up_and_costs_no_other() -> None:
    limits = Limits(seconds=0.4, tries=2, compiling=0.0)
    found = all_of(work.endless_at_3, 2.0, work.cases(4), engine=ThisMachine(1), block_size=2, limits=limits)
    assert {n: one.state for n, one in found.items() if one.state != "done"} == {3: "unfinished"}
    assert found[3].error == "given up after 2 tries: it took longer than 0.4 s"


def test_the_first_block_may_compile() -> None:
    limits = Limits(seconds=0.05, tries=1)
    found = all_of(work.slow_reading, 0.2, work.cases(2), engine=ThisMachine(1), block_size=1, limits=limits)
    assert [one.state for _, one in sorted(found.items())] == ["done", "unfinished"]
    assert found[1].error == "given up after 1 tries: it took longer than 0.05 s"


def test_a_worker_that_dies_costs_no_case(tmp_path: Path) -> None:
    found = all_of(work.deadly_once, str(tmp_path), work.cases(24), engine=ThisMachine(2), block_size=4)
    here = all_of(work.reading, 2.0, work.cases(24), engine=ThisProcess())
    assert (tmp_path / "was here").exists()
    assert {n: one.value for n, one in found.items()} == {n: one.value for n, one in here.items()}


def test_a_case_that_kills_its_worker_is_given_up() -> None:
    found = all_of(work.deadly_at_2, 2.0, work.cases(4), engine=ThisMachine(1), block_size=4, limits=Limits(tries=1))
    assert {n: one.state for n, one in found.items() if one.state != "done"} == {2: "unfinished"}
    assert found[2].error == "given up after 1 tries: the worker process ended by signal 9; memory may have run out"


def test_each_worker_has_one_thread() -> None:
    (one,) = all_of(work.threads_here, None, work.cases(1), engine=ThisMachine(1)).values()
    assert one.value == {"blas": 1, "numba": 1}


def test_inputs_travel_to_each_worker_once(tmp_path: Path) -> None:
    all_of(work.with_counted, work.Counted(tmp_path), work.cases(40), engine=ThisMachine(2), block_size=1)
    assert len(list(tmp_path.iterdir())) == 2


def test_a_worker_without_blocks_ends_after_a_time() -> None:
    worker = started_worker(packed(work.reading, 2.0), idle=0.1)
    while not worker.is_ready:
        worker.heard()
    with pytest.raises(EOFError):
        worker.heard()
    worker.end()


def test_a_function_that_workers_cannot_import_is_refused() -> None:
    with pytest.raises(InputError, match=r"<lambda> and its inputs cannot be sent .*top level of a module"):
        all_of(lambda inputs, block: [], None, work.cases(1), engine=ThisMachine(1))


def test_inputs_that_a_worker_cannot_load_are_one_sentence() -> None:
    with pytest.raises(InputError, match="a worker cannot load the work function or its inputs: OSError: lost"):
        all_of(work.reading, work.Unloadable(), work.cases(1), engine=ThisMachine(1))


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        (lambda: ThisMachine(0), "0 workers do nothing; give 1 or more"),
        (lambda: Limits(seconds=0), "a limit of 0 s for a case leaves no time"),
        (lambda: Limits(tries=0), "0 tries of a case are none"),
        (lambda: Limits(compiling=-1.0), "-1.0 s for compiling cannot be; give 0 s or more"),
        (lambda: all_of(work.reading, 1.0, work.cases(1), engine=ThisProcess(), block_size=0), "blocks of 0 cases"),
        (
            lambda: all_of(work.reading, 1.0, work.cases(1), engine=ThisProcess(), limits=Limits(seconds=1.0)),
            r"cannot be ended after a time; use ThisMachine\(workers=1\)",
        ),
    ],
)
def test_impossible_settings_are_refused(wrong: Any, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        wrong()
