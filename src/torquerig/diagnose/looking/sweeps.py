"""A line that sweeps from one frequency to another while the shaft keeps its speed: whatever makes it, it is no order.

The line is found by summing the spectrogram along straight paths (a Hough transform of the log power over its median in
time, as for the chirps of gravitational waves: Krishnan et al. 2004, Phys. Rev. D 70, 082001), and taken out as its own
slow envelope times its carrier.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from torquerig.diagnose.looking.kernel import largest_path_sum
from torquerig.diagnose.looking.short_spectra import OVERLAP, spectrogram

Floats = NDArray[np.float64]

CLEAR = 14.0  # spreads; a struck mode that comes and goes has reached 10, and the faintest lines that sweep 40
_BLOCK = 0.16  # [s], every half of which a new one begins: 6 Hz
_LOWEST, _HIGHEST = 60.0, 4000.0  # [Hz]
_FEWEST = 40  # blocks
_FAR, _NO_ORDER = 6, 0.08  # bins, and logarithm, that a line must move by: with the speed an order wanders by less
_AROUND = 17  # bins whose median is taken off: 100 Hz that get loud together are no line
_CAPPED = (-3.0, 8.0)  # of the log power: one loud block is no path
_ALL_ALONG = 0.65  # share of its blocks in which a line stands above the mean; 0.45 for modes that are struck
_MIXED, _JOINED = 0.01, 1.0  # [s] of the mixed-down signal: step, and how long the line keeps its phase
_FIRST, _OFF, _SMEARED = 0.1, 7.0, 0.25  # [s] summed in phase, [Hz] by which ends may be off, and by how many seconds
_STAGES = ((0.4, 6.0), (1.5, 1.5), (4.0, 0.5))  # [s] summed in phase then, [Hz] by which ends may be off
_TRIED = 17  # ends of each stage


@dataclass(frozen=True)
class Sweep:
    """A line that goes from ``start`` to ``stop`` [Hz] in a run, evenly.

    ``clear`` is the sum along its path in spreads of a path by chance.
    """

    start: float
    stop: float
    clear: float


def sweep_in(values: Floats, rate: float) -> Sweep | None:
    """Return the clearest sweep over a whole run, None where no path stands out.

    Parameters
    ----------
    values : ndarray, shape (samples,)
    rate : float
        Of the samples [Hz].
    """
    found = _log_power(values, rate)
    if found is None:
        return None
    log, frequency = found
    clear, start, stop = largest_path_sum(log, _FAR)
    clear /= float(np.sqrt(log.shape[0] * OVERLAP))
    path = _along(log, start, stop)
    moves = abs(float(np.log(frequency[stop] / frequency[start])))
    if clear < CLEAR or np.mean(path > 0) < _ALL_ALONG or moves < _NO_ORDER:
        return None
    return _refined(values, rate, Sweep(float(frequency[start]), float(frequency[stop]), clear))


def sweep_along(values: Floats, rate: float, sweeps: Sequence[Sweep]) -> Sweep | None:
    """Return the sweep of a run whose orders sweep too, where one of the ``sweeps`` of other runs is clear there."""
    found = _log_power(values, rate)
    if found is None:
        return None
    log, frequency = found
    for sweep in sweeps:
        first, last = np.interp([sweep.start, sweep.stop], frequency, np.arange(frequency.size))
        clear = float(_along(log, first, last).sum() / np.sqrt(log.shape[0] * OVERLAP))
        if clear > CLEAR:
            return _refined(values, rate, Sweep(sweep.start, sweep.stop, clear))
    return None


def _along(log: Floats, first: float, last: float) -> Floats:
    """Return what a straight path from one column to another meets in each row, shape (rows,)."""
    rows = np.arange(log.shape[0])
    return np.asarray(log[rows, np.linspace(first + 0.5, last + 0.5, rows.size).astype(np.intp)])


def without_sweep(values: Floats, rate: float, sweep: Sweep) -> Floats:
    """Return the samples less the sweep: its envelope is the signal mixed down to zero, averaged over a second."""
    carrier = np.exp(1j * _phase(values.size, rate, sweep))
    step, window = max(1, round(_MIXED * rate)), np.hanning(round(_JOINED / _MIXED) + 2)[1:-1]
    mixed = _mixed(values, carrier, step)
    slow = np.convolve(mixed, window, "same") / np.convolve(np.ones(mixed.size), window, "same")
    middles = (np.arange(mixed.size) + 0.5) * step
    envelope = np.interp(np.arange(values.size), middles, slow)
    return np.asarray(values - 2 * (envelope * carrier).real)


def _log_power(values: Floats, rate: float) -> tuple[Floats, Floats] | None:
    """Return the log power over its medians in time and frequency, in units of its spread, and its frequencies."""
    hop = round(0.5 * _BLOCK * rate)
    if values.size < (_FEWEST + 1) * hop:
        return None
    power, frequency = spectrogram(values, rate, hop)
    used = (frequency >= _LOWEST) & (frequency < min(_HIGHEST, 0.45 * rate))
    middle = np.median(power[:, used], axis=0)
    log = np.log(np.maximum(power[:, used] / np.maximum(middle, 1e-300), 1e-9))
    log = np.clip(log - median_filter(log, size=(1, _AROUND), mode="nearest"), *_CAPPED)
    return np.asarray((log - log.mean()) / max(float(log.std()), 1e-9)), frequency[used]


def _refined(values: Floats, rate: float, sweep: Sweep) -> Sweep:
    """Return the sweep whose ends hold most of the mixed-down power in short times, then in ever longer ones."""
    step = max(1, round(_MIXED * rate))
    slope = abs(sweep.stop - sweep.start) * rate / values.size
    for joined, reach in ((_FIRST, _OFF + _SMEARED * slope), *_STAGES):
        mixed = _mixed(values, np.exp(1j * _phase(values.size, rate, sweep)), step)
        length = round(joined / _MIXED)
        pieces = mixed[: mixed.size // length * length].reshape(-1, length)
        time = (np.arange(pieces.size).reshape(pieces.shape) + 0.5) * step / rate
        off, best = np.linspace(-reach, reach, _TRIED), (-1.0, 0.0, 0.0)
        for first in off:
            for last in off:
                turned = np.exp(-2j * pi * (first * time + 0.5 * (last - first) * rate / values.size * time**2))
                held = float((np.abs((pieces * turned).sum(axis=1)) ** 2).sum())
                best = max(best, (held, float(first), float(last)))
        sweep = Sweep(sweep.start + best[1], sweep.stop + best[2], sweep.clear)
    return sweep


def _phase(samples: int, rate: float, sweep: Sweep) -> Floats:
    time, duration = np.arange(samples) / rate, samples / rate
    return np.asarray(2 * pi * (sweep.start * time + 0.5 * (sweep.stop - sweep.start) / duration * time**2))


def _mixed(values: Floats, carrier: NDArray[np.complex128], step: int) -> NDArray[np.complex128]:
    """Return the signal times the conjugate carrier, in means of ``step`` samples."""
    blocks = values.size // step
    product = (values - values.mean()) * carrier.conj()
    return np.asarray(product[: blocks * step].reshape(blocks, step).mean(axis=1))
