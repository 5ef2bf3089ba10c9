"""Changes of the amplitudes of lines: orders of the shafts, and fixed frequencies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

import numpy as np

from torquerig.metrics.changes.change import CONFIDENCE, FALSE_ALARMS, Change
from torquerig.metrics.changes.intervals import difference_of_roots, line_square, sure_difference_of_roots
from torquerig.metrics.changes.segments import Segments, powers_and_noise

_APART = 2.0  # [bins] of a segment: nearer lines are one
LOWEST = 3.0  # [bins] of a segment: below, the slow load and the removed slope cover a line


def merged(places: Sequence[tuple[float, str]], *, width: float, lowest: float, highest: float) -> dict[float, str]:
    """Return rising places at least ``width`` apart, each with the causes of those that are one with it.

    A place with a known cause goes before one without: its order is exact.
    """
    kept: dict[float, list[str]] = {}
    for place, label in sorted(places, key=lambda one: (not one[1], one[0])):
        if not lowest <= place <= highest:
            continue
        near = min(kept, key=lambda one: abs(one - place), default=None)
        if near is not None and abs(near - place) < width:
            kept[near] += [label] if label and label not in kept[near] else []
        else:
            kept[place] = [label] if label else []
    return {place: " or ".join(kept[place]) for place in sorted(kept)}


def line_changes(
    before: Segments, after: Segments, places: Mapping[float, str], *, kind: Literal["order", "frequency"]
) -> tuple[Change, ...]:
    """Return the change of each line, at the places with their causes; the recordings have one axis."""
    if not places:
        return ()
    at = np.array(list(places))
    powers = [powers_and_noise(one, at) for one in (before, after)]
    each = FALSE_ALARMS / at.size
    made = []
    for number, (place, cause) in enumerate(places.items()):
        squares = [line_square(power[:, number], float(noise[number])) for power, noise in powers]
        difference, low, high = sure_difference_of_roots(squares[0], squares[1], level=CONFIDENCE)
        _, seen_low, seen_high = difference_of_roots(squares[0], squares[1], level=each)
        made.append(
            Change(
                kind=kind, at=place, until=place, cause=cause, before=squares[0].root(), after=squares[1].root(),
                difference=difference, low=low, high=high, seen_low=seen_low, seen_high=seen_high,
            )
        )  # fmt: skip
    return tuple(made)
