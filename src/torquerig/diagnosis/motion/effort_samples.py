"""Faults that the samples of a measured effort show before any model: a limit, and moments without signal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.flat_tops import FlatTops, flat_tops
from torquerig.recordings.repair.moments import bridged, moments_of
from torquerig.recordings.repair.sharp_dropouts import Dropouts, dropouts, moments_lost

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

_NAME = "effort"
_WHOLE = 0.02  # of a code: so near to whole codes all values stand
_BESIDE = 15  # samples on either side that the low-pass of the comparison mixes with a spoilt one


@dataclass(frozen=True, eq=False)
class EffortFaults:
    """What is wrong with the samples of the runs' efforts, and the efforts mended where that is so.

    Parameters
    ----------
    efforts : tuple of ndarray
        Of each run, as the sheet has them [V, A, N, ...], straight lines over what is spoilt.
    limit : FlatTops or None
        The level that they never pass, in those units.
    lost : Dropouts or None
        Moments without signal.
    standing, spoilt : tuple of ndarray of bool
        Which samples stand at the limit, and which neither fits nor judgement may use.
    """

    efforts: tuple[Floats, ...]
    limit: FlatTops | None
    lost: Dropouts | None
    standing: tuple[Mask, ...]
    spoilt: tuple[Mask, ...]


def effort_faults(recordings: Sequence[Recording], channels: Sequence[Channel], *, limits: bool = True) -> EffortFaults:
    """Return the faults of the efforts of all runs; without ``limits`` a level that they stop at is taken for true.

    Parameters
    ----------
    channels : sequence of Channel
        Each recording's effort.
    """
    seen = [
        replace(recording, channels={_NAME: replace(channel, quantity="torque")})
        for recording, channel in zip(recordings, channels, strict=True)
    ]
    lost = dropouts(seen)
    moments = [moments_lost(each) for each in seen]
    whole = [bridged(each, some) for each, some in zip(seen, moments, strict=True)]
    limit = flat_tops(whole, full_range=np.inf, code=_least_code(whole)) if limits else None
    standing = tuple(_standing(each, limit) for each in whole)
    mended = [bridged(each, moments_of(mask)) for each, mask in zip(whole, standing, strict=True)]
    spoilt = tuple(_widened(mask | _within(some, mask.size)) for mask, some in zip(standing, moments, strict=True))
    return EffortFaults(tuple(each.channels[_NAME].values for each in mended), limit, lost, standing, spoilt)


def code_of(values: Floats) -> float | None:
    """Return the distance of two codes where all values stand on whole ones, None where they stand on none."""
    distinct = np.unique(values)
    gaps = np.diff(distinct)
    gaps = gaps[gaps > 1e-9 * np.abs(distinct).max()]  # what is written with few digits repeats no float exactly
    if gaps.size < 2:
        return None
    code = float(np.median(gaps[gaps < 1.5 * gaps.min()]))
    steps = gaps / code
    return code if bool(np.all(np.abs(steps - np.round(steps)) < _WHOLE * np.maximum(steps, 1.0))) else None


def _least_code(recordings: Sequence[Recording]) -> float:
    """Return the finest code of the runs; a millionth of the largest value where there is none."""
    values = [each.channels[_NAME].values for each in recordings]
    codes = [code for each in values if (code := code_of(each)) is not None]
    return min(codes, default=1e-6 * max(float(np.abs(each).max()) for each in values))


def _standing(recording: Recording, limit: FlatTops | None) -> Mask:
    values = recording.channels[_NAME].values
    if limit is None or recording.name not in limit.runs:
        return np.zeros(values.size, dtype=bool)
    return np.asarray(np.abs(values) >= (1 - 1e-3) * limit.limit)


def _within(moments: Sequence[tuple[int, int]], samples: int) -> Mask:
    mask = np.zeros(samples, dtype=bool)
    for start, stop in moments:
        mask[start:stop] = True
    return mask


def _widened(mask: Mask) -> Mask:
    return np.asarray(np.convolve(mask, np.ones(2 * _BESIDE + 1), "same") > 0.5)
