"""Decision matrix: one cell per alternative and criterion; a number, an interval or ``?``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.cell import UNKNOWN, Cell
from torquerig.decide.criterion import Better, Criterion, Indifference, Kind, Requirement, ValueFunction
from torquerig.errors import InputError, UnknownNameError, did_you_mean

__all__ = ["Better", "Cell", "Criterion", "DecisionMatrix", "Indifference", "Kind", "Requirement", "ValueFunction"]


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
        In the order in which the selection chart tests them.
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
            if not all(one.strip() for one in listed):
                raise InputError(f"{self.name}: the name of one {what} is empty; write one")
            twice = sorted({one for one in listed if listed.count(one) > 1})
            if twice:
                raise InputError(f"{self.name}: the {what} {twice[0]!r} occurs twice; give each a different name")
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
        """Return the index of an alternative; UnknownNameError with the close matches."""
        if alternative not in self.alternatives:
            raise UnknownNameError(
                f"{self.name}: {alternative!r} is not in the matrix; {did_you_mean(alternative, self.alternatives)}"
            )
        return self.alternatives.index(alternative)

    def only(self, *, alternatives: Iterable[str] | None = None, kind: Kind | None = None) -> DecisionMatrix:
        """Return the part with these alternatives and with the criteria of one kind; None keeps all."""
        rows = self.alternatives if alternatives is None else tuple(alternatives)
        columns = tuple(criterion for criterion in self.criteria if kind is None or criterion.kind is kind)
        wanted, names = set(rows), {criterion.name for criterion in columns}
        kept = {pair: cell for pair, cell in self.cells.items() if pair[0] in wanted and pair[1] in names}
        return replace(self, alternatives=rows, criteria=columns, cells=kept)
