"""Values as bytes and back, made of stated classes alone: a foreign file in the folder cannot run anything."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Collection
from importlib import import_module
from io import BytesIO
from typing import Any, TypeVar

from torquerig.cases.kept_results import KeptResults

Value = TypeVar("Value")


def bytes_of(value: Any) -> bytes:
    """Return a value of plain Python values and dataclasses as bytes."""
    return pickle.dumps(value, protocol=5)


def value_of(content: bytes, classes: Collection[str]) -> Any:
    """Return the value of :func:`bytes_of`.

    Parameters
    ----------
    classes : collection of str
        All that it may be made of besides numbers, texts, lists and mappings: ``torquerig.metrics.figure:Figure``.

    Raises
    ------
    pickle.UnpicklingError
        For another class, or bytes of another origin.
    """
    return _Reader(BytesIO(content), classes).load()


def read_value(kept: KeptResults, key: str, classes: Collection[str]) -> Any:
    """Return a kept value that is made of these classes; None where there is none."""
    content = kept.get(key)
    try:
        return None if content is None else value_of(content, classes)
    except (pickle.UnpicklingError, AttributeError, EOFError, ImportError, IndexError, TypeError):
        return None  # its digest is right, so that another program has written it: it is computed and written again


def kept_or_made(
    kept: KeptResults | None, kind: str, content: object, make: Callable[[], Value], *, classes: Collection[str]
) -> Value:
    """Return the kept value of this kind and content, or make and keep it; without ``kept`` it is made.

    Parameters
    ----------
    content : object
        All that the value depends on besides the code.
    classes : collection of str
        What it is made of, as for :func:`value_of`.
    """
    if kept is None:
        return make()
    key = kept.key(kind, content)
    found = read_value(kept, key, classes)
    if found is None:
        made = make()
        kept.put(key, bytes_of((made,)))
        return made
    value: Value = found[0]
    return value


class _Reader(pickle.Unpickler):
    def __init__(self, file: BytesIO, classes: Collection[str]) -> None:
        super().__init__(file)
        self.classes = classes

    def find_class(self, module: str, name: str) -> Any:
        if f"{module}:{name}" not in self.classes:
            raise pickle.UnpicklingError(f"{module}:{name} is no part of a kept result")
        return getattr(import_module(module), name)
