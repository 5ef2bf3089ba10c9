"""An answer to every case, in whatever order they arrive, whatever happens to workers."""

from __future__ import annotations

from collections import deque
from collections.abc import Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from typing import Any, Literal

from torquerig.cases.block import Block, Engine, Outcome
from torquerig.cases.case import Case, Failed, Work
from torquerig.cases.limits import Limits
from torquerig.errors import InputError

State = Literal["done", "failed", "unfinished"]


@dataclass(frozen=True)
class Answer:
    """What became of one case.

    ``done`` with its ``value``; ``failed`` or ``unfinished`` with an ``error`` in one sentence. A failed case
    fails each time; an unfinished one was given up because its worker died or it took too long. ``seconds`` is its
    share of the working time of its block [s].
    """

    case: Case
    state: State
    value: Any = None
    error: str | None = None
    seconds: float = 0.0


def answers(
    work: Work, inputs: Any, cases: Sequence[Case], *, engine: Engine, block_size: int = 8, limits: Limits | None = None
) -> Generator[Answer, None, None]:
    """Yield one answer for each case as they arrive.

    A block whose worker died or took too long is tried again in halves, down to single cases. So is a block of several
    cases that raised an error, so that only the case whose error it is fails.

    Parameters
    ----------
    work : function
        See :class:`torquerig.cases.case.Work`; for processes it must be importable by name.
    inputs : object
        What all cases share; each worker gets it once.
    cases : sequence of Case
        With one number each.
    block_size : int
        Cases that a worker gets at once. Handing a block over takes less than 1 % of 0.1 s.

    Raises
    ------
    InputError
        For a block size below one, and where the engine cannot start.
    """
    with closing(
        arriving(work, inputs, cases, engine=engine, block_size=block_size, limits=limits or Limits())
    ) as batches:
        for batch in batches:
            yield from batch


def arriving(
    work: Work, inputs: Any, cases: Sequence[Case], *, engine: Engine, block_size: int, limits: Limits
) -> Generator[list[Answer], None, None]:
    """Yield the answers that arrived since the last time; none, where workers have been silent for a second or two.

    Parameters and errors are those of :func:`answers`.
    """
    if block_size < 1:
        raise InputError(f"blocks of {block_size} cases hold none; give a block size of 1 or more")
    starts = deque(range(0, len(cases), block_size))
    again: deque[Block] = deque()
    given = 0
    with engine.started(work, inputs, limits=limits) as pool:
        while given or again or starts:
            while (again or starts) and pool.room():
                block = again.popleft() if again else Block(_next(cases, starts, block_size))
                pool.submit(block)
                given += 1
            outcomes = pool.finished()
            given -= len(outcomes)
            yield [answer for outcome in outcomes for answer in _answers_of(outcome, again, limits)]


def _next(cases: Sequence[Case], starts: deque[int], size: int) -> Sequence[Case]:
    start = starts.popleft()
    return cases[start : start + size]


def _answers_of(outcome: Outcome, again: deque[Block], limits: Limits) -> Iterator[Answer]:
    """Yield the answers of a block, or put what must be tried again into the queue."""
    block, share = outcome.block, outcome.seconds / len(outcome.block.cases)
    if outcome.kind == "answered":
        for case, value in zip(block.cases, outcome.answers, strict=True):
            if isinstance(value, Failed):
                yield Answer(case, "failed", error=value.error, seconds=share)
            else:
                yield Answer(case, "done", value, seconds=share)
    elif len(block.cases) > 1:
        again.extend(block.halves())
    elif outcome.kind == "raised":
        yield Answer(block.cases[0], "failed", error=outcome.error, seconds=share)
    elif block.tried + 1 < limits.tries:
        again.append(block.again())
    else:
        yield Answer(block.cases[0], "unfinished", error=f"given up after {limits.tries} tries: {outcome.error}")
