"""Steps of the mean: within some milliseconds the torque stands higher or lower, and stays there.

A random load wanders and a zero that settles creeps: either moves in a quarter of a second, but not in a fiftieth of
one. Where a shaft starts or turns back friction steps, so these times are left out. A signal that rests on its limit
for much of a run stands still there and seems to step when it leaves it; such runs are left out too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.extremes import extreme_of
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.examination import Examination
from torquerig.recordings.repair.faults import Fault, amount, fault_in_time, in_words
from torquerig.recordings.repair.moments import Moments
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

MEAN_STEP = "mean step"
_LOOKED_AT = ("steady", "ramp")
_BLOCK = 0.01  # [s] over which the signal is averaged
_SHORT, _LONG = 5, 25  # blocks on either side whose means are compared
_OF_THE_LONG = 0.6  # of a step must stand within the short time, or it is no step but a slope
# spreads in one run, or less where another shows some too: of 554 clean runs five reach 3.5 and none 4
_CLEAR, _LESS = 6.0, 4.2
_LEAST = 4.0  # spreads of a step that counts as another
_MOST = 40  # steps of a run
_STARTING = 0.125  # of a run whose speed moves, at either end, where it may stand
_SMALLEST = 0.01  # of the range of the block means: a spread is not taken for less
_ON_A_LIMIT = 0.2  # of a run's samples: most blocks then tell where the limit is, not where the torque was
_FEW = 3  # of a recording: a mean that steps to and fro is not put right by taking out those that are seen
_TAKEN_OUT = "the rest was judged with the steps taken out"
_LEFT_IN = "there are too many of them to put the rest right"
_HALF_EDGE = 0.015  # [s] either way in which the signal is on its way


@dataclass(frozen=True)
class MeanStep:
    """At ``sample`` the signal steps by ``height`` [its unit], ``clear`` spreads of such differences."""

    sample: int
    height: float
    clear: float


def without_mean_steps(seen: Examination) -> Examination:
    """Remove steps of the mean where they are few."""
    answer, lost, told = list(seen.recordings), [list(each) for each in seen.lost], list[Fault]()
    steps_of_each = mean_steps(answer, seen.lost, resolution=seen.resolution)
    few = max(map(len, steps_of_each), default=0) <= _FEW
    for index, steps in enumerate(steps_of_each):
        if steps:
            told.append(_fault(answer[index], steps, taken_out=few))
        if steps and few:
            lost[index] += edges(answer[index], steps)
            answer[index] = without_steps(answer[index], steps)
    stepping = seen.stepping or any(steps_of_each)
    return replace(seen, recordings=tuple(answer), lost=tuple(lost), stepping=stepping).with_faults(*told)


def _fault(recording: Recording, steps: Sequence[MeanStep], *, taken_out: bool) -> Fault:
    rate, largest = recording.sample_rate, max(steps, key=lambda each: abs(each.height))
    stop = steps[1].sample if len(steps) > 1 else recording.samples
    return fault_in_time(
        recording, MEAN_STEP, steps[0].sample, stop, excess=20 * float(np.log10(largest.clear)),
        seen=f"at {in_words([each.sample / rate for each in steps])} the mean steps by up to "
        f"{amount(recording, abs(largest.height))} within some milliseconds and stays there; a load that changes or a "
        "zero that jumps does that",
        repair=f"no mechanism of the library does that: {_TAKEN_OUT if taken_out else _LEFT_IN}",
    )  # fmt: skip


def mean_steps(
    recordings: Sequence[Recording], lost: Sequence[Moments] = (), *, resolution: float = 0.0
) -> tuple[tuple[MeanStep, ...], ...]:
    """Return the steps of each recording, in their order; none in all where none of a steady one is clear.

    A shaft that starts under a torque which turns with it sticks and slips, so a ramp alone tells nothing.

    Parameters
    ----------
    recordings : sequence of Recording
        Moments without signal bridged. Those that turn back or follow a measured motion are not looked at.
    lost : sequence of Moments
        Those moments of each recording, whose ends are no steps of the torque.
    resolution : float
        Half a code [V], 0 where it is not known: a signal that rests on a code steps to the next.
    """
    moments = lost or [()] * len(recordings)
    found = [_steps(recording, own, resolution) for recording, own in zip(recordings, moments, strict=True)]
    steady = [steps for each, steps in zip(recordings, found, strict=True) if steps and each.run.profile == "steady"]
    clearest = max((step.clear for steps in steady for step in steps), default=0.0)
    if clearest <= (_LESS if len(steady) > 1 else _CLEAR):
        return ((),) * len(found)
    return tuple(tuple(sorted(steps, key=lambda step: step.sample)) for steps in found)


def without_steps(recording: Recording, steps: Sequence[MeanStep]) -> Recording:
    """Return the recording as it would stand without the steps: what follows each is moved back by its height."""
    name = recording.torque_name()
    values = recording.channels[name].values.copy()
    for step in steps:
        values[step.sample :] -= step.height
    return recording.with_values(name, values)


def edges(recording: Recording, steps: Sequence[MeanStep]) -> Moments:
    """Return the moments in which the signal is on its way, first sample and one past the last."""
    reach = int(_HALF_EDGE * recording.sample_rate)
    return [(max(each.sample - reach, 0), min(each.sample + reach, recording.samples)) for each in steps]


def _steps(recording: Recording, lost: Moments, resolution: float) -> list[MeanStep]:
    """Return all steps of a run, the clearest first, each found with the clearer ones taken out."""
    if recording.run.profile not in _LOOKED_AT or _on_a_limit(recording) > _ON_A_LIMIT:
        return []
    found: list[MeanStep] = []
    while len(found) < _MOST:
        step = _clearest(without_steps(recording, found), lost, resolution)
        if step is None or step.clear < _LEAST:
            break
        found.append(step)
    return found


def _on_a_limit(recording: Recording) -> float:
    """Return the part of the samples that rest on the signal's highest or lowest value."""
    volts = recording.torque_values()
    return (extreme_of(volts).clipped + extreme_of(-volts).clipped) / volts.size


def _clearest(recording: Recording, lost: Moments, resolution: float) -> MeanStep | None:
    volts = recording.torque_values()
    size = max(1, round(_BLOCK * recording.sample_rate))
    count = volts.size // size
    if count < 4 * _LONG:
        return None
    means = volts[: count * size].reshape(count, size).mean(axis=1)
    floor = max(_SMALLEST * float(np.ptp(means)), resolution, 1e-12)
    at = np.arange(_LONG, count - _LONG)
    near, far = (_differences(means, at, reach) for reach in (_SHORT, _LONG))
    clear = np.minimum(np.abs(near) / _spread(near, floor), np.abs(far) / _spread(far, floor))
    clear[near * far < _OF_THE_LONG * far**2] = 0.0
    if recording.run.profile != "steady":
        clear[(at < _STARTING * count) | (at > (1 - _STARTING) * count)] = 0.0
    for start, stop in lost:
        clear[(at > start / size - _SHORT - 1) & (at < stop / size + _SHORT + 1)] = 0.0
    best = int(np.argmax(clear))
    return MeanStep(_sample(volts, int(at[best]) * size + size // 2, size), float(far[best]), float(clear[best]))


def _differences(means: Floats, at: NDArray[np.int64], reach: int) -> Floats:
    """Return by how much the mean of the blocks after one is above that of the blocks before it."""
    total = np.concatenate([[0.0], np.cumsum(means)])
    after = total[at + 1 + reach] - total[at + 1]
    return np.asarray((after - (total[at] - total[at - reach])) / reach)


def _spread(differences: Floats, floor: float) -> float:
    return max(spread_about_zero(differences), floor)


def _sample(volts: Floats, middle: int, size: int) -> int:
    """Return the sample within a block of ``middle`` before and after which the means differ most."""
    at = np.arange(max(middle - size, size), min(middle + size, volts.size - size))
    total = np.concatenate([[0.0], np.cumsum(volts)])
    change = total[at + size] - 2 * total[at] + total[at - size]
    return int(at[np.argmax(np.abs(change))])
