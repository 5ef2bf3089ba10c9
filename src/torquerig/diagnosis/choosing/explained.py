"""How much of what a model missed an effect explains, at the very places where it changes something."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.fitting.misfit import Misfit, robust_squares
from torquerig.diagnosis.judging.share_explained import CHANGED, share_explained

LARGEST_REST = 6.0  # mean square left at an effect's places above which no name is given ...
HARDLY_ANY = 0.04  # ... unless it is so little of what was missed there: no stand-in comes as near
_FEW = 5
_SLOW_PART = 0.05  # of all that an effect takes away, below which the slow torque is not what it was taken for
LEAST_SHARE_WHERE_ALL_FITS = 0.6  # what is left may be chance where nothing else stands out


def explained_share(
    before: Sequence[Misfit], after: Sequence[Misfit], *, beside: tuple[float, float] = (0.0, 0.0)
) -> float:
    """Return 1 - (excess misfit left) / (excess misfit before) over the features that the effect changes.

    An effect that is there explains its places down to chance; one that only resembles what is there leaves a rest.
    ``beside`` are misfits before and after of what no feature holds.
    """
    return share_explained(_squares(before), _squares(after), beside=beside)


def changes_places(before: Sequence[Misfit], after: Sequence[Misfit]) -> bool:
    """Whether the robust square of any feature falls clearly."""
    return bool(np.any(_squares(before) - _squares(after) > CHANGED))


def gained_at_its_places(before: Sequence[Misfit], with_it: Sequence[Misfit], with_other: Sequence[Misfit]) -> float:
    """Return by how much the robust squares fall with another effect at the features that an effect changes."""
    old, new, other = map(_squares, (before, with_it, with_other))
    return float((old - other)[old - new > CHANGED].sum())


def left_at_its_places(before: Sequence[Misfit], with_it: Sequence[Misfit], final: Sequence[Misfit]) -> float:
    """Return the mean robust square that the final model leaves at the features that the effect changed, 1 by chance.

    Large where an effect took what it could of something else, and nothing found since took the rest. Only the slow
    torque counts: a few large lines and the bands beside them miss by what no model of a strong line gets right. Fewer
    than five features count as five, the others as right: an effect of lines changes one or two of the slow torque. One
    whose lines and bands gained nearly all owes nothing to the slow torque, and answers for none of it: 0.
    """
    old, new, rest = (_squares([misfit.slow() for misfit in each]) for each in (before, with_it, final))
    place = old - new > CHANGED
    if float((old - new)[place].sum()) < _SLOW_PART * _taken_away(before, with_it):
        return 0.0
    return float(rest[place].sum()) / max(int(place.sum()), _FEW)


def _taken_away(before: Sequence[Misfit], after: Sequence[Misfit]) -> float:
    """Return by how much the robust squares of all features fell where they fell."""
    return float(np.maximum(_squares(before) - _squares(after), 0.0).sum())


def _squares(misfits: Sequence[Misfit]) -> NDArray[np.float64]:
    """Return the robust squares of all features of all runs in one row."""
    return np.concatenate([robust_squares(misfit.all()) for misfit in misfits])
