"""Blocks of cases, and what became of them."""

from __future__ import annotations

import time
import traceback
from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, Protocol

from torquerig.cases.case import Case, Work
from torquerig.cases.limits import Limits
from torquerig.errors import TorquerigError


@dataclass(frozen=True)
class Block:
    """Cases that one worker gets at once; ``tried`` counts how often they were started without an answer."""

    cases: Sequence[Case]
    tried: int = 0

    def halves(self) -> list[Block]:
        """Return the two halves of a block of several cases."""
        middle = len(self.cases) // 2
        return [Block(self.cases[:middle]), Block(self.cases[middle:])]

    def again(self) -> Block:
        """Return the block as it is tried once more."""
        return replace(self, tried=self.tried + 1)


@dataclass(frozen=True)
class Outcome:
    """What became of a block.

    ``answered``: ``answers`` has one for each case. ``raised``: the work function raised an error, which it will do
    again. ``lost``: the worker died, ran out of memory or time, which may be another next time. ``error`` says what
    happened in one sentence; ``seconds`` is how long the work function took [s].
    """

    block: Block
    kind: Literal["answered", "raised", "lost"]
    answers: Sequence[Any] = ()
    error: str = ""
    seconds: float = 0.0


class Pool(Protocol):
    """Workers that are running."""

    def room(self) -> int:
        """Return how many blocks can be given to the workers now."""
        ...

    def submit(self, block: Block, /) -> None:
        """Give a block to a worker; there must be room."""
        ...

    def finished(self) -> list[Outcome]:
        """Wait until at least one block is no longer being worked on, and return what became of each such."""
        ...


class Engine(Protocol):
    """Where blocks are worked on."""

    def started(self, work: Work, inputs: Any, *, limits: Limits) -> AbstractContextManager[Pool]:
        """Return a context with running workers, which end with it; each has got the work function and the inputs once.

        Raises
        ------
        InputError
            When there can be no workers, or they cannot get the function or the inputs.
        """
        ...


def worked_on(block: Block, work: Work, inputs: Any) -> Outcome:
    """Call the work function for a block in this process and return what became of it."""
    start = time.perf_counter()
    try:
        answers = list(work(inputs, block.cases))
    except MemoryError:
        return Outcome(block, "lost", error="memory ran out", seconds=time.perf_counter() - start)
    except Exception as error:  # whatever it is, it is of one case and must not end the study
        return Outcome(block, "raised", error=sentence_of(error), seconds=time.perf_counter() - start)
    seconds = time.perf_counter() - start
    if len(answers) != len(block.cases):
        error_text = f"the work function returned {len(answers)} answers for {len(block.cases)} cases"
        return Outcome(block, "raised", error=error_text, seconds=seconds)
    return Outcome(block, "answered", answers, seconds=seconds)


def sentence_of(error: BaseException) -> str:
    """Return an error as one line; one that is not of torquerig with its type and the place that raised it."""
    if isinstance(error, TorquerigError):
        return str(error)
    text = " ".join(str(error).split())
    frames = traceback.extract_tb(error.__traceback__)
    place = f" ({Path(frames[-1].filename).name}:{frames[-1].lineno})" if frames else ""
    return f"{type(error).__name__}: {text}{place}" if text else f"{type(error).__name__}{place}"
