"""A cascade of notches over a signal in pieces, so that memory does not grow with its length."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.biquads import cascaded, quiet_start, time_constants

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def causal_pieces(pieces: Iterable[Floats], sections: Floats) -> Iterator[Floats]:
    """Yield the filtered pieces with the states carried over: bit-identical to filtering the whole signal."""
    states = None
    for piece in pieces:
        filtered, states = cascaded(piece, sections, states=states)
        yield filtered


def zero_phase_pieces(pieces: Iterable[Floats], sections: Floats, *, spans: float = 14.0) -> Iterator[Floats]:
    """Yield the zero-phase notched signal piece by piece; the pieces may differ from those that came in.

    The forward pass carries its states over and is exact. The backward pass over a piece starts ``spans`` time
    constants of the longest-ringing notch after its end, with states as if the lines continued. The error of these
    states has decayed to e^-spans (8e-7 at 14) at the end of the piece; there is no other error.

    Parameters
    ----------
    pieces : iterable of ndarray, shape (samples,)
        In order, of any lengths.
    sections : ndarray, shape (sections, 6)
        Notches; see :func:`~torquerig.filters.biquads.zero_phase_notched`.
    spans : float
        Length of the overlap in time constants [1]; memory is about twice the overlap and one piece.
    """
    overlap = max(int(np.ceil(spans * time_constants(sections).max(initial=0.0))), 1)
    states: Floats | None = None
    held = np.zeros(0)
    for piece in _gathered(pieces, overlap):
        states = quiet_start(piece, sections) if states is None else states
        filtered, states = cascaded(piece, sections, states=states)
        held = np.concatenate([held, filtered])
        ready = held.size - overlap
        if ready >= overlap:
            yield _backwards(held, sections)[:ready]
            held = held[ready:]
    if held.size:
        yield _backwards(held, sections)


def _backwards(values: Floats, sections: Floats) -> Floats:
    states = quiet_start(values[::-1], sections)
    return cascaded(values[::-1], sections, states=states)[0][::-1]


def _gathered(pieces: Iterable[Floats], least: int) -> Iterator[Floats]:
    """Yield the same samples in pieces of ``least`` samples or more; the last may be shorter."""
    held: list[Floats] = []
    for piece in pieces:
        held.append(piece)
        if sum(part.size for part in held) >= least:
            yield np.concatenate(held)
            held = []
    if held:
        yield np.concatenate(held)
