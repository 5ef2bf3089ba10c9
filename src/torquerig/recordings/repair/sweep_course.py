"""How a line that sweeps goes: its ends told to a tenth of a hertz, and the line taken out along them."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

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


def without_sweep(values: Floats, rate: float, sweep: Sweep) -> Floats:
    """Return the samples less the sweep: its envelope is the signal mixed down to zero, averaged over a second."""
    carrier = np.exp(1j * _phase(values.size, rate, sweep))
    step, window = max(1, round(_MIXED * rate)), np.hanning(round(_JOINED / _MIXED) + 2)[1:-1]
    mixed = _mixed(values, carrier, step)
    slow = np.convolve(mixed, window, "same") / np.convolve(np.ones(mixed.size), window, "same")
    middles = (np.arange(mixed.size) + 0.5) * step
    envelope = np.interp(np.arange(values.size), middles, slow)
    return np.asarray(values - 2 * (envelope * carrier).real)


def refined(values: Floats, rate: float, sweep: Sweep) -> Sweep:
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
