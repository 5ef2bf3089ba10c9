"""The readings that a printed figure allows, and the range over them: an ambiguous figure is never guessed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from torquerig.catalog.printed.figure import Figure
from torquerig.errors import UnitError


@dataclass(frozen=True)
class Factor:
    """What one printed reading of a figure is worth in the unit of the entry's field.

    Parameters
    ----------
    words : frozenset of str
        The words of this reading: ``{"line", "rms"}``.
    low, high : float
        Value of the field over the printed value; equal where the shape of the back-EMF does not matter.
    formula : str
        The factor in symbols, for the shown conversion.
    """

    words: frozenset[str]
    low: float
    high: float
    formula: str


@dataclass(frozen=True)
class Reading:
    """One reading of a figure: its factor, and the range that it gives [SI]."""

    factor: Factor
    low: float
    high: float

    @property
    def spoken(self) -> str:
        """Its words in the order in which a sheet prints them: ``line-to-line rms``."""
        return spoken(self.factor.words)

    @property
    def conversion(self) -> str:
        """What is done to the printed number: ``times sqrt(3) (line-to-line rms)``, or ``taken as rms``."""
        formula = self.factor.formula
        return f"taken as {self.spoken}" if formula == "1" else f"times {formula} ({self.spoken})"


WITHOUT_EFFECT = frozenset({"unstated", "of rated", "star", "delta"})
"""Words that may stand next to any figure: the winding matters per phase only, where it is asked for."""
SPOKEN = {"line": "line-to-line", "phase": "per phase", "star": "star", "delta": "delta", "rms": "rms", "peak": "peak",
          "dc": "dc", "peak-to-peak": "peak-to-peak", "amplitude": "amplitude"}  # fmt: skip


def spoken(words: Iterable[str]) -> str:
    """Return words as a sheet prints them."""
    held = set(words)
    return " ".join(text for word, text in SPOKEN.items() if word in held)


def factor(words: str, value: float | tuple[float, float], formula: str) -> Factor:
    """Return a factor; ``value`` is a pair where it depends on the shape of the back-EMF."""
    low, high = value if isinstance(value, tuple) else (value, value)
    return Factor(frozenset(words.split()), low, high, formula)


def readings(figure: Figure, printed: tuple[float, float], factors: Sequence[Factor]) -> list[Reading]:
    """Return every reading of ``figure`` that its words allow; ``printed`` is its range in the printed kind [SI].

    Raises
    ------
    UnitError
        Where a word does not fit to such a figure, so that it would be ignored.
    """
    known = {word for one in factors for word in one.words}
    said = frozenset("peak" if word == "amplitude" and "amplitude" not in known else word for word in figure.words)
    foreign = sorted(said - known - WITHOUT_EFFECT)
    if foreign:
        fitting = ", ".join(text for word, text in SPOKEN.items() if word in known)
        raise UnitError(f"{figure.text!r}: {foreign[0]!r} does not fit here; fitting words are {fitting}")
    said &= known
    return [Reading(one, printed[0] * one.low, printed[1] * one.high) for one in factors if said <= one.words]


def span(found: Iterable[Reading]) -> tuple[float, float]:
    """Return the range that covers all readings [SI]."""
    held = list(found)
    return min(one.low for one in held), max(one.high for one in held)
