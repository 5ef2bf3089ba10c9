"""Conversion of written quantities to SI, by a table of the spellings of data sheets.

A table instead of a units library, because libraries misread common spellings without an error: ``3 Nm`` as
newton-metre of textile count, ``5,2 N*m`` as 52, ``600 rpm`` as a frequency (pint 0.25 does all three, see docs/).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import ceil, floor, log10, pi

from torquerig.errors import UnitError, did_you_mean
from torquerig.sensible import beyond_sense
from torquerig.unit_remedies import COMMON, QUESTIONS, separated_number
from torquerig.unit_spellings import Signature, signatures

# kind of quantity -> the spellings of its units and what one of each is in SI; the first spelling is the SI unit
UNITS: dict[str, dict[str, float]] = {
    "torque": {
        "N*m": 1,
        "Nm": 1,
        "mN*m": 1e-3,
        "mNm": 1e-3,
        "N*cm": 1e-2,
        "Ncm": 1e-2,
        "kN*m": 1e3,
        "kNm": 1e3,
        "cN*m": 1e-2,
        "N*mm": 1e-3,
        "ozf*in": 7.061551814226044e-3,
        "lbf*in": 0.1129848290276167,
        "lbf*ft": 1.3558179483314004,
        "kgf*m": 9.80665,
        "kgf*cm": 9.80665e-2,
        "gf*cm": 9.80665e-5,
    },
    "inertia": {
        "kg*m^2": 1,
        "kgm2": 1,
        "kgm^2": 1,
        "kg*cm^2": 1e-4,
        "kgcm2": 1e-4,
        "kgcm^2": 1e-4,
        "g*cm^2": 1e-7,
        "gcm2": 1e-7,
        "gcm^2": 1e-7,
        "kg*mm^2": 1e-6,
        "lbm*ft^2": 0.0421401100938048,
        "lbm*in^2": 2.926396534292e-4,
        "lbf*in*s^2": 0.1129848290276167,
        "ozf*in*s^2": 7.061551814226044e-3,
    },
    "speed": {
        "rad/s": 1,
        "rpm": 2 * pi / 60,
        "min-1": 2 * pi / 60,
        "1/min": 2 * pi / 60,
        "r/min": 2 * pi / 60,
        "rev/min": 2 * pi / 60,
        "rev/s": 2 * pi,
        "deg/s": pi / 180,
    },
    "frequency": {"Hz": 1, "kHz": 1e3, "MHz": 1e6},
    "angle": {
        "rad": 1,
        "mrad": 1e-3,
        "urad": 1e-6,
        "deg": pi / 180,
        "arcmin": pi / 10800,
        "arcsec": pi / 648000,
        "rev": 2 * pi,
    },
    "torsional stiffness": {
        "N*m/rad": 1,
        "Nm/rad": 1,
        "kN*m/rad": 1e3,
        "N*m/deg": 180 / pi,
        "Nm/deg": 180 / pi,
        "N*m/arcmin": 10800 / pi,
        "Nm/arcmin": 10800 / pi,
    },
    "rotary damping": {"N*m*s/rad": 1, "Nms/rad": 1, "N*m*s": 1, "Nms": 1, "N*m/rpm": 30 / pi},
    "quadratic drag": {"N*m*s^2/rad^2": 1, "N*m*s^2": 1, "Nms2": 1},
    "time": {"s": 1, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "min": 60, "h": 3600},
    "rate": {"1/s": 1, "per second": 1, "per minute": 1 / 60},
    "order": {"1/rev": 1},
    "length": {"m": 1, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "nm": 1e-9, "in": 0.0254},
    "mass": {"kg": 1, "g": 1e-3},
    "force": {"N": 1, "mN": 1e-3, "kN": 1e3, "kgf": 9.80665, "lbf": 4.4482216152605, "kip": 4448.2216152605},
    "linear stiffness": {"N/m": 1, "N/mm": 1e3, "N/um": 1e6},
    "linear damping": {"N*s/m": 1, "Ns/m": 1},
    "linear quadratic drag": {"N*s^2/m^2": 1},
    "linear speed": {"m/s": 1, "mm/s": 1e-3, "in/s": 0.0254, "m/min": 1 / 60, "km/h": 1 / 3.6},
    "acceleration": {"m/s^2": 1, "mm/s^2": 1e-3, "g0": 9.80665},
    "pressure": {"Pa": 1, "hPa": 100, "kPa": 1e3, "MPa": 1e6, "mbar": 100, "bar": 1e5, "psi": 6894.757293168361},
    "voltage": {"V": 1, "mV": 1e-3, "uV": 1e-6, "kV": 1e3},
    "current": {"A": 1, "mA": 1e-3},
    "rms current": {"Arms": 1, "A rms": 1, "mArms": 1e-3},
    "torque constant (per rms ampere)": {"N*m/Arms": 1, "Nm/Arms": 1, "mN*m/Arms": 1e-3},
    "torque constant": {
        "N*m/A": 1,
        "Nm/A": 1,
        "mN*m/A": 1e-3,
        "ozf*in/A": 7.061551814226044e-3,
        "lbf*in/A": 0.1129848290276167,
    },
    "resistance": {"ohm": 1, "Ohm": 1, "mohm": 1e-3, "kohm": 1e3},
    "inductance": {"H": 1, "mH": 1e-3, "uH": 1e-6},
    "flux linkage": {"V*s": 1, "Vs": 1, "mV*s": 1e-3, "mVs": 1e-3, "V*s/rad": 1, "Wb": 1, "mWb": 1e-3},
    "power": {"W": 1, "mW": 1e-3, "kW": 1e3, "MW": 1e6, "hp": 745.6998715822702},
    "energy": {"J": 1, "kJ": 1e3, "Wh": 3600},
    "thermal resistance": {"K/W": 1},
    "temperature difference": {"K": 1},
    "sensitivity": {"V/(N*m)": 1, "V/Nm": 1, "mV/(N*m)": 1e-3, "mV/Nm": 1e-3},
    "force sensitivity": {"V/N": 1, "mV/N": 1e-3},
    "price": {"EUR": 1},
    "data": {"bit": 1},
    "share": {"1": 1, "%": 1e-2, "ppm": 1e-6},
}

IN_A_LINE = {
    "N*m": "N", "kg*m^2": "kg", "rad": "m", "rad/s": "m/s", "N*m/rad": "N/m", "N*m*s/rad": "N*s/m",
    "N*m*s^2/rad^2": "N*s^2/m^2",
}  # fmt: skip
"""What stands for the unit of a shaft where the same equation holds of something that moves in a line."""

_NUMBER = re.compile(r"^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$")


def kind_of(unit: str) -> str:
    """Return the kind of quantity that ``unit`` measures, such as ``torque`` for ``N*m``; UnitError if unknown."""
    kind = _kinds().get(_plain(unit))
    if kind is None:
        raise UnitError(f"the unit {unit!r} is not known; {did_you_mean(unit, _kinds())}")
    return kind


@dataclass(frozen=True, kw_only=True)
class Meaning:
    """What a spelled unit may mean: its kind of quantity, the first spelling in ``UNITS``, and its SI value."""

    kind: str
    symbol: str
    factor: float


@cache
def meanings(text: str) -> tuple[Meaning, ...]:
    """Return what ``text`` may mean as a unit, one entry a kind; empty where no kind has it.

    Any order and separator of the symbols is read: ``lb-ft``, ``Newton-meters``, ``RPM``, ``U/min``, ``mN·m/A``.
    ``"g"`` has two meanings, a mass and an acceleration; the column's name or the wanted kind decides.
    """
    found = {kind: spelling for kind, spellings in UNITS.items() for spelling in spellings if spelling == _plain(text)}
    for signature in sorted(signatures(text), key=sorted):
        for kind, symbol in _by_signature().get(signature, {}).items():
            found.setdefault(kind, symbol)
    return tuple(Meaning(kind=kind, symbol=symbol, factor=UNITS[kind][symbol]) for kind, symbol in found.items())


@cache
def _by_signature() -> dict[Signature, dict[str, str]]:
    """Return the first spelling of each combination of symbols, by kind."""
    table: dict[Signature, dict[str, str]] = {}
    for kind, spellings in UNITS.items():
        for spelling in spellings:
            for signature in _signatures_in_table(spelling):
                table.setdefault(signature, {}).setdefault(kind, spelling)
    return table


def _signatures_in_table(spelling: str) -> frozenset[Signature]:
    # the table's own spellings mean one thing each: kg is the mass and no kilopond
    found = signatures(spelling)
    return found if len(found) == 1 else frozenset(one for one in found if _spells(one, spelling))


def _spells(signature: Signature, spelling: str) -> bool:
    return all(re.search(rf"(?<![A-Za-z]){re.escape(symbol)}(?![A-Za-z])", spelling) for symbol, _ in signature)


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
    match = _NUMBER.match(text)
    if match is None:
        raise UnitError(f"{text!r} does not start with a number; write for example {_example('1.5', unit)}")
    number, written = float(match[1]), _plain(match[2])
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
    other = _kinds().get(written)
    if other is None:
        raise UnitError(f"{text!r} has an unknown unit; {did_you_mean(match[2], factors)}")
    raise UnitError(_of_another_kind(text, match[1], unit, number * UNITS[other][written], other))


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
    return value / UNITS[kind_of(unit)][_plain(unit)]


def si_unit(unit: str) -> str:
    """Return the SI unit of the kind of quantity that ``unit`` measures."""
    return next(iter(UNITS[kind_of(unit)]))


def written_quantity(value: float, unit: str) -> str:
    """Return ``value`` (SI) as the shortest text that ``parse_quantity`` reads back to the same float."""
    return f"{value!r} {unit}" if unit != "1" else repr(value)


def _plain(unit: str) -> str:
    swapped = unit.strip().replace("·", "*").replace("²", "^2").replace("µ", "u").replace("μ", "u").replace("Ω", "ohm")
    return re.sub(r"(?<=[A-Za-z]) (?=[a-z](\b|/))", "*", swapped) if "rms" not in swapped else swapped


def _example(number: str, unit: str) -> str:
    return f"'{number}'" if unit == "1" else f"'{number} {unit}'"


def _article(kind: str) -> str:
    return f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}"


@cache
def _kinds() -> dict[str, str]:
    return {spelling: kind for kind, spellings in UNITS.items() for spelling in spellings}
