"""A fitted model with what was added to the nominal rig."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.inference.addition import Addition
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.fit import Fit


@dataclass(frozen=True, eq=False)
class Model:
    """A fitted model with what was added to the nominal rig.

    Parameters
    ----------
    fit : Fit
    additions : tuple of Addition
    lines : tuple of FoundLine
        That no part explains.
    alternatives : tuple of (Addition, Addition, float)
        What was added, what was fitted in its place, and by how many nats of posterior odds that fell short.
    tried : tuple of (Addition, float)
        Proposals of the last round, and the gain of posterior odds [nats] that the local model promises for each.
    refuted : tuple of Addition
        Mechanisms that leave much of the features that they should explain.
    """

    fit: Fit
    additions: tuple[Addition, ...]
    lines: tuple[FoundLine, ...]
    alternatives: tuple[tuple[Addition, Addition, float], ...] = ()
    tried: tuple[tuple[Addition, float], ...] = ()
    refuted: tuple[Addition, ...] = ()

    @property
    def log_odds(self) -> float:
        """Log-evidence plus the prior odds of the additions [nats]."""
        return self.fit.log_evidence + sum(each.log_odds for each in self.additions)
