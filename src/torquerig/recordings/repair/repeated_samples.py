"""Samples that were written twice: a logger whose buffer was read again repeats them, noise and all."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, log

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.strong_tone import without_tone

_NATS = 90.0  # by which a copy must be unlikelier than one chance in e^x for a pair of moments; a run has 1e11 pairs
_LONGEST = 0.1  # [s] codes so coarse that copies would have to be longer show none
_MOVING = 0.5  # share of the steps of a window that must show the noise
_UNEVEN = 0.3  # of the median second difference of the steps: less is no noise
_ROUNDING = 1e-9  # of the range of the samples: steps that differ by less are the same
_MOST = 0.5  # share of the samples: what repeats more is periodic and has no noise


@dataclass(frozen=True)
class Copied:
    """Samples ``start`` to ``stop`` equal those from ``source`` on."""

    start: int
    stop: int
    source: int


def copied(recording: Recording) -> tuple[Copied, ...]:
    """Return the stretches of the torque that repeat an earlier one, sample for sample.

    With the probability p that two steps from sample to sample are the same by chance, L samples repeat with ``p^L``.
    """
    volts = recording.torque_values()
    steps = np.diff(volts)
    rounding = _ROUNDING * float(np.ptp(volts)) or 1.0
    _, found_codes, counts = np.unique(np.round(steps / rounding), return_inverse=True, return_counts=True)
    codes = found_codes.astype(np.int64)
    alike = float(((counts / steps.size) ** 2).sum())
    length = ceil(_NATS / -log(alike)) if 0 < alike < 1 else steps.size
    if length >= min(_LONGEST * recording.sample_rate, steps.size // 2):
        return ()
    beside = without_tone(volts, recording.sample_rate)  # which goes on, and repeats, where a signal is lost
    alive = (steps != 0) & _uneven(steps if beside is None else np.diff(beside))
    found = _extended(codes, _pairs(codes, alive, length), length)
    return () if sum(each.stop - each.start for each in found) > _MOST * volts.size else tuple(found)


def _uneven(steps: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which steps are uneven as noise is: a hum bends evenly from sample to sample."""
    bends = np.abs(np.diff(steps, n=2, prepend=[0.0, 0.0]))
    return np.asarray(bends >= _UNEVEN * np.median(bends))


def _pairs(codes: NDArray[np.int64], alive: NDArray[np.bool_], length: int) -> list[tuple[int, int]]:
    """Return (earlier, later) starts of equal windows, the later ones rising; what has no noise repeats by itself."""
    weights = np.random.default_rng(0).integers(1, 2**62, length, dtype=np.int64)
    with np.errstate(over="ignore"):
        marks = sliding_window_view(codes, length) @ weights
    moved = np.convolve(alive, np.ones(length), "valid") > _MOVING * length
    order = np.flatnonzero(moved)
    order = order[np.argsort(marks[order], kind="stable")]
    same = np.flatnonzero(np.diff(marks[order]) == 0)
    pairs = [(int(order[at]), int(order[at + 1])) for at in same]
    return sorted(pairs, key=lambda pair: pair[1])


def _extended(codes: NDArray[np.int64], pairs: list[tuple[int, int]], length: int) -> list[Copied]:
    found: list[Copied] = []
    for source, start in pairs:
        if found and start < found[-1].stop:
            continue
        differ = np.flatnonzero(codes[source : codes.size - start + source] != codes[start:])
        stop = start + (int(differ[0]) if differ.size else codes.size - start)
        if stop - start >= length:
            found.append(Copied(start, stop + 1, source))
    return found
