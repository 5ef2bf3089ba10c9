"""A cascade of notches over a signal that comes in pieces: memory stays flat whatever the length."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.biquads import cascaded, quiet_start, time_constants

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def causal_pieces(pieces: Iterable[Floats], sections: Floats) -> Iterator[Floats]:
    """Yield what the cascade makes of each piece, its states carried on: the same numbers as in one go, to the bit."""
    states = None
    for piece in pieces:
        answer, states = cascaded(piece, sections, states=states)
        yield answer


def zero_phase_pieces(pieces: Iterable[Floats], sections: Floats, *, spans: float = 14.0) -> Iterator[Floats]:
    """Yield the notched signal without delay, piece by piece; the pieces need not be those that came in.

    The pass forwards carries its states on and is exact. The pass backwards over a piece begins ``spans`` time
    constants of the longest-ringing notch behind its end, as if its lines went on beyond: what is wrong with that
    state has fallen to e^-spans (8e-7 at 14) of itself where the piece ends, and no other error is made.

    Parameters
    ----------
    pieces : iterable of ndarray, shape (samples,)
        In order, of any lengths.
    sections : ndarray, shape (sections, 6)
        Notches; see :func:`~torquerig.filters.biquads.zero_phase_notched`.
    spans : float
        Memory is about twice as many time constants of samples as this, and one piece.
    """
    overlap = max(int(np.ceil(spans * time_constants(sections).max(initial=0.0))), 1)
    states: Floats | None = None
    held = np.zeros(0)
    for piece in _gathered(pieces, overlap):
        states = quiet_start(piece, sections) if states is None else states
        answer, states = cascaded(piece, sections, states=states)
        held = np.concatenate([held, answer])
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
    """Yield the same samples in pieces of ``least`` or more, but for the last."""
    held: list[Floats] = []
    for piece in pieces:
        held.append(piece)
        if sum(part.size for part in held) >= least:
            yield np.concatenate(held)
            held = []
    if held:
        yield np.concatenate(held)
