"""Where a line of a model shows in the features of a run: at which place of each stretch, else in which band."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Route:
    """Stretches (``rows``) that show a line and at which place; a band for where none does.

    ``part`` of it shows there, and it is a ``guest`` where the place is another line's.
    """

    rows: NDArray[np.int64]
    column: NDArray[np.int64]
    part: Floats
    guest: NDArray[np.bool_]
    band: int | None


def hann_transform(bins: Floats) -> Floats:
    """Return what a Hann window leaves of a line that stands so many bins beside the one looked for."""
    return np.asarray(np.sinc(bins) + 0.5 * (np.sinc(bins - 1) + np.sinc(bins + 1)))
