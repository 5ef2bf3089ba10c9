"""The randomness of the load in the reading errors of a study, apart from what is open in the catalog."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.metrics.random_error import length_for

if TYPE_CHECKING:
    from torquerig.study.results import DriveResult

WANTED = 0.01  # [1] standard error that the sentence names a record length for


@dataclass(frozen=True, kw_only=True)
class LoadRandomness:
    """Relative standard errors of the reading errors by the random load.

    Parameters
    ----------
    low, high : float
        The smallest and the largest among all drives and filters [1].
    duration : float
        Length of the record [s].
    """

    low: float
    high: float
    duration: float

    def sentence(self) -> str:
        """Return the randomness, and the record that makes it small."""
        ends = (
            f"{100 * self.low:.1f} to {100 * self.high:.1f} %" if self.low < self.high else f"{100 * self.high:.1f} %"
        )
        longer = float(f"{length_for(WANTED, now=self.high, length=self.duration):.2g}")
        return (
            f"The load is random: over {self.duration:g} s the reading errors are uncertain by {ends} of their value "
            f"(one standard deviation, from {self.duration / 10:g} s blocks), in common for all drives, which have the "
            f"same load. Data sheets do not lower this; a record of {longer:g} s reaches {100 * WANTED:g} %."
        )


def load_randomness(drives: Iterable[DriveResult]) -> LoadRandomness | None:
    """Return the randomness over all drives and filters; None where the records are too short to tell it."""
    shares, duration = [], 0.0
    for drive in drives:
        for chain in drive.chains.values():
            value = chain.truth_error.value
            if chain.random_error and value:
                shares.append(chain.random_error / value)
        duration = max(duration, drive.duration)
    if not shares:
        return None
    return LoadRandomness(low=min(shares), high=max(shares), duration=duration)
