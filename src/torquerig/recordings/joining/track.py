"""One column with its rate and its start."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.sidecar import ChannelEntry


@dataclass(frozen=True, kw_only=True)
class Track:
    """One column: its samples, its rate [Hz], the time of its first sample [s] on the clock of its file."""

    name: str
    values: NDArray[np.float64]
    rate: float
    start: float
    entry: ChannelEntry
