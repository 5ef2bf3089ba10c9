"""A study run into its store: what is there is kept, the rest is computed, and stored as it arrives."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.cases.answers import Answer, arriving
from torquerig.cases.block import Engine
from torquerig.cases.case import Case, Column, Work, checked_numbers, checked_values, plain
from torquerig.cases.identity import Identity
from torquerig.cases.limits import Limits
from torquerig.cases.store import Store, opened_store, read_rows
from torquerig.cases.this_machine import ThisMachine
from torquerig.cases.unbroken import unbroken
from torquerig.errors import did_you_mean
from torquerig.harmless import harmless

if TYPE_CHECKING:
    import pandas as pd

MERGE_FROM = 200  # parts: a reader opens each, which takes about 1 ms


@dataclass(frozen=True)
class Progress:
    """How far a study is: cases that have a row, of all; those without an answer; time that remains [s], if known."""

    done: int
    total: int
    failed: int
    unfinished: int
    remaining: float | None


class StudyStopped(KeyboardInterrupt):
    """Ctrl-C in a study; the text says what is kept and how to go on."""


@dataclass(frozen=True)
class StudyRun:
    """A study that has ended: where its rows are, how many cases it has, and what was noticed on the way.

    ``computed`` cases were computed by this run, the others were stored. ``failed`` cases have no answer and fail each
    time; ``unfinished`` ones are tried again by the next run. ``work_seconds`` is the time in the work function, added
    over all workers, ``seconds`` the time on the clock [s].
    """

    folder: Path
    total: int
    computed: int
    failed: int
    unfinished: int
    work_seconds: float
    seconds: float
    notes: Sequence[str] = ()

    def rows(self) -> pd.DataFrame:
        """Return the stored rows, sorted by case."""
        return read_rows(self.folder)


def run_cases(
    work: Work,
    inputs: Any,
    cases: Sequence[Case],
    *,
    folder: Path,
    identity: Identity,
    engine: Engine | None = None,
    block_size: int = 8,
    limits: Limits | None = None,
    save_every: float = 5.0,
    progress: Callable[[Progress], None] | None = None,
) -> StudyRun:
    """Compute the cases that a store lacks, and return what is there then.

    The rows do not depend on the engine, its workers, the block size or interruptions. A study may be run again with
    more cases: those that are stored are not computed again.

    Parameters
    ----------
    work : function
        Returns one row for each case: a mapping of names of ``identity.results`` to scalars; what it leaves out is
        empty. See :class:`torquerig.cases.case.Work`.
    inputs : object
        What all cases share; each worker gets it once.
    cases : sequence of Case
        All cases of the study; their values have the names of ``identity.values``.
    folder : Path
        The store.
    identity : Identity
        What determines the rows.
    engine : Engine, optional
        ``ThisMachine()`` when not given.
    block_size : int
        Cases that a worker gets at once.
    save_every : float
        Time between two parts [s]: how much work a failure of power may cost.
    progress : function, optional
        Called for each case that is done.

    Raises
    ------
    InputError
        For a store of another study or in use, a table of cases that is none, and where the engine cannot start.
    OSError
        Where the store cannot be written, for example on a full disk; its text says how many cases are kept.
    StudyStopped
        After Ctrl-C; what was done is stored.
    """
    start = time.monotonic()
    numbers = checked_numbers(cases)
    checked_values(cases, identity.values)
    with opened_store(folder, identity) as store:
        store.refuse_other_cases(cases)
        missing = [case for case, number in zip(cases, numbers, strict=True) if number not in store.states]
        failed = sum(store.states.get(number) == "failed" for number in numbers)
        tally = _Tally(total=len(cases), stored=len(cases) - len(missing), failed=failed, start=start)
        if missing:
            engine, limits = engine or ThisMachine(), limits or Limits()
            batches = arriving(work, inputs, missing, engine=engine, block_size=block_size, limits=limits)
            with closing(batches):
                _store_all(batches, store, tally, save_every=save_every, progress=progress)
        with unbroken():
            store.merge()
        return StudyRun(
            folder, len(cases), tally.computed, tally.failed, tally.unfinished,
            tally.work_seconds, time.monotonic() - start, tuple(store.notes),
        )  # fmt: skip


@dataclass
class _Tally:
    """Counts of a running study."""

    total: int
    stored: int
    failed: int
    start: float
    computed: int = 0
    unfinished: int = 0
    work_seconds: float = 0.0

    def count(self, row: dict[str, Any], answer: Answer) -> None:
        self.computed += row["state"] != "unfinished"
        self.failed += row["state"] == "failed"
        self.unfinished += row["state"] == "unfinished"
        self.work_seconds += answer.seconds

    def progress(self) -> Progress:
        ended = self.computed + self.unfinished
        left = self.total - self.stored - ended
        pace = (time.monotonic() - self.start) / ended if ended else None
        return Progress(
            self.stored + ended, self.total, self.failed, self.unfinished, None if pace is None else left * pace
        )


@dataclass
class _Pending:
    """Rows that are not on the disk yet."""

    store: Store
    save_every: float
    rows: list[dict[str, Any]] = field(default_factory=list)
    saved: float = field(default_factory=time.monotonic)

    def add(self, row: dict[str, Any]) -> None:
        if row["state"] == "unfinished":
            self.store.save_unfinished(row)
            return
        self.rows.append(row)

    def save_if_due(self) -> None:
        if time.monotonic() - self.saved >= self.save_every:
            self.save()

    def save(self) -> None:
        with unbroken():
            self.store.save(self.rows)
            self.rows, self.saved = [], time.monotonic()
            if self.store.parts >= MERGE_FROM:
                self.store.merge()


def _store_all(
    batches: Generator[list[Answer], None, None],
    store: Store,
    tally: _Tally,
    *,
    save_every: float,
    progress: Callable[[Progress], None] | None,
) -> None:
    """Store the answers as they arrive; on Ctrl-C and errors, first what has arrived."""
    pending = _Pending(store, save_every)
    columns = {column.name: column for column in store.identity.results}
    try:
        for batch in batches:
            for answer in batch:
                row = _row_of(answer, columns)
                tally.count(row, answer)
                pending.add(row)
                if progress is not None:
                    progress(tally.progress())
            pending.save_if_due()
        pending.save()
    except OSError as error:
        kept = f"{error.strerror}; {len(store.states)} cases are stored and are not computed again"
        raise OSError(error.errno, kept, error.filename) from error
    except KeyboardInterrupt as stop:
        pending.save()
        raise StudyStopped(
            f"interrupted; {len(store.states)} of {tally.total} cases are stored in {store.folder}, and the same "
            "command goes on from there"
        ) from stop
    except BaseException:
        pending.save()
        raise


def _row_of(answer: Answer, columns: dict[str, Column]) -> dict[str, Any]:
    """Return the row of an answer; one that does not fit the columns is a failed case."""
    case = answer.case
    error = None if answer.error is None else harmless(answer.error)
    row = {"case": case.number, "seed": case.seed, "state": answer.state, "error": error, **case.values}
    if answer.state != "done":
        return row
    misfit = _misfit(answer.value, columns)
    return row | ({"state": "failed", "error": harmless(misfit)} if misfit else dict(answer.value))


def _misfit(value: Any, columns: dict[str, Column]) -> str | None:
    if not hasattr(value, "items"):
        return f"the work function returned {type(value).__name__}, not a mapping of columns to values"
    for name, one in value.items():
        if name not in columns:
            return (
                f"the work function returned {name!r}, which is no column of the study; {did_you_mean(name, columns)}"
            )
        if not columns[name].holds(one):
            return (
                f"the work function returned {name} = {plain(one)!r}, which is not of the kind {columns[name].kind!r}"
            )
    return None
