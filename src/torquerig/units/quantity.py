"""Conversion of written quantities to SI, by a table of the spellings of data sheets.

A table instead of a units library, because libraries misread common spellings without an error: ``3 Nm`` as
newton-metre of textile count, ``5,2 N*m`` as 52, ``600 rpm`` as a frequency (pint 0.25 does all three, see docs/).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from math import ceil, floor, log10

from torquerig.errors import UnitError, did_you_mean
from torquerig.units.meaning import kind_of, kinds_by_unit, meanings, plain_unit
from torquerig.units.remedies import COMMON, QUESTIONS, separated_number
from torquerig.units.sensible import beyond_sense
from torquerig.units.table import UNITS

_NUMBER = re.compile(r"^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$")
_POWER_OF_TEN = re.compile(
    r"^(\s*[+-]?(?:\d+\.?\d*|\.\d+))\s*[x×·*]\s*10((?:\s*(?:\^|\*\*)\s*[+−-]?|[+−-])\d+|[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)(?![\d.])"
)
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻−", "0123456789+--", "^* ")


def parse_quantity(text: str, unit: str) -> float:
    """Return the number that ``text`` states, in the SI unit ``unit``: ``parse_quantity("32 N*cm", "N*m")`` is 0.32.

    Raises
    ------
    UnitError
        When the number is missing or has a comma, or the unit is missing, unknown or of another kind.
    """
    problem = separated_number(text)
    if problem:
        raise UnitError(problem)
    match = _NUMBER.match(_POWER_OF_TEN.sub(_as_exponent, text))
    if match is None:
        raise UnitError(f"{text!r} does not start with a number; write for example {_example('1.5', unit)}")
    number, written = float(match[1]), plain_unit(match[2])
    wanted = kind_of(unit)
    factors = UNITS[wanted]
    if not written and "1" in factors:
        return number
    if not written:
        raise UnitError(f"{text!r} has no unit; write {with_unit(match[1], unit)}")
    spelled = {one.factor for one in meanings(match[2]) if one.kind == wanted}
    if written in factors or len(spelled) == 1:
        value = number * (factors[written] if written in factors else spelled.pop())
        problem = unreasonable(value, unit)
        if problem:
            raise UnitError(f"{text!r} is {problem}")
        return value
    other = kinds_by_unit().get(written)
    if other is None:
        raise UnitError(f"{text!r} has an unknown unit; {did_you_mean(match[2], factors)}")
    raise UnitError(_of_another_kind(text, match[1], unit, number * UNITS[other][written], other))


def _as_exponent(found: re.Match[str]) -> str:
    """Return ``0.28 x 10^-4`` as ``0.28e-4``."""
    return f"{found[1]}e{int(found[2].translate(_RAISED))}"


def unreasonable(value: float, unit: str) -> str | None:
    """Return what is wrong with a size [SI] beyond reason, with the nearest sensible one; None for others."""
    kind = kind_of(unit)
    limit = beyond_sense(value, kind)
    if limit is None:
        return None
    shown = COMMON.get(kind, (unit,))[0]
    end = "smallest" if abs(value) < limit else "largest"
    inwards = _inwards(in_unit(limit, shown), floor if end == "largest" else ceil)
    return f"beyond reason; the {end} sensible size is {_example(f'{inwards:g}', shown)}"


def _inwards(limit: float, rounding: Callable[[float], int]) -> float:
    """Return a limit with two digits that is itself within it."""
    digit = 10.0 ** (floor(log10(limit)) - 1)
    return float(f"{rounding(float(f'{limit / digit:.9g}')) * digit:.2g}")


def with_unit(number: str | float, unit: str) -> str:
    """Return what to write for a bare number: ``'1000 rpm' or '1000 rad/s'``."""
    return " or ".join(_example(str(number), one) for one in COMMON.get(kind_of(unit), (unit,)))


def _of_another_kind(text: str, number: str, unit: str, value: float, other: str) -> str:
    """Return the error for a quantity ``value`` [SI] of the kind ``other`` where ``unit`` is wanted."""
    wanted = kind_of(unit)
    said = f"{text!r} is {_article(other)}; {_article(wanted)} is wanted"
    question, answers = QUESTIONS.get((wanted, other), ("", ()))
    if not answers:
        return f"{said}, write {_example(number, COMMON.get(wanted, (unit,))[0])}"
    shown = COMMON.get(wanted, (unit,))[0]
    readings = [f"{_example(f'{in_unit(value * factor, shown):.6g}', shown)} ({words})" for words, factor in answers]
    return f"{said}{f': {question}' if question else ','} write {' or '.join(readings)}"


def in_unit(value: float, unit: str) -> float:
    """Return the SI number ``value`` counted in ``unit``: ``in_unit(104.72, "rpm")`` is 1000."""
    return value / UNITS[kind_of(unit)][plain_unit(unit)]


def si_unit(unit: str) -> str:
    """Return the SI unit of the kind of quantity that ``unit`` measures."""
    return next(iter(UNITS[kind_of(unit)]))


def written_quantity(value: float, unit: str) -> str:
    """Return ``value`` (SI) as the shortest text that ``parse_quantity`` reads back to the same float."""
    return f"{value!r} {unit}" if unit != "1" else repr(value)


def _example(number: str, unit: str) -> str:
    return f"'{number}'" if unit == "1" else f"'{number} {unit}'"


def _article(kind: str) -> str:
    return f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}"
