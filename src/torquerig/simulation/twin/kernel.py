"""The compiled part of the exact linear path: from block to block.

Self-contained on purpose: numba's cache on disk goes stale when a callee in another file changes.
"""

from __future__ import annotations

import numpy as np
from numba import njit


@njit(cache=True, nogil=True)
def carry(transition, added, states):
    """Fill ``states[i + 1] = transition states[i] + added[i]``, ``states[0]`` being the start.

    Parameters
    ----------
    transition : ndarray, shape (n, n)
        Taken column by column, so that the rows go through the processor side by side.
    added : ndarray, shape (blocks, n)
    states : ndarray, shape (blocks + 1, n)
    """
    n = transition.shape[0]
    columns = np.ascontiguousarray(transition.T)
    total = np.empty(n)
    for block in range(added.shape[0]):
        for row in range(n):
            total[row] = added[block, row]
        for column in range(n):
            value = states[block, column]
            for row in range(n):
                total[row] += columns[column, row] * value
        for row in range(n):
            states[block + 1, row] = total[row]
    return np.isfinite(states[-1]).all()
