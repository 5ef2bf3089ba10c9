"""Quantities with unit, values that are missing with the reason, and results as plain values for JSON."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, fields, is_dataclass
from math import isnan
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler
    from pydantic_core import CoreSchema

DIGITS = 12
"""Significant digits of a number: more than any input has, and rounding errors of the last bits are not shown."""


@dataclass(frozen=True)
class Missing:
    """A value that is not known or does not apply: null in JSON, with the reason in the list ``missing``."""

    reason: str

    @classmethod
    def __get_pydantic_core_schema__(cls, _source: Any, _handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return the schema of null."""
        from pydantic_core import core_schema

        return core_schema.none_schema()


@dataclass(frozen=True)
class Quantity:
    """A number with its unit."""

    value: float | Missing
    unit: str


@dataclass(frozen=True)
class Interval:
    """A number with the lowest and highest value that it may have, in one unit."""

    value: float | Missing
    low: float | Missing
    high: float | Missing
    unit: str


@dataclass(frozen=True)
class MissingValue:
    """The place of a null in the document, as JSON pointer (RFC 6901), and the reason."""

    at: str
    reason: str


def known(value: float | None, reason: str) -> float | Missing:
    """Return the number, or that it is missing for this reason."""
    return Missing(reason) if value is None or isnan(value) else float(value)


def plain_values(result: Any) -> tuple[Any, list[MissingValue]]:
    """Return a result in dicts, lists, texts, numbers and None, and the place and reason of each None.

    Raises
    ------
    TypeError
        For None without a reason, and for an object that JSON has no form for: an error of the program.
    """
    missing: list[MissingValue] = []
    return _plain(result, "", missing), missing


def _plain(value: Any, at: str, missing: list[MissingValue]) -> Any:
    if isinstance(value, Missing):
        missing.append(MissingValue(at, value.reason))
        return None
    if isinstance(value, bool | int | float | np.generic):
        return _number(value, at, missing)
    if isinstance(value, str):
        return str(value)
    return _nested(value, at, missing)


def _nested(value: Any, at: str, missing: list[MissingValue]) -> Any:
    if is_dataclass(value) and not isinstance(value, type):
        pairs = {field.name: getattr(value, field.name) for field in fields(value)}
        return {name: _plain(one, f"{at}/{name}", missing) for name, one in pairs.items()}
    if isinstance(value, Mapping):
        return {str(key): _plain(one, f"{at}/{_pointer(str(key))}", missing) for key, one in value.items()}
    if isinstance(value, Set):
        value = sorted(value)
    if isinstance(value, Sequence | np.ndarray):
        return [_plain(one, f"{at}/{place}", missing) for place, one in enumerate(value)]
    raise TypeError(f"{at}: {value!r} has no form in JSON")


def _number(value: Any, at: str, missing: list[MissingValue]) -> Any:
    value = value.item() if isinstance(value, np.generic) else value
    if not isinstance(value, float):
        return value
    if np.isfinite(value):
        return float(f"{value:.{DIGITS}g}")
    missing.append(MissingValue(at, "not a number" if isnan(value) else "infinite, which JSON cannot hold"))
    return None


def _pointer(key: str) -> str:
    return key.replace("~", "~0").replace("/", "~1")
