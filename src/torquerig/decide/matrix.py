"""What is known of each alternative: one cell per criterion, a number, an interval or ``?``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import isfinite, nan

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.criterion import Better, Criterion, Demand, Indifference, Kind, ValueFunction
from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.parameter import Estimate
from torquerig.units import in_unit

__all__ = ["Better", "Cell", "Criterion", "DecisionMatrix", "Demand", "Indifference", "Kind", "ValueFunction"]


@dataclass(frozen=True, kw_only=True)
class Cell:
    """What is known of one alternative under one criterion, and from where.

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
        A remark for the reader; the reason, where the cell was set by hand.
    unknown_reason : str
        What fact is missing, for the list of open questions.
    """

    value: float | None = None
    low: float | None = None
    high: float | None = None
    text: str = ""
    source: str = ""
    evidence: str = ""
    note: str = ""
    unknown_reason: str = ""

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
    def known(self) -> bool:
        """Whether it is one number, without doubt."""
        return self.value is not None and (self.low is None or self.low == self.high)

    @property
    def unknown(self) -> bool:
        """Whether nothing is known: the ``?`` of the matrices."""
        return self.value is None and self.low is None

    @property
    def bounds(self) -> tuple[float, float]:
        """The lowest and highest value that it may have [unit of the criterion]; NaN where unknown."""
        if self.low is not None and self.high is not None:
            return self.low, self.high
        return (nan, nan) if self.value is None else (self.value, self.value)

    def shown(self) -> str:
        """Return the text for a table: ``1.27``, ``0.3..0.5``, ``0.4 (0.3..0.5)`` or ``?``."""
        if self.text:
            return self.text
        if self.unknown:
            return "?"
        if self.known:
            return f"{self.value:.4g}"
        interval = f"{self.low:.3g}..{self.high:.3g}"
        return interval if self.value is None else f"{self.value:.4g} ({interval})"

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


UNKNOWN = Cell()


@dataclass(frozen=True, kw_only=True)
class DecisionMatrix:
    """Alternatives against criteria; a pair without a cell is unknown, which never counts as zero.

    Parameters
    ----------
    name : str
        For messages and headings.
    alternatives : tuple of str
        Names, each once.
    criteria : tuple of Criterion
        In the order in which the selection chart asks them.
    cells : mapping of (alternative, criterion name) to Cell
    """

    alternatives: tuple[str, ...]
    criteria: tuple[Criterion, ...]
    cells: Mapping[tuple[str, str], Cell] = field(default_factory=dict)
    name: str = "matrix"

    def __post_init__(self) -> None:
        names = tuple(criterion.name for criterion in self.criteria)
        for what, listed in (("alternative", self.alternatives), ("criterion", names)):
            if not listed:
                raise InputError(f"{self.name}: there is no {what}; a matrix needs at least one")
            twice = sorted({one for one in listed if listed.count(one) > 1})
            if twice:
                raise InputError(f"{self.name}: the {what} {twice[0]!r} stands twice; give each its own name")
        alternatives, criteria = set(self.alternatives), set(names)
        for alternative, criterion in self.cells:
            if alternative not in alternatives:
                raise UnknownNameError(
                    f"{self.name}: a cell is given for the unknown alternative {alternative!r}; "
                    f"{did_you_mean(alternative, alternatives)}"
                )
            if criterion not in criteria:
                raise UnknownNameError(
                    f"{self.name}: {alternative} has a cell for the unknown criterion {criterion!r}; "
                    f"{did_you_mean(criterion, criteria)}"
                )

    def cell(self, alternative: str, criterion: str) -> Cell:
        """Return one cell; the unknown cell where none is given."""
        return self.cells.get((alternative, criterion), UNKNOWN)

    @cached_property
    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The ends of all intervals, two arrays of shape (alternatives, criteria); NaN where unknown."""
        ends = np.array(
            [[self.cell(row, column.name).bounds for column in self.criteria] for row in self.alternatives], dtype=float
        )
        return ends[..., 0], ends[..., 1]

    def index(self, alternative: str) -> int:
        """Return the place of an alternative; UnknownNameError with the close matches."""
        if alternative not in self.alternatives:
            raise UnknownNameError(
                f"{self.name}: {alternative!r} is not in the matrix; {did_you_mean(alternative, self.alternatives)}"
            )
        return self.alternatives.index(alternative)

    def only(self, *, alternatives: Iterable[str] | None = None, kind: Kind | None = None) -> DecisionMatrix:
        """Return the part with these alternatives and with the criteria of one kind; None keeps all."""
        rows = self.alternatives if alternatives is None else tuple(alternatives)
        columns = tuple(criterion for criterion in self.criteria if kind is None or criterion.kind is kind)
        names = {criterion.name for criterion in columns}
        kept = {pair: cell for pair, cell in self.cells.items() if pair[0] in set(rows) and pair[1] in names}
        return replace(self, alternatives=rows, criteria=columns, cells=kept)
