"""How much of what a filter chain keeps, and of what it removes, is load."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.filters.evaluation.delay import delay_behind
from torquerig.metrics.truth_error import true_load

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class LoadShares:
    """Shares of variance that are the load, by the squared correlation at the best delay [1].

    Parameters
    ----------
    before, after, removed : float or None
        Of the reading, of the filtered reading, and of their difference; None where that is constant.
    """

    before: float | None
    after: float | None
    removed: float | None


def load_shares(before: Recording, after: Recording, *, longest: float) -> LoadShares | None:
    """Return the shares of the load in ``before``, ``after`` and their difference; None where no load is known.

    Parameters
    ----------
    longest : float
        Longest delay that is searched [s].

    Notes
    -----
    The squared correlation is the share of the variance that a line through the load explains. Load that the shafts
    amplify or that reaches the sensor in another form counts as no load.
    """
    load = true_load(before)
    if load is None or load.size < 8:
        return None
    rate = before.sample_rate
    kept, read = after.torque(), before.torque()
    found = [delay_behind(one, load, rate=rate, longest=longest) for one in (read, kept, read - kept)]
    shares = [None if one is None else max(one.correlation, 0.0) ** 2 for one in found]
    return LoadShares(before=shares[0], after=shares[1], removed=shares[2])
