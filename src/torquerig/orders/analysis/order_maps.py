"""Amplitudes by speed (or time) over order and over frequency: an order map, and a measured Campbell diagram."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.analysis.angle_resampling import OverAngle
from torquerig.orders.analysis.order_spectrum import frequency_spectrum, order_spectrum

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

BY_SPEED = 0.1  # [1] relative change of speed from which a map is drawn over speed
ROWS = 80
_OVERLAP = 8  # blocks that contain each sample
_PER_ORDER_BLOCK, _PER_TIME_BLOCK = 5.0, 0.5  # [turns of the output shaft], [s]


@dataclass(frozen=True, kw_only=True)
class LineMap:
    """Amplitudes over one axis, row by row of another.

    Parameters
    ----------
    rows : ndarray, shape (rows,)
        Output speed [rev/s], or time [s]: the middle of each row, rising.
    by_speed : bool
        Whether the rows are speeds.
    places : ndarray, shape (bins,)
        Orders of the output shaft [1/rev], or frequencies [Hz].
    amplitudes : ndarray, shape (rows, bins)
        Zero to peak, rms over the blocks of a row; a row without a block is interpolated.
    """

    rows: Floats
    by_speed: bool
    places: Floats
    amplitudes: Floats


def order_map(even: OverAngle, turns: Floats, rate: float, *, highest: float) -> LineMap:
    """Return amplitudes over the order of the output shaft up to ``highest`` [1/rev], by speed where it changes.

    Parameters
    ----------
    even : OverAngle
    turns : ndarray, shape (samples,)
        Of the output shaft.
    rate : float
        [Hz].
    """
    size = max(int(min(_PER_ORDER_BLOCK, even.turns / 3) * even.per_turn), 16)
    starts = np.arange(0, max(even.values.size - size, 0) + 1, max(size // _OVERLAP, 1))
    spectra = [
        order_spectrum(OverAngle(even.values[at : at + size], even.per_turn, size / even.per_turn), highest=highest)
        for at in starts
    ]
    edges = turns[0] + np.stack([starts, starts + size]) / even.per_turn
    times = np.interp(edges, turns, np.arange(turns.size) / rate)
    speeds = (edges[1] - edges[0]) / np.maximum(times[1] - times[0], 1 / rate)
    return _rows(spectra[0].places, np.array([one.amplitudes for one in spectra]), speeds, times.mean(axis=0))


def speed_map(values: Floats, turns: Floats, rate: float, *, highest: float) -> LineMap:
    """Return amplitudes over frequency up to ``highest`` [Hz], by speed where it changes (Campbell diagram)."""
    size = max(min(int(_PER_TIME_BLOCK * rate), values.size // 3), 16)
    starts = np.arange(0, max(values.size - size, 0) + 1, max(size // _OVERLAP, 1))
    spectra = [frequency_spectrum(values[at : at + size], rate, highest=highest) for at in starts]
    speeds = np.asarray((turns[np.minimum(starts + size, turns.size - 1)] - turns[starts]) / size * rate)
    return _rows(
        spectra[0].places,
        np.array([one.amplitudes for one in spectra]),
        speeds,
        np.asarray((starts + size / 2) / rate, dtype=np.float64),
    )


def _rows(places: Floats, amplitudes: Floats, speeds: Floats, times: Floats) -> LineMap:
    by_speed = bool(np.ptp(speeds) > BY_SPEED * speeds.max())
    axis = speeds if by_speed else times
    edges = np.linspace(axis.min(), axis.max() + 1e-9 * abs(axis.max()), min(ROWS, axis.size) + 1)
    number = np.clip(np.searchsorted(edges, axis, side="right") - 1, 0, edges.size - 2)
    power = np.full((edges.size - 1, places.size), np.nan)
    for row in range(edges.size - 1):
        inside = number == row
        if inside.any():
            power[row] = np.mean(amplitudes[inside] ** 2, axis=0)
    return LineMap(
        rows=0.5 * (edges[1:] + edges[:-1]), by_speed=by_speed, places=places, amplitudes=np.sqrt(_closed(power))
    )


def _closed(power: Floats) -> Floats:
    """Interpolate rows without a block linearly; the first and the last row have one."""
    has = np.flatnonzero(np.isfinite(power[:, 0]))
    at = np.arange(power.shape[0])
    right = np.clip(np.searchsorted(has, at), 0, has.size - 1)
    left = np.clip(np.searchsorted(has, at, side="right") - 1, 0, has.size - 1)
    distance = np.maximum(has[right] - has[left], 1)
    share = ((at - has[left]) / distance)[:, None]
    return np.asarray((1 - share) * power[has[left]] + share * power[has[right]])
