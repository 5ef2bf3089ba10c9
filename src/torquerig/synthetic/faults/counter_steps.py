"""Steps of an encoder's counter away from the shaft, for counts that are lost or counted twice."""

from __future__ import annotations

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed
from torquerig.synthetic.faults.measured import counts_name
from torquerig.synthetic.faults.moments import drawn_moments


def with_counter_steps(
    recording: Recording, rng: np.random.Generator, *, counts: int, rate: float, fault: str
) -> Disturbed:
    """Return the recording whose counter is ahead by ``counts`` in the way of the shaft from each drawn event on.

    Parameters
    ----------
    counts : int
        Of each event; negative where the counter falls behind.
    rate : float
        Number of events [1/s].
    fault : str
        The name of the fault, for messages.
    """
    name = counts_name(recording, fault=fault)
    values = recording.channels[name].values
    turns = 1.0 if values[-1] >= values[0] else -1.0
    off = np.zeros(recording.samples)
    off[drawn_moments(recording, rate, rng, fault=fault)] = turns * counts
    return Disturbed(recording=recording.with_values(name, values + np.cumsum(off)), affected=off != 0)
