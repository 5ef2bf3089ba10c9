"""A matrix with how to judge it: datum, scale, goal, doubts, and what was decided before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from torquerig.decide.draws import Doubt
from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.sheet import Alias


@dataclass(frozen=True, kw_only=True)
class Cost:
    """What the economic rating of VDI 2225 is counted from, where it is not from points.

    Parameters
    ----------
    criterion : str
        Whose values are the costs.
    permissible : float
        The highest cost that would be accepted [unit of the criterion].
    """

    criterion: str
    permissible: float


@dataclass(frozen=True, kw_only=True)
class MatrixCase:
    """A matrix with how to judge it.

    Parameters
    ----------
    matrix : DecisionMatrix
    datum : str
        The alternative that Pugh starts from.
    profile : Profile
        The points scale.
    goal : str
    goal_words : tuple of str
        What a criterion's name must hold to ask for the goal.
    draws, seed : int
        Of the joint draws.
    doubt : Doubt
        How far points and weights may be off.
    cost : Cost or None
        For the economic rating.
    aliases : tuple of Alias
        Names that are known to mean one thing.
    history : tuple of str
        What was changed before, in words, the oldest first.
    places : mapping of str to str
        Where each criterion stands in its file, for findings.
    """

    matrix: DecisionMatrix
    datum: str
    profile: Profile = TEACHING
    goal: str = ""
    goal_words: tuple[str, ...] = ()
    draws: int = 10_000
    seed: int = 0
    doubt: Doubt = field(default_factory=Doubt)
    cost: Cost | None = None
    aliases: tuple[Alias, ...] = ()
    history: tuple[str, ...] = ()
    places: Mapping[str, str] = field(default_factory=dict, compare=False)
