"""Arrays that a rig is lowered to but those of its terms, which are in ``term_kinds/``.

Nodes are numbered; the last index is the ground, whose angle and speed stay zero and whose torque is thrown away.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Rows = NDArray[np.uint64]  # unsigned: a signed index costs a test for counting from the end, a sixth of the run time
Starts = NDArray[np.int64]


RUNGS = 4  # a ladder of multiples is climbed four at a time: each four is the four before it times the fourth


class Waves(NamedTuple):
    """Cosines and sines of order times angle, each made once a step: one sine a base, its multiples, products."""

    base_node: Rows  # (bases,) node whose angle is taken
    base_order: Floats  # (bases,)
    ladder: Rows  # (bases + 1,) where the slots of the multiples 1, 2, 3, ... of each base start; whole fours
    first: Rows  # (products,) slot number ladder[-1] + i is the product of two earlier slots
    second: Rows


class Outputs(NamedTuple):
    """What to keep at every sample."""

    kind: Rows
    row: Rows
