"""Lines that are many multiples of one order: what impacts without slip make, and no lines of their own."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.peaks import Peak

_FEWEST = 6  # lines in a row that make a comb
_HIGH = 8  # multiple from which on teeth and blades have none
_MOST = 0.6  # of all lines that must belong to it
_BESIDE, _WITNESSES = 3, 2  # multiples to both sides, and how many of them must be there
_HIGHER = (
    4.0  # times as much power over the floor as the highest of them: the lines of combs scatter by a factor of two
)
_NEAR = 0.08  # of the spacing by which a line may miss its multiple


def without_comb(peaks: Sequence[Peak]) -> tuple[Peak, ...]:
    """Return the peaks that are no multiples of one order; all of them where fewer than six in a row are high ones.

    The lines of impacts crowd where their mode rings, at high multiples of their order; as lines of their own they
    would leave nothing of the ringing in the spectrum between. One that stands high above its neighbours is another's,
    which the comb happens to meet, or whose side lines the comb is made of: it stays.
    """
    orders = np.array(sorted(peak.place.at for peak in peaks if peak.place.domain == "order"))
    if orders.size < _FEWEST:
        return tuple(peaks)
    spacing = _spacing(orders)
    if spacing is None:
        return tuple(peaks)
    comb = [
        peak
        for peak in peaks
        if peak.place.domain == "order" and _is_multiple(np.array([peak.place.at]), spacing, lowest=1)[0]
    ]
    its = [peak for peak in comb if not _towers(peak, comb, spacing)]
    return tuple(peak for peak in peaks if peak not in its)


def _towers(peak: Peak, comb: Sequence[Peak], spacing: float) -> bool:
    """Whether a line of a comb stands high above those next to it, which a mode that rings would raise as well."""
    apart = [(abs(round((other.place.at - peak.place.at) / spacing)), other.excess) for other in comb]
    beside = [excess for steps, excess in apart if 0 < steps <= _BESIDE]
    return len(beside) >= _WITNESSES and peak.excess > _HIGHER * max(beside)


def _spacing(orders: NDArray[np.float64]) -> float | None:
    """Return the order of which most of ``orders`` are high multiples, fitted to them, or None."""
    best, most = None, 0
    for difference in sorted(set(np.round(np.diff(orders), 3).tolist())):
        if difference <= 0.02:
            continue
        spacing = _fitted(orders, difference)
        high = _is_multiple(orders, spacing, lowest=_HIGH)
        hits = _longest_run(np.round(orders[high] / spacing))
        if hits >= _FEWEST and hits > most and high.sum() > _MOST * orders.size:
            best, most = spacing, hits
    return best


def _longest_run(multiples: NDArray[np.float64]) -> int:
    """Return how many multiples follow one another: side lines of teeth stand in threes and fives."""
    breaks = np.flatnonzero(np.diff(np.unique(multiples)) > 1)
    edges = np.concatenate([[-1], breaks, [np.unique(multiples).size - 1]])
    return int(np.diff(edges).max(initial=0))


def _fitted(orders: NDArray[np.float64], spacing: float) -> float:
    """Return the spacing that the lines agree on, the near ones asked first."""
    start = orders[0]
    for reach in (4.0, 12.0, 40.0, np.inf):
        steps = np.round((orders - start) / spacing)
        near = (np.abs(orders - start - steps * spacing) < 0.2 * spacing) & (orders - start < reach * spacing)
        if np.unique(steps[near]).size > 1:
            slope = float(np.polyfit(steps[near], orders[near], 1)[0])
            spacing = slope if 0.8 < slope / spacing < 1.25 else spacing
    multiples = np.maximum(np.round(orders / spacing), 1)
    close = np.abs(orders - multiples * spacing) < 0.3 * spacing
    return float(np.median(orders[close] / multiples[close])) if close.any() else spacing


def _is_multiple(orders: NDArray[np.float64], spacing: float, *, lowest: int) -> NDArray[np.bool_]:
    multiples = np.round(orders / spacing)
    return np.asarray((multiples >= lowest) & (np.abs(orders - multiples * spacing) < _NEAR * spacing))
