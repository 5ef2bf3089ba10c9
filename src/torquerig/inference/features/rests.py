"""How long and how often a torque is near zero, and how far it goes to the other side: what parted flanks show.

While the flanks of a gear are apart they transmit nothing, and the sensor reads what the separated parts do by
themselves. A wide gap makes few long rests, a narrow one many short ones with impacts on both flanks.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block

Floats = NDArray[np.float64]

_FAR_SIDE = (0.01, 0.05)  # share of the samples below the quantiles that are compared


def rests(torque: Floats, blocks: Iterable[Block], *, rate: float, window: float, near: float) -> Floats:
    """Return four statistics of a torque without its zero, shape (4,).

    The logarithms of the rests per second and of their mean length [s]; and two quantiles on the side away from the
    mean of each block, as ``arsinh(torque / near)``.

    Parameters
    ----------
    torque : ndarray, shape (samples,)
        [N m]
    rate : float
        Samples per second [Hz].
    window : float
        Length of the moving mean [s].
    near : float
        A smaller torque is a rest [N m].
    """
    from scipy.ndimage import uniform_filter1d

    count, resting, values = 0, 0, list[Floats]()
    for block in blocks:
        smooth = uniform_filter1d(torque[block.samples], max(round(window * rate), 1))
        smooth *= np.sign(smooth.mean()) or 1.0
        is_near = np.abs(smooth) < near
        count += int(np.count_nonzero(np.diff(is_near, prepend=False) & is_near))
        resting += int(is_near.sum())
        values.append(smooth)
    together = np.concatenate(values)
    often = (count + 1) * rate / together.size
    length = (resting / rate + window) / (count + 1)
    return np.array([np.log(often), np.log(length), *np.arcsinh(np.quantile(together, _FAR_SIDE) / near)])


def near_zero(torque: Floats, *, rate: float, window: float) -> float:
    """Return the torque below which a run rests [N m]: a quarter of the median of the smoothed torque, without sign."""
    from scipy.ndimage import uniform_filter1d

    return 0.25 * float(np.median(np.abs(uniform_filter1d(torque, max(round(window * rate), 1)))))
