"""A recording of the rig program: two columns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Recording:
    """Signals of one run: ``torque`` (n,) [V] and ``encoder`` (n,) [count]."""

    torque: NDArray[np.float64]
    encoder: NDArray[np.int32]
