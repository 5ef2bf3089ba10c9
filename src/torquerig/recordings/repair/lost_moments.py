"""What is known of dropouts behind a low-pass: their level, when, how long, and the low-pass."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from torquerig.recordings.repair.faults import in_words
from torquerig.recordings.repair.pulse_behind_low_pass import LowPass

_SEEN = 1200.0  # [Hz] up to which a low-pass is told from none
_BEFORE = 0.0004  # [s] by which a start may be late


@dataclass(frozen=True)
class RoundedDropouts:
    """Moments without signal behind a low-pass.

    Parameters
    ----------
    level : float
        To which the signal falls, in its unit.
    starts, lengths : tuple of float
        Of each before the low-pass [s].
    length : tuple of float
        The least and the greatest median length that fits about as well [s].
    low_pass : LowPass
    clear : float
        How far the level is from the neighbourhood, in robust standard deviations of that.
    """

    level: float
    starts: tuple[float, ...]
    lengths: tuple[float, ...]
    length: tuple[float, float]
    low_pass: LowPass
    clear: float

    @property
    def median_length(self) -> float:
        """The median length [s]."""
        return float(np.median(self.lengths))

    def within(self, first: float, limit: float) -> RoundedDropouts:
        """Return those that begin from a time to before another [s], at times counted from the first."""
        kept = [index for index, start in enumerate(self.starts) if first <= start < limit]
        starts, lengths = ([each[index] for index in kept] for each in (self.starts, self.lengths))
        return replace(self, starts=tuple(start - first for start in starts), lengths=tuple(lengths))

    def later(self, shift: float) -> RoundedDropouts:
        """Return them at times that are later by so much [s]."""
        return replace(self, starts=tuple(start + shift for start in self.starts))

    def moments(self, rate: float, samples: int) -> list[tuple[int, int]]:
        """Return the first sample and one past the last that each spoils, until the low-pass has settled."""
        tail = _BEFORE + self.low_pass.settling
        found = [
            (int((start - _BEFORE) * rate), int(np.ceil((start + length + tail) * rate)))
            for start, length in zip(self.starts, self.lengths, strict=True)
        ]
        return [(max(start, 0), min(stop, samples)) for start, stop in found]

    def sentence(self, name: str, unit: str) -> str:
        """Return in one sentence how often a channel falls to which level, for how long, and when."""
        count, cutoff = len(self.starts), self.low_pass.cutoff
        low, high = (1e3 * length for length in self.length)
        edges = f"rounded by a low-pass near {cutoff:.2g} Hz" if cutoff < _SEEN else "sharp"
        return (
            f"{name} falls to {self.level:.3g} {unit} and comes back {count} time{'s' * (count != 1)}, for "
            f"{1e3 * self.median_length:.3g} ms ({low:.2g} to {high:.2g} ms) in the median, its edges {edges}: at "
            f"{in_words(self.starts)}"
        )
