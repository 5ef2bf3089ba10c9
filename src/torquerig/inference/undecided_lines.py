"""Lines of which the runs do not say whether they are orders or frequencies: both are proposed.

At one speed an order and a frequency are the same line. Evidence and priors then decide between hum and a torque at an
order, as they do between any two hypotheses.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

import numpy as np

from torquerig.inference.features.line_places import SEPARATE
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.places import Place


def in_both_domains(lines: Sequence[FoundLine], seen: Sequence[RunFeatures]) -> tuple[FoundLine, ...]:
    """Return the lines and, after them, those that may be in the other domain as well, there.

    Their place is the one that the search found there: a speed that is known to 0.03 % would put a tone off by more
    than a clear one permits.
    """
    return (*lines, *(other for line in lines for other in _in_other_domain(line, seen)))


def _in_other_domain(line: FoundLine, seen: Sequence[RunFeatures]) -> Iterator[FoundLine]:
    turning = line.place.domain == "order"
    own = [each for each in seen if each.segments]  # a segment of a changing speed has several speeds
    speed = np.abs(np.concatenate([each.speeds.ravel() for each in own] or [np.zeros(0)])) / (2 * pi)
    duration = np.concatenate([np.repeat(each.durations, each.speeds.shape[1]) for each in own] or [np.zeros(0)])
    if not speed.size or not speed.all():
        return
    at = line.place.at * speed if turning else line.place.at / speed
    middle = float(at.mean())
    apart = np.abs(at - middle) * (1.0 if turning else speed)
    if (apart * duration).max() < 0.5 * SEPARATE:
        place = line.other_place or Place("frequency" if turning else "order", float(f"{middle:.9g}"))
        yield FoundLine(place, line.other_domain or line.log_p, line.log_p, line.place)


def column_of(seen: RunFeatures, place: Place) -> int:
    """Return the index of a place in a run; of one that no segment separates from another, the index of that one."""
    at, shown = seen.places.index(place), seen.lines.count > 0
    if not seen.segments or shown[:, at].any():
        return at
    apart = np.abs(seen.line_frequency - seen.line_frequency[:, at : at + 1]) * seen.durations[:, None]  # [bins]
    most = np.where(shown, apart, np.inf).max(axis=0)
    nearest = int(np.argmin(most))
    return nearest if most[nearest] < SEPARATE else at
