"""The random loads of a simulated recording, drawn again from its random seed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Rig
from torquerig.rig.terms import Load
from torquerig.simulation.inputs import Span, given_torques
from torquerig.simulation.sampling import SETTLING


def drawn_loads(
    rig: Rig, recording: Recording, *, settling: float = SETTLING
) -> list[tuple[Load, NDArray[np.float64]]]:
    """Return every load of ``rig`` with what ``recording``, which it made, drew of it, from the start of settling on.

    Drawn again, from the seed in the recording's origin.

    Parameters
    ----------
    settling : float
        With which the recording was simulated [s].

    Returns
    -------
    list of (Load, ndarray), of shape (settling samples + samples,)
        [N m].
    """
    rate, seed = recording.sample_rate, int(recording.origin["seed"])
    span = Span(settling=round(settling * rate), samples=recording.samples, rate=rate, seed=seed)
    terms = [term for term in rig.terms() if isinstance(term, Load)]
    return [(term, given[:-1]) for term, given in zip(terms, given_torques(rig, terms, span), strict=True)]
