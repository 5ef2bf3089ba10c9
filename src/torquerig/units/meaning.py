"""What a spelled unit means: its kind of quantity and its SI value."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, lru_cache

from torquerig.errors import UnitError, did_you_mean
from torquerig.units.spellings import Signature, signatures
from torquerig.units.table import UNITS

SPELLINGS = 1024  # texts whose unit is kept; a program meets some hundred


@lru_cache(maxsize=SPELLINGS)
def kind_of(unit: str) -> str:
    """Return the kind of quantity that ``unit`` measures, such as ``torque`` for ``N*m``; UnitError if unknown."""
    kind = kinds_by_unit().get(plain_unit(unit))
    if kind is None:
        raise UnitError(f"the unit {unit!r} is not known; {did_you_mean(unit, kinds_by_unit())}")
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
    found = {
        kind: spelling for kind, spellings in UNITS.items() for spelling in spellings if spelling == plain_unit(text)
    }
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


@lru_cache(maxsize=SPELLINGS)
def plain_unit(unit: str) -> str:
    """Return a unit with the signs of the table: ``N m`` and ``N·m`` as ``N*m``, ``m²`` as ``m^2``."""
    swapped = unit.strip().replace("·", "*").replace("²", "^2").replace("µ", "u").replace("μ", "u").replace("Ω", "ohm")
    return re.sub(r"(?<=[A-Za-z]) (?=[a-z](\b|/))", "*", swapped) if "rms" not in swapped else swapped


@cache
def kinds_by_unit() -> dict[str, str]:
    """Return the kind of quantity of each spelling in the table."""
    return {spelling: kind for kind, spellings in UNITS.items() for spelling in spellings}
