"""Whether a line of fixed frequency sounds all along, as electronics do, or comes and goes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.observed import Observed
from torquerig.diagnose.peaks import Peak

Complex = NDArray[np.complex128]

_BLOCK = 0.02  # [s] short against a burst
_BESIDE = 3.0  # block widths away from the line, where its floor is taken
_STEADY = 0.75  # share of its power that a steady tone keeps in one bin


def sounds_all_along(peak: Peak, runs: Sequence[Observed]) -> bool:
    """Whether the line keeps nearly all its power in one bin, in the run that shows it best.

    Of a tone of amplitude A that sounds for a share d of the time, ``d A^2`` is its power and ``d^2 A^2`` that of its
    line; the rest is spread beside it. A tone whose frequency jumps or sweeps loses its line likewise.
    """
    shares = [_share_in_one_bin(run, peak.place.at) for run in runs if run.steady and run.name in peak.runs]
    return not shares or max(shares) > _STEADY


def _share_in_one_bin(run: Observed, at: float) -> float:
    seen = [stretch for stretch in run.stretches if not stretch.held]
    torque = run.torque[seen[0].start : seen[-1].stop]
    line = _blocks(torque, run.rate, at)
    floor = [np.mean(np.abs(_blocks(torque, run.rate, at + side * _BESIDE / _BLOCK)) ** 2) for side in (1.0, -1.0)]
    power = float(np.mean(np.abs(line) ** 2) - min(floor))
    one = float(np.abs(np.fft.fft(line, 8 * line.size)).max() / line.size) ** 2
    return one / power if power > 0 else 1.0


def _blocks(torque: NDArray[np.float64], rate: float, at: float) -> Complex:
    """Return the line's complex amplitude in each block, shape (blocks,)."""
    size = round(_BLOCK * rate)
    count = torque.size // size
    turned = torque[: count * size] * np.exp(-2j * np.pi * at / rate * np.arange(count * size))
    return np.asarray((turned.reshape(count, size) * np.hanning(size)).mean(axis=1))
