"""Jumps from one sample to the next in a signal that is smooth on either side: no shaft passes such a torque on.

An amplifier of some kHz spreads what comes from the shaft over several samples, and what is as fast as it rings: the
samples beside are large as well. A gain or a zero that jumps, and samples that are lost, stand alone. Where an
amplifier rounds them too they take some samples, less than a torque does, and stay.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.edges import differences_over, edges_over, largest_of_each, stays_so
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, amount, fault_in_time, in_words
from torquerig.recordings.repair.mean_steps import MEAN_STEP
from torquerig.recordings.repair.moments import Moments, seams
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_BESIDE = 25  # differences on either side
_CLEAR = 14.0  # robust spreads of those, and of the run's by a third of it
_FASTEST = 5e-4  # [s] within which no torque changes: a current loop and a shaft take longer
_LAGS = (2, 4, 8)  # samples of a jump that an amplifier rounds
_FEWEST = 3  # of a recording: one may be a switch of the load, and passes
_ALONE = 2.5  # times the largest of those


def without_jumps(seen: Examination) -> Examination:
    """Bridge jumps of recordings whose mean does not step; so few jumps that a load may have switched are left."""
    lost, told = list(seen.lost), list[Fault]()
    for index, recording in enumerate(seen.recordings):
        slow = recording.sample_rate * _FASTEST < 1
        if slow or seen.shows(MEAN_STEP, recording) or recording.name in seen.standing:
            continue
        jumps, lag = _jumps_of(recording, lost[index], resolution=2 * seen.resolution)
        if jumps:
            told.append(_fault(recording, jumps, lag))
            lost[index] = [*lost[index], *seams(jumps, recording)]
    return replace(seen, lost=tuple(lost)).with_faults(*told)


def _jumps_of(recording: Recording, lost: Moments, *, resolution: float) -> tuple[list[int], int]:
    """Return the first samples after jumps and how many samples one takes; none where there are few."""
    volts, rate = recording.torque_values(), recording.sample_rate
    jumps = sample_jumps(volts, lost, resolution=resolution).tolist()
    if len(jumps) >= _FEWEST:
        return jumps, 1
    lags = [lag for lag in _LAGS if lag <= _FASTEST * rate]
    each = [(rounded_jumps(volts, rate, lost, lag=lag, resolution=resolution).tolist(), lag) for lag in lags]
    jumps, lag = max(each, key=lambda found: len(found[0]), default=([], 1))
    return (jumps, lag) if len(jumps) >= _FEWEST else ([], 1)


def _fault(recording: Recording, jumps: Sequence[int], lag: int) -> Fault:
    heights = np.abs(differences_over(recording.torque_values(), lag))[np.array(jumps) - lag]
    within = "from one sample to the next" if lag == 1 else f"within {lag} samples"
    return fault_in_time(
        recording, "jumps", jumps[0], jumps[0] + 1,
        seen=f"at {in_words([at / recording.sample_rate for at in jumps])} the signal jumps by up to "
        f"{amount(recording, float(heights.max()))} {within}, and is smooth before and after; no torque does that, a "
        "gain or a zero that changes or lost samples do",
        repair="no mechanism of the library does that: the rest was judged with the jumps bridged",
    )  # fmt: skip


def rounded_jumps(
    volts: Floats, rate: float, lost: Moments = (), *, lag: int, resolution: float = 0.0
) -> NDArray[np.int64]:
    """Return the first samples after jumps that an amplifier spreads over ``lag`` samples, and that stay.

    Parameters
    ----------
    volts : ndarray, shape (samples,)
    rate : float
        [Hz].
    lost, resolution
        As of :func:`sample_jumps`.
    """
    edges = edges_over(volts, lag)
    sizes, usual = np.abs(edges), max(spread_about_zero(edges), resolution)
    clear = sizes > _CLEAR * usual
    for start, stop in lost:
        clear[max(start - _BESIDE * lag, 0) : stop + _BESIDE * lag] = False
    at = largest_of_each(sizes, np.flatnonzero(clear), apart=4 * lag)
    at = at[stays_so(volts, rate, at, edges[at], lag=lag)]
    return np.array([one + lag for one in at.tolist() if _alone(edges, one, usual, apart=3 * lag)], dtype=np.int64)


def sample_jumps(volts: Floats, lost: Moments = (), *, resolution: float = 0.0) -> NDArray[np.int64]:
    """Return the first samples after a jump.

    Parameters
    ----------
    volts : ndarray, shape (samples,)
    lost : sequence of (int, int)
        Moments without signal, whose ends are none.
    resolution : float
        One code [V].
    """
    steps = np.diff(volts)
    usual = max(spread_about_zero(steps), resolution)
    told = np.abs(steps) > 0.5 * _CLEAR * usual
    for start, stop in lost:
        told[max(start - _BESIDE, 0) : stop + _BESIDE] = False
    return np.array([at + 1 for at in np.flatnonzero(told) if _alone(steps, int(at), usual, apart=0)], dtype=np.int64)


def _alone(steps: Floats, at: int, usual: float, *, apart: int) -> bool:
    """Whether a step is far larger than those beside it, of which the next ``apart`` are part of it."""
    beside = _BESIDE * max(apart // 3, 1)
    sides = steps[max(at - apart - beside, 0) : at - apart], steps[at + apart + 1 : at + apart + 1 + beside]
    if min(side.size for side in sides) < beside:
        return False
    spread = max(usual / 3, *(spread_about_zero(side) for side in sides))
    largest = max(float(np.abs(side).max()) for side in sides)
    return bool(abs(steps[at]) > max(_CLEAR * spread, _ALONE * largest))
