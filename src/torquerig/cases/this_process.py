"""Work in the process that asks for it: nothing to start, nothing that could be ended."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from torquerig.cases.block import Block, Outcome, worked_on
from torquerig.cases.case import Work
from torquerig.cases.limits import Limits
from torquerig.errors import InputError


@dataclass(frozen=True)
class ThisProcess:
    """The engine for few or short cases, tests and debuggers. It cannot limit the time of a case."""

    @contextmanager
    def started(self, work: Work, inputs: Any, *, limits: Limits) -> Iterator[_Here]:
        """Yield a pool of one that works when it is asked for what is finished; linear algebra has one thread inside.

        Raises
        ------
        InputError
            For a limit of time.
        """
        from threadpoolctl import threadpool_limits

        if limits.seconds is not None:
            raise InputError("a case in this process cannot be ended after a time; use ThisMachine(workers=1)")
        with threadpool_limits(limits=1, user_api="blas"):  # sums of several threads round otherwise
            yield _Here(work, inputs)


@dataclass
class _Here:
    work: Work
    inputs: Any
    waiting: list[Block] = field(default_factory=list)

    def room(self) -> int:
        return 1 - len(self.waiting)

    def submit(self, block: Block, /) -> None:
        self.waiting.append(block)

    def finished(self) -> list[Outcome]:
        return [worked_on(self.waiting.pop(), self.work, self.inputs)]
