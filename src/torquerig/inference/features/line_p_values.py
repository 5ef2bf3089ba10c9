"""p-values of the power over noise of several blocks, each an exponential variate where there is no line."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import gammaincc, gammaln

Floats = NDArray[np.float64]

CLEAR_BLOCKS = 3  # that show a line of a part of a run each by itself: no transient lasts for so many


def log_p_of_run(count: Floats, total: Floats, clear: Floats) -> Floats:
    """Return the logarithm of the p-value of n groups of blocks: of their capped sum, or of the clear blocks.

    The smaller of two p-values counts for both (Bonferroni).
    """
    summed = log_gamma_tail(count, total)
    return np.asarray(np.where(clear < 0, np.minimum(np.minimum(summed, clear) + np.log(2), 0.0), summed))


def log_p_of_clear(blocks: Floats, least: Floats, *, joined: int) -> Floats:
    """Return the logarithm of the p-value of the ``CLEAR_BLOCKS`` highest of n blocks; 0 where there are fewer.

    k of n exponential variates exceed x with a probability of at most ``binom(n, k) exp(-k x)``: a tone that lasts for
    a part of a run is in few of its blocks. Of blocks of which up to ``joined`` have one spectrum, that is one variate.
    """
    k, enough = CLEAR_BLOCKS, np.maximum(blocks, CLEAR_BLOCKS)
    ways = gammaln(enough + 1) - gammaln(k + 1) - gammaln(enough - k + 1)
    return np.asarray(np.where(blocks >= k, np.minimum(ways - np.ceil(k / joined) * least, 0.0), 0.0))


def log_gamma_tail(shape: Floats, value: Floats) -> Floats:
    """Return the logarithm of the upper tail of a gamma variate of scale 1, also where it underflows."""
    tail = gammaincc(shape, value)
    far = -value + (shape - 1) * np.log(np.maximum(value, 1e-9)) - gammaln(shape)
    return np.asarray(np.where(tail > 1e-250, np.log(np.maximum(tail, 1e-300)), far))
