"""A matrix with its settings: baseline, scale, goal, uncertainty and history."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.monte_carlo import Uncertainty

if TYPE_CHECKING:
    from torquerig.decide.matrix import DecisionMatrix
    from torquerig.decide.matrix_io.matrix_table import Alias


@dataclass(frozen=True, kw_only=True)
class Cost:
    """The costs of the economic rating of VDI 2225, where it is not from points.

    Parameters
    ----------
    criterion : str
        The criterion whose values are the costs.
    permissible : float
        The highest cost that would be accepted [unit of the criterion].
    """

    criterion: str
    permissible: float


@dataclass(frozen=True, kw_only=True)
class MatrixCase:
    """A matrix with its settings.

    Parameters
    ----------
    matrix : DecisionMatrix
    baseline : str
        The alternative that Pugh starts from.
    profile : Profile
        The points scale.
    goal : str
    goal_words : tuple of str
        A criterion whose name has one of these words rates the goal.
    draws, seed : int
        Number of Monte Carlo samples and their random seed.
    uncertainty : Uncertainty
        Uncertainty of points and weights.
    cost : Cost or None
        For the economic rating.
    aliases : tuple of Alias
        Names that are known to mean one thing.
    history : tuple of str
        Earlier changes, in words, the oldest first.
    places : mapping of str to str
        Place of each criterion in its file, for findings.
    """

    matrix: DecisionMatrix
    baseline: str
    profile: Profile = TEACHING
    goal: str = ""
    goal_words: tuple[str, ...] = ()
    draws: int = 10_000
    seed: int = 0
    uncertainty: Uncertainty = field(default_factory=Uncertainty)
    cost: Cost | None = None
    aliases: tuple[Alias, ...] = ()
    history: tuple[str, ...] = ()
    places: Mapping[str, str] = field(default_factory=dict, compare=False)
