"""The loop over eight similar rigs at once, one in each lane of the vector registers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod
from typing import Any

import numpy as np
from numba import njit

from torquerig.simulation.arrays import Floats, Outputs
from torquerig.simulation.kernel.fast import FAST, UNCOUNTED
from torquerig.simulation.kernel.lanes import LANES, in_lanes
from torquerig.simulation.kernel.loop import advance
from torquerig.simulation.kernel.sources import sources_key
from torquerig.simulation.kernel.work import work_for
from torquerig.simulation.term_kinds import Terms


def _built(key: int) -> Callable[..., Any]:
    """Return the compiled loop over lanes; ``key`` is closed over so that the cache on disk is keyed by it."""

    @njit(cache=True, nogil=True, fastmath=FAST, **UNCOUNTED)
    def advance_together(theta, omega, terms, outputs, rate, settling, substeps, kept, work, last):
        if key < 0:  # never: it is named here to be closed over
            return -1, -1
        theta_, omega_, terms_, work_ = in_lanes(theta), in_lanes(omega), in_lanes(terms), in_lanes(work)
        return advance(theta_, omega_, terms_, outputs, rate, settling, substeps, kept, work_, 0, last)

    return advance_together


advance_together = _built(sources_key())


def integrate_together(
    theta: Sequence[Floats],
    omega: Sequence[Floats],
    terms: Sequence[Terms],
    outputs: Outputs,
    rate: float,
    settling: int,
    substeps: int,
    samples: int,
) -> tuple[Floats, bool]:
    """Step up to ``LANES`` rigs of one structure together.

    Parameters
    ----------
    theta, omega, terms : sequences, one item a rig
        As ``integrate`` takes them; whatever is a whole number or decides by being zero is the same in all rigs.
    rate : float
        Samples and control steps per second [Hz].

    Returns
    -------
    kept : ndarray, shape (rigs, outputs, samples)
        The outputs at the instant of each sample, to the bit what ``integrate`` keeps of each rig.
    finished : bool
        False where a speed of one of them ceased to be finite; then nothing that is kept counts.
    """
    rigs = len(terms)
    filling = [min(lane, rigs - 1) for lane in range(LANES)]  # lanes without a rig of their own repeat the last
    work = [work_for(terms[rig]) for rig in range(rigs)]
    kept = np.empty((LANES, outputs.kind.size, samples))
    together = ([of[rig] for rig in filling] for of in (theta, omega, terms, work))
    theta_, omega_, terms_, work_ = (_interleaved(each) for each in together)
    failed, _ = advance_together(
        theta_, omega_, terms_, outputs, rate, settling, substeps, kept, work_, settling + samples
    )
    return kept if rigs == LANES else kept[:rigs].copy(), failed < 0


def _interleaved(each: Sequence[Any]) -> Any:
    """Return arrays, or tuples of them, as one: the rigs along a further, last axis of all but the whole numbers."""
    first = each[0]
    if isinstance(first, tuple):
        return type(first)(*(_interleaved(inside) for inside in zip(*each, strict=True)))
    if first.dtype != np.float64:
        return first
    shape = (*first.shape, len(each))
    # a vector that begins within a line of the cache is read and written in two halves, at twice the time
    whole = np.empty(prod(shape) + LANES)
    start = -whole.ctypes.data // whole.itemsize % LANES
    out = whole[start : start + prod(shape)].reshape(shape)
    if all(one is first or np.array_equal(one, first) for one in each):  # such as one load of several drives
        out[...] = first[..., np.newaxis]
        return out
    return np.stack(each, axis=-1, out=out)
