"""Lines where two of the rig's own meet: a shaft that is no straight spring makes such of them."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import SAME_ORDER, Place

_OF_THE_MOTOR = frozenset({"commutation_ripple", "cogging"})
_MOST = 0.5  # of the runs that show the line and two others


def may_be_combined(case: Case, left: Sequence[Mismatch], found: Sequence[Candidate]) -> bool:
    """Whether every line that was found may be made of two of the rig's own by something that bends.

    What is not straight makes, of lines at the orders n and m, others at n + m, n - m and 2 n; they are smaller than
    either (Nayfeh & Mook 1979, Nonlinear Oscillations, ch. 4: combination tones). It changes the spectrum as well:
    where only times are wrong it is not asked. Where a motor's currents, slots and poles have lines anyway, they are
    theirs.

    Parameters
    ----------
    case : Case
        The runs that it has seen tell the sizes.
    left : sequence of Mismatch
        Where the case's model is still wrong.
    found : sequence of Candidate
        What was found.
    """
    places = [each.place for each in found if each.place is not None]
    own = any(each.mechanism in _OF_THE_MOTOR and each.price == 0 for each in found)
    bends = any(mismatch.domain in ("frequency", "order") for mismatch in left)
    return bends and bool(places) and not own and all(_may_be(case, place) for place in places)


def _may_be(case: Case, place: Place) -> bool:
    judged = [told for told in (_in_run(features, place) for features in case.seen) if told is not None]
    return bool(judged) and sum(judged) > _MOST * len(judged)


def _in_run(features: Features, place: Place) -> bool | None:
    """Whether two lines whose orders sum up to it are larger in a run; None where the run shows no line."""
    if place not in features.places or features.turning is not None or not features.stretches:
        return None
    size = _sizes(features)
    own = [
        column
        for column, each in enumerate(features.places)
        if each.domain == "order" and each not in features.unknown and np.isfinite(size[column])
    ]
    mine = size[features.places.index(place)]
    larger = [features.places[column].at for column in own if size[column] > mine]
    return None if not np.isfinite(mine) else any(
        abs(abs(one + sign * other) - place.at) < SAME_ORDER
        for one, other in combinations_with_replacement(larger, 2)
        for sign in (1, -1)
    )  # fmt: skip


def _sizes(features: Features) -> NDArray[np.float64]:
    """Return the root mean square of each line over the stretches that show it [N m], NaN where none does."""
    shown = np.isfinite(features.amplitude)
    squares = np.where(shown, np.abs(features.amplitude) ** 2, 0.0).sum(axis=0)
    count = shown.sum(axis=0)
    return np.asarray(np.where(count > 0, np.sqrt(squares / np.maximum(count, 1)), np.nan))
