"""The loop over eight similar rigs at once, one in each lane of the vector registers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import prod
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from torquerig.simulation.arrays import Floats, Outputs
from torquerig.simulation.kernel.fast import FAST, UNCOUNTED
from torquerig.simulation.kernel.lanes import LANES, in_lanes
from torquerig.simulation.kernel.loop import advance
from torquerig.simulation.kernel.sources import sources_key
from torquerig.simulation.kernel.work import work_for
from torquerig.simulation.term_kinds import Terms

Memory = Callable[[tuple[int, ...]], Floats]
PIECE = 16_384  # samples whose inputs are side by side at once: 1 MiB each


def _built(key: int) -> Callable[..., Any]:
    """Return the compiled loop over lanes; ``key`` is closed over so that the cache on disk is keyed by it."""

    @njit(cache=True, nogil=True, fastmath=FAST, **UNCOUNTED)
    def advance_together(theta, omega, terms, outputs, rate, settling, substeps, kept, work, first, last):
        if key < 0:  # never: it is named here to be closed over
            return -1, -1
        theta_, omega_, terms_, work_ = in_lanes(theta), in_lanes(omega), in_lanes(terms), in_lanes(work)
        return advance(theta_, omega_, terms_, outputs, rate, settling, substeps, kept, work_, first, last, first)

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
    *,
    memory: Memory = np.empty,
) -> tuple[Floats, bool, NDArray[np.bool_]]:
    """Step up to ``LANES`` rigs of one structure together.

    Parameters
    ----------
    theta, omega, terms : sequences, one item a rig
        As ``integrate`` takes them; whatever is a whole number or decides by being zero is the same in all rigs.
    rate : float
        Samples and control steps per second [Hz].

    memory : callable
        Returns an array of a shape for ``kept``.

    Returns
    -------
    kept : ndarray, shape (rigs, outputs, samples)
        The outputs at the instant of each sample, to the bit what ``integrate`` keeps of each rig.
    finished : bool
        False where a speed of one of them ceased to be finite; then nothing that is kept counts.
    parted : ndarray of bool, shape (rigs,)
        Whether the flanks of a gap met or parted while samples were kept.
    """
    rigs = len(terms)
    filling = [min(lane, rigs - 1) for lane in range(LANES)]  # lanes without a rig of their own repeat the last
    work = [work_for(terms[rig]) for rig in range(rigs)]
    kept = memory((LANES, outputs.kind.size, samples))
    together = ([of[rig] for rig in filling] for of in (theta, omega, work))
    theta_, omega_, work_ = (_interleaved(each) for each in together)
    failed = -1
    for first, last, terms_ in _in_pieces([terms[rig] for rig in filling], settling + samples):
        failed, _ = advance_together(
            theta_, omega_, terms_, outputs, rate, settling, substeps, kept, work_, first, last
        )
        if failed >= 0:
            break
    return kept[:rigs], failed < 0, work_.parted[0, :rigs] > 0.0


def _in_pieces(terms: Sequence[Terms], samples: int) -> Iterator[tuple[int, int, Terms]]:
    """Yield the first and the last sample of pieces of a run, with the rigs side by side and their inputs there.

    The inputs of all rigs side by side are eight times as long as those of one; of a piece they stay in the cache.
    """
    none = np.empty((0, 0))
    rest = _interleaved(
        [
            one._replace(
                loads=one.loads._replace(samples=none), drives=one.drives._replace(reference=none, demand=none)
            )
            for one in terms
        ]
    )
    given = [[one.loads.samples for one in terms], [one.drives.reference for one in terms]]
    given.append([one.drives.demand for one in terms])
    places = [_aligned((len(each[0]), PIECE + 1, len(each))) for each in given]
    for first in range(0, samples, PIECE):
        last = min(first + PIECE, samples)
        for each, place in zip(given, places, strict=True):
            for lane, one in enumerate(each):
                place[:, : last - first + 1, lane] = one[:, first : last + 1]
        loads, reference, demand = places
        yield (
            first,
            last,
            rest._replace(
                loads=rest.loads._replace(samples=loads),
                drives=rest.drives._replace(reference=reference, demand=demand),
            ),
        )


def _interleaved(each: Sequence[Any]) -> Any:
    """Return arrays, or tuples of them, as one: the rigs along a further, last axis of all but the whole numbers."""
    first = each[0]
    if isinstance(first, tuple):
        return type(first)(*(_interleaved(inside) for inside in zip(*each, strict=True)))
    if first.dtype != np.float64:
        return first
    return np.stack(each, axis=-1, out=_aligned((*first.shape, len(each))))


def _aligned(shape: tuple[int, ...]) -> Floats:
    """Return an array for lanes: one that begins within a line of the cache is read in halves, at twice the time."""
    whole = np.empty(prod(shape) + LANES)
    start = -whole.ctypes.data // whole.itemsize % LANES
    return whole[start : start + prod(shape)].reshape(shape)
