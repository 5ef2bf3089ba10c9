"""Blocks of a run: pieces in which the speed hardly changes, each either fitted or held out."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

SPEED_RANGE = 0.08  # [1] of the speed: a transfer function hardly changes over so little
STANDSTILL = 0.01  # [1] of the largest speed of the run: a slower motor is taken to stand still
MOST_SWEPT = 48  # of a run whose speed changes: in blocks an eighth as long as those at one speed a band still has bins
MOST = 6  # blocks of a run at one speed: long enough to separate neighbouring lines, a third of them held out


@dataclass(frozen=True)
class Block:
    """Samples ``start`` to ``stop`` (not included) of a run; a ``held_out`` one is used only to judge a model."""

    start: int
    stop: int
    held_out: bool

    @property
    def samples(self) -> slice:
        """The samples of the block."""
        return slice(self.start, self.stop)


def blocks_of(speed: Floats) -> tuple[Block, ...]:
    """Return the blocks of a run whose motor turns at ``speed`` [rad/s], shape (samples,).

    A block ends where the speed has changed by the share ``SPEED_RANGE``, but there are no more than ``MOST_SWEPT``; of
    a run at one speed there are ``MOST``. Every third block is held out: whatever changes during a run is then in
    fitted and in held-out blocks alike.
    """
    size = speed.size
    longest = max(int(np.ceil(size / MOST)), 1)
    shortest = min(max(size // MOST_SWEPT, 2), longest)
    least = STANDSTILL * max(float(np.abs(speed).max(initial=0.0)), 1e-12)
    coarse = max(shortest // 8, 1)
    edges, low, high = [0], float("inf"), -float("inf")
    for at in range(0, size, coarse):
        low, high = min(low, float(speed[at])), max(high, float(speed[at]))
        length = at - edges[-1]
        if length >= longest or (length >= shortest and high - low > permitted_range(max(abs(low), abs(high)), least)):
            edges.append(at)
            low = high = float(speed[at])
    if len(edges) > 1 and size - edges[-1] < shortest:
        edges.pop()
    edges.append(size)
    return tuple(Block(start, stop, index % 3 == 1) for index, (start, stop) in enumerate(pairwise(edges)))


def permitted_range(speed: float, least: float) -> float:
    """Return by how much the speed may change within a block [rad/s]; ``least`` is that of a motor at rest."""
    return max(SPEED_RANGE * speed, least)
