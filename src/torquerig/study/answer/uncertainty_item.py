"""One contribution to a measurement uncertainty."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, kw_only=True)
class Item:
    """One row of a budget.

    Parameters
    ----------
    name : str
    kind : {"A", "B"}
        Type of its evaluation: from repeated observations, or from other knowledge (GUM 4.2, 4.3).
    standard : float or None
        Standard uncertainty [unit of the budget]; None where it is not known.
    basis : str
        What it was computed from, and its distribution.
    source : str
    remedy : str
        How to make it known, where it is not.
    is_counted : bool
        Whether it adds to the combination; an item that the simulation contains is already in the reading error.
    """

    name: str
    kind: Literal["A", "B"]
    standard: float | None
    basis: str
    source: str
    remedy: str = ""
    is_counted: bool = True
