"""Jumps from one sample to the next in a signal that is smooth on either side: no shaft passes such a torque on.

An amplifier of some kHz spreads what comes from the shaft over several samples, and what is as fast as it rings: the
samples beside are large as well. A gain or a zero that jumps, and samples that are lost, stand alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, amount, fault_in_time, in_words
from torquerig.recordings.repair.mean_steps import MEAN_STEP
from torquerig.recordings.repair.moments import Moments, seams
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_BESIDE = 25  # differences on either side
_CLEAR = 14.0  # robust spreads of those, and of the run's by a third of it
_FASTEST = 5e-4  # [s] within which no torque changes: a current loop and a shaft take longer
_FEWEST = 3  # of a recording: one may be a switch of the load, and passes
_ALONE = 2.5  # times the largest of those


def without_jumps(seen: Examination) -> Examination:
    """Bridge jumps of recordings whose mean does not step; so few jumps that a load may have switched are left."""
    lost, told = list(seen.lost), list[Fault]()
    for index, recording in enumerate(seen.recordings):
        slow = recording.sample_rate * _FASTEST < 1
        if slow or seen.shows(MEAN_STEP, recording) or recording.name in seen.standing:
            continue
        jumps = sample_jumps(recording.torque_values(), lost[index], resolution=2 * seen.resolution).tolist()
        if len(jumps) >= _FEWEST:
            told.append(_fault(recording, jumps))
            lost[index] = [*lost[index], *seams(jumps, recording)]
    return replace(seen, lost=tuple(lost)).with_faults(*told)


def _fault(recording: Recording, jumps: Sequence[int]) -> Fault:
    heights = np.abs(np.diff(recording.torque_values()))[np.array(jumps) - 1]
    return fault_in_time(
        recording, "jumps", jumps[0], jumps[0] + 1,
        seen=f"at {in_words([at / recording.sample_rate for at in jumps])} the signal jumps by up to "
        f"{amount(recording, float(heights.max()))} from one sample to the next, and is smooth before and after; no "
        "torque does that, a gain or a zero that changes or lost samples do",
        repair="no mechanism of the library does that: the rest was judged with the jumps bridged",
    )  # fmt: skip


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
    return np.array([at + 1 for at in np.flatnonzero(told) if _alone(steps, int(at), usual)], dtype=np.int64)


def _alone(steps: Floats, at: int, usual: float) -> bool:
    sides = steps[max(at - _BESIDE, 0) : at], steps[at + 1 : at + 1 + _BESIDE]
    if min(side.size for side in sides) < _BESIDE:
        return False
    spread = max(usual / 3, *(spread_about_zero(side) for side in sides))
    largest = max(float(np.abs(side).max()) for side in sides)
    return bool(abs(steps[at]) > max(_CLEAR * spread, _ALONE * largest))
