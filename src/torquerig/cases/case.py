"""One case of a study: its number, its values and its seed; and the columns of the table of all cases."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeAlias

from torquerig.errors import InputError, did_you_mean

Scalar: TypeAlias = float | int | str | bool | None
Kind = Literal["float", "int", "str", "bool"]

ENGINE_COLUMNS = ("case", "seed", "state", "error")
_HALVES = re.compile("[\ud800-\udfff]")  # of characters, which no file of text can hold
MOST = 2**63 - 1  # of a number or a seed, as a column of whole numbers holds it
_TYPES: Mapping[str, tuple[type, ...]] = {"float": (float, int), "int": (int,), "str": (str,), "bool": (bool,)}


@dataclass(frozen=True)
class Case:
    """One independent case: what the work function gets beside the inputs that all cases share.

    Parameters
    ----------
    number : int
        The case's place in the study, from 0; no two cases have the same.
    values : mapping of str to scalar
        What differs from case to case, by the name of its column.
    seed : int
        Of all random numbers of the case, 0 to 2^63 - 1.
    """

    number: int
    values: Mapping[str, Scalar]
    seed: int = 0


@dataclass(frozen=True)
class Column:
    """A column of the table of results: its name, unit (``""`` for none), kind of value and meaning."""

    name: str
    unit: str = ""
    kind: Kind = "float"
    meaning: str = ""

    def holds(self, value: Any) -> bool:
        """Whether a value can be in this column; None can, a numpy number can, True is no number."""
        value = plain(value)
        if value is None:
            return True
        if not isinstance(value, _TYPES[self.kind]) or (self.kind == "bool") != isinstance(value, bool):
            return False
        if isinstance(value, str):
            return not _HALVES.search(value)
        return not isinstance(value, int) or abs(value) <= MOST


@dataclass(frozen=True)
class Failed:
    """In place of a case's answer: it has none, and this sentence says why."""

    error: str


class Work(Protocol):
    """A function that answers a block of cases, one answer a case and in their order.

    An answer is whatever can be pickled; for a stored study a mapping of column names to scalars. An answer may be
    :class:`Failed`. What is raised is taken to be the fault of one case of the block: the block is halved until that
    case is alone. Answers must not depend on which cases are in one block.
    """

    def __call__(self, inputs: Any, cases: Sequence[Case], /) -> Sequence[Any]:
        """Return one answer for each case; ``inputs`` are the same for all blocks."""
        ...


def plain(value: Any) -> Any:
    """Return a numpy scalar as the Python value it holds; all else as it is."""
    return value.item() if hasattr(value, "item") and getattr(value, "ndim", None) == 0 else value


def checked_columns(values: Sequence[Column], results: Sequence[Column]) -> None:
    """Refuse columns that cannot be in one table.

    Raises
    ------
    InputError
        For a name that is used twice or that the engine uses.
    """
    names: set[str] = set(ENGINE_COLUMNS)
    for column in (*values, *results):
        if column.name in names:
            why = "the engine writes that column" if column.name in ENGINE_COLUMNS else "there is another of that name"
            raise InputError(f"column {column.name!r}: {why}; give this one another name")
        names.add(column.name)


def checked_numbers(cases: Sequence[Case]) -> list[int]:
    """Return the numbers of the cases, in their order.

    Raises
    ------
    InputError
        For a number that is used twice or out of range.
    """
    numbers = [case.number for case in cases]
    if len(set(numbers)) < len(numbers):
        twice = next(number for number, times in Counter(numbers).items() if times > 1)
        raise InputError(f"case {twice} is in the table twice; number the cases from 0 upwards")
    wrong = next((number for number in numbers if not _is_whole(number)), None)
    if wrong is not None:
        raise InputError(f"case {wrong!r} has no possible number; number the cases from 0 upwards")
    return numbers


def checked_values(cases: Iterable[Case], columns: Sequence[Column]) -> None:
    """Refuse a table of cases whose values the columns cannot hold.

    Raises
    ------
    InputError
        For the first case with an unknown, missing, wrong or infinite value, or a seed that is none.
    """
    known = {column.name: column for column in columns}
    for case in cases:
        if not _is_whole(case.seed):
            raise InputError(
                f"case {case.number}: seed {case.seed!r} cannot be used; give a whole number from 0 to 2^63 - 1"
            )
        for name in case.values.keys() ^ known.keys():
            if name in known:
                raise InputError(f"case {case.number} has no value for {name!r}; give one, or None")
            raise InputError(
                f"case {case.number}: value {name!r} is no column of the study; {did_you_mean(name, known)}"
            )
        for name, value in case.values.items():
            if not known[name].holds(value):
                raise InputError(
                    f"case {case.number}: {name} is {value!r}; give a value of the kind {known[name].kind!r}"
                )
            number = plain(value)
            if isinstance(number, float) and not math.isfinite(number):
                raise InputError(f"case {case.number}: {name} is {value}; give a finite number, or None")


def _is_whole(value: Any) -> bool:
    return isinstance(plain(value), int) and not isinstance(value, bool) and 0 <= value <= MOST
