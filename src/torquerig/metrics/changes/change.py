"""One change between two recordings: its size with interval, and whether it exceeds the random error."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["order", "frequency", "band", "mean"]
CONFIDENCE = 0.05
"""Probability that the reported interval of a change misses the true one."""
FALSE_ALARMS = 0.01
"""Probability of one or more false changes in a pair of recordings of an unchanged rig, over all tests of one kind."""


@dataclass(frozen=True, kw_only=True)
class Change:
    """A quantity before and after.

    Parameters
    ----------
    kind : str
        ``order`` (a line over the turns of the output shaft), ``frequency`` (a line of fixed frequency), ``band`` (rms
        without the lines), ``mean``.
    at : float
        The order [1/rev], the frequency or the lower end of the band [Hz]; 0 for the mean.
    until : float
        The upper end of the band [Hz]; ``at`` for others.
    cause : str
        What is known to have this line; empty where nothing is.
    frequency : float or None
        Of an order at the speed of both recordings, where that is one constant speed: orders and fixed frequencies are
        then one and the same [Hz].
    before, after : float
        Amplitude of a line (zero to peak), rms of a band, mean; in the unit of the channel.
    difference, low, high : float
        After minus before, and its 95 % interval.
    seen_low, seen_high : float
        The wider interval that all tests of one kind need together; a change is one where it does not hold 0.
    """

    kind: Kind
    at: float
    until: float
    cause: str
    before: float
    after: float
    difference: float
    low: float
    high: float
    seen_low: float
    seen_high: float
    frequency: float | None = None

    @property
    def is_change(self) -> bool:
        """Whether the difference exceeds the random error of both recordings."""
        return self.seen_low > 0 or self.seen_high < 0

    @property
    def random_error(self) -> float:
        """The difference that an unchanged rig may show: half the width of the wider interval."""
        return float(max(self.seen_high - self.difference, self.difference - self.seen_low))

    @property
    def smallest_seen(self) -> float:
        """The smallest change that is surely seen: twice the random error, for that of the changed pair is as large."""
        return 2 * self.random_error

    @property
    def percent(self) -> float | None:
        """The difference relative to what was there before [%]; None where that is not more than its random error."""
        return 100 * self.difference / abs(self.before) if abs(self.before) > self.random_error else None
