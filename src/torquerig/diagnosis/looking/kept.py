"""What is asked of a run's features again and again, for every model of it, worked out once."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TypeVar
from weakref import WeakKeyDictionary

from torquerig.diagnosis.looking.features import Features

Answer = TypeVar("Answer")


def kept(function: Callable[[Features], Answer]) -> Callable[[Features], Answer]:
    """Let a function of features alone answer each of them once, for as long as they live."""
    known: WeakKeyDictionary[Features, Answer] = WeakKeyDictionary()

    @wraps(function)
    def answer(seen: Features) -> Answer:
        if seen not in known:
            known[seen] = function(seen)
        return known[seen]

    return answer
