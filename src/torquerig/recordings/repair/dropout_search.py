"""Rounded dropouts of a recording that comes in blocks, by stretches of some minutes, so that memory stays flat."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.repair.lost_moments import RoundedDropouts
from torquerig.recordings.repair.rounded_dropouts import block_of, rounded_dropouts

Floats = NDArray[np.float64]

_STRETCH = 120.0  # [s] that are looked at together, up to twice as many at the end
_OVERLAP = 0.5  # [s] of a stretch that the next one begins with


@dataclass
class DropoutSearch:
    """Takes a channel's blocks in their order and holds no more than four minutes of block means.

    Parameters
    ----------
    rate : float
        Of the samples [Hz].
    """

    rate: float
    _rest: Floats = field(default_factory=lambda: np.empty(0))
    _means: Floats = field(default_factory=lambda: np.empty(0))
    _first: int = 0  # number of the first mean held
    _found: RoundedDropouts | None = None

    def add(self, values: Floats) -> None:
        """Take the next samples, shape (samples,); what are no numbers are bridged."""
        finite = np.isfinite(values)
        if not finite.all():
            known = np.flatnonzero(finite)
            if not known.size:
                return self._skip(values.size)
            values = np.interp(np.arange(values.size), known, values[known])
        values, block = np.concatenate([self._rest, values]), block_of(self.rate)
        count = values.size // block
        self._rest = values[count * block :].copy()
        self._means = np.concatenate([self._means, values[: count * block].reshape(count, block).mean(axis=1)])
        while self._means.size > 2 * _STRETCH * self._rate:
            self._look(round(_STRETCH * self._rate), round(_OVERLAP * self._rate))
        return None

    def found(self) -> RoundedDropouts | None:
        """Return the dropouts of all that was taken; nothing can be taken after that."""
        self._look(self._means.size, 0)
        return self._found

    @property
    def _rate(self) -> float:
        return self.rate / block_of(self.rate)

    def _skip(self, samples: int) -> None:
        level = self._means[-1] if self._means.size else 0.0
        self.add(np.full(samples, level))

    def _look(self, size: int, overlap: int) -> None:
        found = rounded_dropouts(self._means[:size], self._rate)
        if found is not None:
            limit = (size - 0.5 * overlap) / self._rate if overlap else inf
            self._found = joined_dropouts(self._found, found.within(0.0, limit).later(self._first / self._rate))
        self._means = self._means[size - overlap :].copy()
        self._first += size - overlap


def joined_dropouts(first: RoundedDropouts | None, last: RoundedDropouts) -> RoundedDropouts:
    """Return the dropouts of two stretches together; those that both hold count once."""
    if first is None:
        return last
    new = [index for index, start in enumerate(last.starts) if start > first.starts[-1] + first.lengths[-1]]
    return replace(
        first if len(first.starts) >= len(last.starts) else last,
        starts=(*first.starts, *(last.starts[index] for index in new)),
        lengths=(*first.lengths, *(last.lengths[index] for index in new)),
        length=(min(first.length[0], last.length[0]), max(first.length[1], last.length[1])),
    )
