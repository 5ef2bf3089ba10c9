"""One cell of a matrix: a number, an interval or ``?``, its sources, and what was set by hand."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import isfinite, nan
from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.units import in_unit

if TYPE_CHECKING:
    from torquerig.parameter import Estimate


@dataclass(frozen=True, kw_only=True)
class Origin:
    """A catalog value or measurement that a cell was calculated from.

    Parameters
    ----------
    name : str
        What it is: ``rotor inertia of HDS6A-0104A``.
    shown : str
        Its value with unit, or ``?`` with the interval.
    evidence, source : str
        The tag of ``torquerig.parameter.EVIDENCE``, and the page or table.
    """

    name: str
    shown: str = "?"
    evidence: str = ""
    source: str = ""


@dataclass(frozen=True, kw_only=True)
class Override:
    """A value or points set by hand, with the reason.

    Parameters
    ----------
    reason : str
        Required; it is shown with the cell.
    value : float or None
        Replaces the known value [unit of the criterion].
    points : float or None
        Replaces the points of the value function.
    """

    reason: str
    value: float | None = None
    points: float | None = None

    def __post_init__(self) -> None:
        if not self.reason.strip():
            raise InputError("a cell set by hand needs its reason; add reason: with a sentence")
        if (self.value is None) == (self.points is None):
            raise InputError("a cell is set by hand with either value or points; write one of them")
        if not isfinite(self.points if self.value is None and self.points is not None else self.value or 0.0):
            raise InputError("a cell is set by hand to a finite number")


@dataclass(frozen=True, kw_only=True)
class Cell:
    """What is known of one alternative under one criterion, with its sources.

    Parameters
    ----------
    value : float or None
        The number [unit of the criterion]; None where only an interval is known, or nothing.
    low, high : float or None
        The interval that the value lies in; both or neither.
    text : str
        How a table shows it, where that differs from the number (``yes``).
    source, evidence : str
        Where the number comes from.
    note : str
        A remark for the reader.
    unknown_reason : str
        What is missing, in words, for the list of open questions.
    fact : str
        The fact that the cell depends on (``rotor inertia of HDS6A-0104A``). Cells with the same fact are sampled
        together; empty where no other cell depends on it.
    origins : tuple of Origin
        The catalog values that it was calculated from.
    metric : str
        How it was calculated from them: a formula or a simulation, in words.
    by_hand : Override or None
        What replaces it.
    """

    value: float | None = None
    low: float | None = None
    high: float | None = None
    text: str = ""
    source: str = ""
    evidence: str = ""
    note: str = ""
    unknown_reason: str = ""
    fact: str = ""
    origins: tuple[Origin, ...] = ()
    metric: str = ""
    by_hand: Override | None = None

    def __post_init__(self) -> None:
        if any(number is not None and not isfinite(number) for number in (self.value, self.low, self.high)):
            raise InputError("a cell holds a finite number, an interval or ?; write ? where nothing is known")
        if (self.low is None) != (self.high is None):
            raise InputError("an interval needs both low and high")
        if self.low is not None and self.high is not None:
            middle = self.low if self.value is None else self.value
            if not self.low <= middle <= self.high:
                raise InputError(f"the interval {self.low:g}..{self.high:g} must run upwards and contain the value")

    @property
    def used(self) -> Cell:
        """The cell that is used: this one, or the value that was set by hand."""
        if self.by_hand is None or self.by_hand.value is None:
            return self
        return replace(self, value=self.by_hand.value, low=None, high=None, text="", by_hand=None)

    @property
    def points_by_hand(self) -> float | None:
        """The points that were set by hand; None where the value function counts."""
        return None if self.by_hand is None else self.by_hand.points

    @property
    def known(self) -> bool:
        """Whether it is one exact number."""
        low, high = self.bounds
        return low == high and self.used.value is not None

    @property
    def unknown(self) -> bool:
        """Whether nothing is known: the ``?`` of the matrices."""
        used = self.used
        return used.value is None and used.low is None

    @property
    def bounds(self) -> tuple[float, float]:
        """The lowest and highest value that it may have [unit of the criterion]; NaN where unknown."""
        if self.by_hand is not None and self.by_hand.value is not None:
            return self.by_hand.value, self.by_hand.value
        if self.low is not None and self.high is not None:
            return self.low, self.high
        return (nan, nan) if self.value is None else (self.value, self.value)

    def shown(self) -> str:
        """Return the text for a table: ``1.27``, ``0.3..0.5``, ``0.4 (0.3..0.5)``, ``?``, ``0.4 (by hand)``."""
        if self.by_hand is not None and self.by_hand.value is not None:
            return f"{self.by_hand.value:.4g} (by hand)"
        if self.text:
            return self.text
        if self.unknown:
            return "?"
        if self.known:
            return _digits(self.value, 4)
        interval = f"{_digits(self.low, 3)}..{_digits(self.high, 3)}"
        return interval if self.value is None else f"{_digits(self.value, 4)} ({interval})"

    @classmethod
    def from_estimate(cls, estimate: Estimate, unit: str) -> Cell:
        """Return the cell of a catalog value, counted in ``unit``; a guess becomes an interval, never a number."""
        if estimate.unknown:
            return cls(evidence=estimate.evidence, source=estimate.source, unknown_reason=estimate.note)
        low, high = (in_unit(end, unit) for end in estimate.bounds)
        value = None if estimate.value is None else in_unit(estimate.value, unit)
        if low == high and value is not None:
            return cls(value=value, evidence=estimate.evidence, source=estimate.source, note=estimate.note)
        return cls(
            value=value, low=low, high=high, evidence=estimate.evidence, source=estimate.source, note=estimate.note
        )


def _digits(number: float | None, digits: int) -> str:
    """Return the number with ``digits`` digits, and a large number without an exponent."""
    text = f"{number:.{digits}g}"
    return f"{float(text):.0f}" if "e+0" in text else text


UNKNOWN = Cell()
