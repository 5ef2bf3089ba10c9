"""The speed over time of a run that varies by per cents: the most likely path through the combs of short blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_TURNS = 8.0  # motor turns of a block; blocks overlap by half
_REACH = 0.04  # [1] largest relative deviation of the speed from the set-point
_STEPS = 200  # grid points of the speed on either side of the set-point
_FASTEST = 0.03  # [1/s] standard deviation of the relative change of speed
_FEWEST_BLOCKS = 8


def speed_trajectory(torque: Floats, nominal: Floats, orders: Floats, *, rate: float) -> Floats | None:
    """Return the speed relative to the nominal one at each sample [1], or None for a run of too few turns.

    Parameters
    ----------
    torque, nominal : ndarray, shape (samples,)
        The torque in any unit, and the angle of a constant set-point [rad].
    orders : ndarray, shape (orders,)
        Orders of the comb [1/rev].
    rate : float
        Samples per second [Hz].

    Notes
    -----
    Each block of eight turns scores the speeds within 4 % by the summed log power at the comb's orders. The result is
    the path of highest score less (change / sigma)^2 / 2 from block to block, with sigma 3 % a second (Viterbi 1967).
    """
    per_sample = float(nominal[-1] - nominal[0]) / (nominal.size - 1)
    half = round(_TURNS * np.pi / abs(per_sample))
    blocks = torque.size // half - 1
    if blocks < _FEWEST_BLOCKS:
        return None
    factors = 1 + _REACH * np.arange(-_STEPS, _STEPS + 1) / _STEPS
    scores = np.stack([_score(torque[k * half : (k + 2) * half], abs(per_sample), orders, factors)
                       for k in range(blocks)])  # fmt: skip
    sigma = _FASTEST * half / rate / (_REACH / _STEPS)  # in steps of the speed
    path = factors[_likeliest(scores, reach=max(int(np.ceil(4 * sigma)), 1), cost=0.5 / sigma**2)]
    smooth = np.convolve(np.pad(path, 1, mode="edge"), [0.25, 0.5, 0.25], mode="valid")
    return np.asarray(np.interp(np.arange(torque.size), (np.arange(blocks) + 1) * half, smooth))


def _score(piece: Floats, per_sample: float, orders: Floats, factors: Floats) -> Floats:
    """Return the summed log power over the noise floor of one block at each speed, shape (factors,)."""
    from scipy.fft import next_fast_len, rfft

    size = next_fast_len(2 * piece.size, real=True)
    power = np.abs(rfft((piece - piece.mean()) * np.hanning(piece.size), n=size)) ** 2
    bins = orders[:, None] * factors * per_sample * size / (2 * np.pi)
    seen = bins[:, -1] < 0.9 * power.size
    score = np.zeros(factors.size)
    for row in bins[seen]:
        low, high = max(int(row[0]) - 20, 1), min(int(row[-1]) + 20, power.size)
        floor = float(np.median(power[low:high])) / np.log(2) + 1e-300
        score += np.log1p(np.interp(row, np.arange(low, high), power[low:high]) / floor)
    return score


def _likeliest(scores: Floats, *, reach: int, cost: float) -> NDArray[np.int64]:
    """Return the path of highest score; a change of up to ``reach`` steps costs ``cost`` times its square."""
    blocks, count = scores.shape
    moves = np.arange(-reach, reach + 1)
    back = np.zeros((blocks, count), dtype=np.int64)
    best = scores[0].copy()
    at = np.arange(count)
    for block in range(1, blocks):
        came = at[None, :] + moves[:, None]
        inside = (came >= 0) & (came < count)
        value = np.where(inside, best[np.clip(came, 0, count - 1)] - cost * moves[:, None] ** 2, -np.inf)
        chosen = value.argmax(axis=0)
        back[block] = came[chosen, at]
        best = value[chosen, at] + scores[block]
    path = np.empty(blocks, dtype=np.int64)
    path[-1] = int(best.argmax())
    for block in range(blocks - 1, 0, -1):
        path[block - 1] = back[block, path[block]]
    return path
