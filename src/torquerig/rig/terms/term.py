"""What all terms have in common: the nodes that they name, and what they need of the shaft that they are on."""

from __future__ import annotations

from typing import NamedTuple


class ShaftMotion(NamedTuple):
    """How a node moves, as far as its mean torque depends on it.

    Speed [rad/s], acceleration [rad/s^2], way (1, 0 or -1: the direction that counts for dry friction and loads),
    peak (the share of Stribeck's peak that counts), load_share (what the loads are, in multiples of their means).
    """

    speed: float
    acceleration: float
    way: float
    peak: float
    load_share: float


class Term:
    """One piece of physics; ``simulation/term_kinds/`` says how it is simulated.

    No abstract base class of Python: a fit asks for the kind of terms a million times, which takes those ten times as
    long.
    """

    @property
    def nodes(self) -> tuple[str, ...]:
        """The nodes that it names; each must carry an inertia, or be the ground."""
        raise NotImplementedError

    def needed_torque(self, node: str, motion: ShaftMotion) -> float:
        """Return the mean torque [N m] in its positive direction that it needs of ``node``; none for most."""
        return 0.0
