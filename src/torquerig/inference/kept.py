"""What was computed for one recording and is asked for again while a fit moves: a few answers of each kind."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Any, TypeVar

Answer = TypeVar("Answer")

MOST = 12  # answers of one kind: of lines there is one for each shaft, and a fit turns one number at a time


class Kept:
    """The latest answers of each kind, by what they depend on; they are shared and must not be changed."""

    def __init__(self) -> None:
        self._answers: dict[str, OrderedDict[Hashable, Any]] = {}

    def get(self, kind: str, key: Hashable, make: Callable[[], Answer]) -> Answer:
        """Return the answer of a kind for a key, from ``make`` where it is not there yet."""
        answers = self._answers.setdefault(kind, OrderedDict())
        if key in answers:
            answers.move_to_end(key)
        else:
            answers[key] = make()
            if len(answers) > MOST:
                answers.popitem(last=False)
        found: Answer = answers[key]
        return found
