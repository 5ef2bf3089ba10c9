"""Flat tops: a reading that stops at a limit piles up there, and nothing passes it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording

FLAT_SHARE, FEWEST_FLAT = 2e-4, 20
_LOWEST_LIMIT = 4.0  # codes: a signal that stops nearer to zero holds nothing
_FEW = 6  # values, of which none can be spared
_ASIDE, _EXACT = 4.0, 0.005  # times what the others are off at most; of a code, that none is exact beyond
_PILED, _THINNER, _TAIL_OF = 1.2, 0.85, 3  # of the code before it; code by code, over so many steps


@dataclass(frozen=True)
class FlatTops:
    """Values that never pass ``limit`` [V] and stop at it in ``share`` of the samples of the worst run."""

    limit: float
    share: float
    runs: tuple[str, ...]

    @classmethod
    def of_runs(cls, found: Mapping[str, tuple[float, float]]) -> FlatTops:
        """Return what the runs tell together, each by its level [V] and share; one or more."""
        limit = float(np.median([level for level, _ in found.values()]))
        return cls(limit, max(share for _, share in found.values()), tuple(found))


def flat_tops(
    recordings: Sequence[Recording], *, full_range: float, code: float, coarse: bool = False
) -> FlatTops | None:
    """Return the level at which the signal stops, where the samples pile up at their largest magnitude.

    A tail thins out towards its end; a limit leaves more samples on its last code than on the codes before it. Where
    codes are coarse a few of them hold the whole tail, and it is enough that this thins out from code to code and the
    last one holds more again: the end of a tone, which does too, does not thin out before. It is enough, too, that the
    last value alone is on no code.

    Parameters
    ----------
    full_range : float
        Of the converter [V]: what stops there, or on the last code below it, is the converter's own limit.
    code : float
        Distance of two codes of the samples [V].
    coarse : bool
        Whether they are wider than the converter's own.
    """
    found: dict[str, tuple[float, float]] = {}
    for recording in recordings:
        volts = recording.torque_values()
        for sign in (1.0, -1.0):
            depth = np.abs(sign * volts - (sign * volts).max())
            piled, *before = (
                int(((depth >= (at - 0.5) * code) & (depth < (at + 0.5) * code)).sum()) for at in range(6)
            )
            level = float((sign * volts).max())
            largest = level > max(float(np.abs(volts).max()) - 0.5 * code, _LOWEST_LIMIT * code)
            ends = piled >= 2 * sum(before) or (
                coarse and (_thins_out_before(piled, before) or _on_no_code(sign * volts, code))
            )
            if largest and ends and piled >= max(FEWEST_FLAT, FLAT_SHARE * volts.size):
                found[recording.name] = (level, piled / volts.size)
    if not found or max(level for level, _ in found.values()) > min(0.999 * full_range, full_range - 0.5 * code):
        return None
    return FlatTops.of_runs(found)


def _on_no_code(volts: NDArray[np.float64], code: float) -> bool:
    """Whether the largest value is off the codes by far more than any other one, the smallest left aside."""
    values = np.unique(volts)
    off = np.abs(values / code - np.round(values / code))
    return bool(values.size > _FEW and off[-1] > _ASIDE * max(float(off[1:-1].max()), _EXACT))


def _thins_out_before(piled: int, before: Sequence[int]) -> bool:
    """Whether each of the codes before the last, the nearest first, holds clearly less than its next, and that more."""
    return piled > _PILED * before[0] and all(
        near < _THINNER * next_one for near, next_one in pairwise(before[: _TAIL_OF + 1])
    )
