"""Values as bytes and back, made of stated classes alone: a foreign file in the folder cannot run anything."""

from __future__ import annotations

import pickle
from collections.abc import Collection
from importlib import import_module
from io import BytesIO
from typing import Any


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


class _Reader(pickle.Unpickler):
    def __init__(self, file: BytesIO, classes: Collection[str]) -> None:
        super().__init__(file)
        self.classes = classes

    def find_class(self, module: str, name: str) -> Any:
        if f"{module}:{name}" not in self.classes:
            raise pickle.UnpicklingError(f"{module}:{name} is no part of a kept result")
        return getattr(import_module(module), name)
