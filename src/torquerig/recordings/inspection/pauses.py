"""Pauses of a recording: where its times jump by many samples, and how long it records between two of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from torquerig.recordings.files.gaps import FEWEST_SAMPLES, Gap


@dataclass(frozen=True, kw_only=True)
class Pauses:
    """The pauses of a recording.

    Parameters
    ----------
    count : int
    shortest, longest, total : float
        Of the steps from the last time before to the first time after a pause [s].
    stretches : tuple of float
        Shortest and longest time that is recorded without a pause [s].
    """

    count: int
    shortest: float
    longest: float
    total: float
    stretches: tuple[float, float]

    def sentence(self, name: str) -> str:
        """Return number and length of the pauses of the times ``name``, and what to do about them."""
        steps = f"{self.shortest:.4g} to {self.longest:.4g} s" if self.count > 1 else f"{self.longest:.4g} s"
        low, high = self.stretches
        return (
            f"{name} has {self.count} pause{'s' * (self.count > 1)} of {steps}, {self.total:.4g} s in all, between "
            f"stretches of {low:.3g} to {high:.3g} s; 'torquerig join --bridge TIME' fills pauses in which nothing "
            "moves, 'torquerig join --split' writes each stretch"
        )


def pauses_of(gaps: Sequence[Gap], *, rate: float, samples: int) -> Pauses | None:
    """Return the pauses among the jumps of time, None where there is none.

    Parameters
    ----------
    gaps : sequence of Gap
        All jumps, in the order of the samples.
    rate : float
        Within the stretches [Hz].
    samples : int
        Of the recording.
    """
    long = [gap for gap in gaps if gap.step * rate >= FEWEST_SAMPLES]
    if not long:
        return None
    steps = [gap.step for gap in long]
    ends = [-1, *(gap.sample for gap in long), samples - 1]
    lengths = [(last - first) / rate for first, last in pairwise(ends)]
    return Pauses(
        count=len(long),
        shortest=min(steps),
        longest=max(steps),
        total=sum(steps),
        stretches=(min(lengths), max(lengths)),
    )


def time_span(gaps: Sequence[Gap], *, rate: float, samples: int) -> float:
    """Return the time from the first to the last sample and one sample more [s], pauses and other jumps included."""
    return samples / rate + sum(gap.step - 1 / rate for gap in gaps)
