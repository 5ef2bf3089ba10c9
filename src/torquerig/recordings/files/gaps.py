"""Jumps of time in a recording: lost samples, repeated ones, a clock that was set."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError

# limit of a regular step, in samples: one lost sample makes a step of two
_JUMP = 0.5


FEWEST_SAMPLES = 10
"""A step of time of ten samples or more is a pause of the logger, a shorter one a few lost samples."""
# share of the steps that are the usual one within the tolerance, where a clock samples between pauses [1]
_EVEN, _TOLERANCE = 0.9, 0.02
# steps that are too short make up for so much of the long ones where late times catch up [1]
_CAUGHT_UP = 0.5


@dataclass(frozen=True)
class Gap:
    """A step of time after sample ``sample`` that is not one sample long: at ``time`` [s], ``step`` [s]."""

    sample: int
    time: float
    step: float


def gaps_in(
    times: NDArray[np.float64], rate: float, *, first: int = 0, before: float | None = None, scatter: float = 0.0
) -> list[Gap]:
    """Return the steps that differ from one sample by half a sample or more, go back, or are not numbers.

    Parameters
    ----------
    times : ndarray, shape (samples,)
        [s].
    rate : float
        [Hz].
    first : int
        The number of the first of ``times`` in the recording.
    before : float, optional
        The time of the sample before the first one [s].
    scatter : float
        How far coarse or late stamps let a step deviate from one sample [s], in addition.
    """
    whole = times if before is None else np.concatenate([[before], times])
    steps = np.diff(whole)
    uneven = np.flatnonzero(~(np.abs(steps * rate - 1) < _JUMP + scatter * rate))
    start = first if before is None else first - 1
    return [Gap(start + int(one), float(whole[one]), float(steps[one])) for one in uneven]


def has_pauses(steps: NDArray[np.float64]) -> bool:
    """Return whether times have pauses between evenly sampled stretches, and not late stamps that catch up.

    Parameters
    ----------
    steps : ndarray, shape (samples - 1,)
        Of the times [s].
    """
    usual = float(np.median(steps))
    if not usual > 0 or np.mean(np.abs(steps / usual - 1) < _TOLERANCE) < _EVEN:
        return False
    long, short = steps[steps >= FEWEST_SAMPLES * usual], steps[steps < (1 - _JUMP) * usual]
    return bool(long.size) and float(np.sum(usual - short)) < _CAUGHT_UP * float(np.sum(long - usual))


def refuse_gaps(gaps: list[Gap], *, name: str, rate: float, where: str) -> None:
    """Raise RecordingError that names the first gap."""
    if not gaps:
        return
    one = gaps[0]
    raise RecordingError(
        f"{where}: {name} jumps by {one.step:.6g} s instead of {1 / rate:.6g} s after sample {one.sample} "
        f"({one.time:.9g} s); cut the recording there, or resample it with 'torquerig join'"
    )
