"""How often the outermost values of a signal come: a signal that is clipped rests on them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.runs import runs_of


@dataclass(frozen=True, kw_only=True)
class Extreme:
    """The highest value of a stretch, how often it comes and at most in a row, and how often the next one below.

    The lowest value is the highest of the signal turned over.
    """

    value: float
    count: int
    in_a_row: int
    next_value: float
    next_count: int

    @property
    def clipped(self) -> int:
        """The samples on the value where that looks like clipping, else 0.

        Three times in a row or more, and more than twice as often as the next value (an honest converter's counts fall
        off towards the extremes).
        """
        return self.count if self.in_a_row >= 3 and self.count > 2 * self.next_count else 0


def extreme_of(values: NDArray[np.float64]) -> Extreme:
    """Return the extreme of ``values``, shape (samples,), without NaN; one sample or more."""
    value = float(values.max())
    on_it = values == value
    inside = values[~on_it]
    neighbour = float(inside.max()) if inside.size else float("-inf")
    return Extreme(
        value=value,
        count=int(np.count_nonzero(on_it)),
        in_a_row=max(length for _, length in runs_of(on_it)),
        next_value=neighbour,
        next_count=int(np.count_nonzero(inside == neighbour)),
    )


def joined_extremes(left: Extreme, right: Extreme) -> Extreme:
    """Return the extreme of two stretches; a run over the seam counts as two."""
    high, low = (left, right) if left.value >= right.value else (right, left)
    if high.value == low.value:
        beside = max(high.next_value, low.next_value)
        return Extreme(
            value=high.value,
            count=high.count + low.count,
            in_a_row=max(high.in_a_row, low.in_a_row),
            next_value=beside,
            next_count=sum(one.next_count for one in (high, low) if one.next_value == beside),
        )
    beside = max(high.next_value, low.value)
    counts = high.next_count * (high.next_value == beside) + low.count * (low.value == beside)
    return Extreme(value=high.value, count=high.count, in_a_row=high.in_a_row, next_value=beside, next_count=counts)
