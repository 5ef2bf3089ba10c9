"""Memory for large arrays that are needed one after the other."""

from __future__ import annotations

from math import prod
from threading import local

import numpy as np

from torquerig.simulation.arrays import Floats


class ReusedMemory:
    """Gives arrays of which each thread needs one at a time; memory new from the system costs a page at a time."""

    def __init__(self) -> None:
        self._here = local()

    def array(self, shape: tuple[int, ...]) -> Floats:
        """Return an array of any content, valid until the same thread takes the next one."""
        size = prod(shape)
        held: Floats | None = getattr(self._here, "held", None)
        if held is None or held.size < size:
            self._here.held = None  # so that both are not held at once
            held = self._here.held = np.empty(size)
        return held[:size].reshape(shape)
