"""The cosines and sines of one evaluation: one sine a base, its multiples climbed four at a time, then products."""

from __future__ import annotations

import numpy as np
from numba import njit

from torquerig.simulation.arrays import RUNGS
from torquerig.simulation.kernel.elementary import sine_cosine
from torquerig.simulation.kernel.fast import FAST

ONE, TWO, THREE, CLIMB = np.uint64(1), np.uint64(2), np.uint64(3), np.uint64(RUNGS)


@njit(fastmath=FAST, inline="always")
def climb(waves, theta, cosine, sine):
    """Fill ``cosine`` and ``sine`` at the angles ``theta``.

    A rung in memory takes a product twice as long to reach as one in a register; so four neighbours are kept there.
    """
    for i in range(waves.base_node.size):
        s1, c1 = sine_cosine(waves.base_order[i] * theta[waves.base_node[i]])
        at, end = waves.ladder[i], waves.ladder[i + 1]
        if at + ONE == end:
            cosine[at], sine[at] = c1, s1
            continue
        c2, s2 = c1 * c1 - s1 * s1, 2.0 * s1 * c1
        c3, s3 = c2 * c1 - s2 * s1, s2 * c1 + c2 * s1
        c4, s4 = c2 * c2 - s2 * s2, 2.0 * s2 * c2
        up, side = c4, s4
        cosine[at], cosine[at + ONE], cosine[at + TWO], cosine[at + THREE] = c1, c2, c3, c4
        sine[at], sine[at + ONE], sine[at + TWO], sine[at + THREE] = s1, s2, s3, s4
        at += CLIMB
        while at < end:
            c1, s1 = c1 * up - s1 * side, s1 * up + c1 * side
            c2, s2 = c2 * up - s2 * side, s2 * up + c2 * side
            c3, s3 = c3 * up - s3 * side, s3 * up + c3 * side
            c4, s4 = c4 * up - s4 * side, s4 * up + c4 * side
            cosine[at], cosine[at + ONE], cosine[at + TWO], cosine[at + THREE] = c1, c2, c3, c4
            sine[at], sine[at + ONE], sine[at + TWO], sine[at + THREE] = s1, s2, s3, s4
            at += CLIMB
    to = waves.ladder[waves.base_node.size]
    for i in range(waves.first.size):
        p, q = waves.first[i], waves.second[i]
        cosine[to] = cosine[p] * cosine[q] - sine[p] * sine[q]
        sine[to] = sine[p] * cosine[q] + cosine[p] * sine[q]
        to += ONE
