"""One gearbox, speed loop and filter that was tried, and which of them no other beats."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf


@dataclass(frozen=True, kw_only=True)
class Tried:
    """One choice with its figures.

    Parameters
    ----------
    drive, filtering : str
        Names of the candidate and of its filter.
    crossover, integral_corner : float
        Of the speed loop [Hz].
    error : float
        Rms of the filtered reading minus the true load [N m].
    delay : float or None
        Of a slow load behind the filter [s]; None for a filter that needs the whole recording.
    price : float or None
        Of all new parts [EUR]; None where it is unknown.
    margin : float
        Least distance of the loop gain from -1 [1].
    settings : tuple of str
        Numbers of the filter that were varied: ``cutoff 12.3 Hz``.
    """

    drive: str
    filtering: str
    crossover: float
    integral_corner: float
    error: float
    delay: float | None
    price: float | None
    margin: float
    settings: tuple[str, ...] = ()

    @property
    def set_filter(self) -> str:
        """The filter with the numbers that were varied: ``low_pass_20Hz (cutoff 12.3 Hz)``."""
        return f"{self.filtering} ({', '.join(self.settings)})" if self.settings else self.filtering

    @property
    def figures(self) -> tuple[float, float, float]:
        """Error, delay and price; what is not known or needs the whole recording counts as infinite."""
        return self.error, inf if self.delay is None else self.delay, inf if self.price is None else self.price


def front(tried: Sequence[Tried], *, same: float = 0.01) -> tuple[Tried, ...]:
    """Return the choices that no other is at least as good as in every figure, by rising error.

    Of choices with one delay and price only that of the least error is there; errors within ``same`` of each other
    [1] count as equal, so that a dearer or slower choice must be better by more than that.
    """
    best: dict[tuple[float, float], Tried] = {}
    for one in sorted(tried, key=lambda one: one.error):
        best.setdefault(one.figures[1:], one)
    kept = [
        one
        for one in best.values()
        if not any(_as_good(other, one, same) for other in best.values() if other is not one)
    ]
    return tuple(sorted(kept, key=lambda one: one.error))


def _as_good(other: Tried, one: Tried, same: float) -> bool:
    """Return whether ``other`` is as good as ``one`` in all figures, and better in one of them."""
    pairs = list(zip(other.figures[1:], one.figures[1:], strict=True))
    if other.error > one.error * (1 + same) or any(first > second for first, second in pairs):
        return False
    return any(first < second for first, second in pairs) or other.error < one.error
