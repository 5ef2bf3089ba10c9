"""Faults of the samples that no mechanism makes: repaired before any fit, and stated in one sentence each.

A recording in which the detectors of ``recordings.repair`` find none of them is compared as it was read. Steps of the
mean are left in: they are a hypothesis, a course of the zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.sample_faults import SampleFaults, converter_of, covered
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.detectors import DETECTORS
from torquerig.recordings.repair.examination import Examination, recordings_to_examine
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.mean_steps import without_mean_steps
from torquerig.recordings.repair.moments import bridged
from torquerig.rig.assembly import Rig


@dataclass(frozen=True, eq=False)
class SamplesAsCompared:
    """Recordings as they are compared, and what was done to their samples before.

    Parameters
    ----------
    faults : SampleFaults
        The repaired recordings, and the faults that have a mechanism.
    untrue : tuple of Fault
        Those that have none.
    sentences : tuple of str
        What was found and repaired, or left out of the comparison, in which recording.
    """

    faults: SampleFaults
    untrue: tuple[Fault, ...]
    sentences: tuple[str, ...]


def samples_as_compared(recordings: Sequence[Recording], rig: Rig, faults: SampleFaults) -> SamplesAsCompared:
    """Return the recordings with all faults of their samples repaired.

    Of a recording with many samples at a limit nothing else is said: between them it is quiet for that reason.

    Parameters
    ----------
    recordings : sequence of Recording
        As they were read.
    faults : SampleFaults
        Of these: what mechanisms make.
    """
    seen = _examined(recordings, rig)
    stuck = {each.name for each, flags in zip(recordings, faults.unusable, strict=True) if flags.any()}
    untrue = tuple(
        fault for fault in seen.faults
        if fault.mechanism in faults.nameless or (fault.mechanism is None and fault.recording not in stuck)
    )  # fmt: skip
    shown = {fault.recording for fault in untrue} - stuck
    repaired, lost = [], []
    for row, recording in enumerate(recordings):
        if recording.name in shown:
            moments = seen.lost[row]
            repaired.append(bridged(seen.recordings[row], moments))
            lost.append(faults.lost[row] | covered(((*moment, 0.0) for moment in moments), recording.samples))
        else:
            repaired.append(faults.recordings[row])
            lost.append(faults.lost[row])
    sentences = (*(fault.sentence for fault in untrue), *_of_mechanisms(recordings, faults))
    return SamplesAsCompared(replace(faults, recordings=tuple(repaired), lost=tuple(lost)), untrue, sentences)


def _examined(recordings: Sequence[Recording], rig: Rig) -> Examination:
    full, step = converter_of(rig)
    seen = recordings_to_examine(tuple(recordings), converter_step=step, full_range=full)
    for detector in DETECTORS:
        seen = seen if detector is without_mean_steps else detector(seen)
    return seen


def _of_mechanisms(recordings: Sequence[Recording], faults: SampleFaults) -> Iterator[str]:
    """Yield what was done about samples at a limit and about moments without a signal."""
    for row, recording in enumerate(recordings):
        lost, stuck = faults.lost[row], faults.unusable[row]
        changed = recording.torque_values() != faults.recordings[row].torque_values()
        if lost.any():
            yield (
                f"{recording.name}: {_parts(lost)} without a signal, {_share(lost)} of the samples, were interpolated "
                "by straight lines; the regression of lines leaves them out"
            )
        if stuck.any():
            yield (
                f"{recording.name}: {_share(stuck)} of the samples are at a limit, too many to rebuild; only blocks "
                "without such samples are compared, if there are enough of them"
            )
        elif (changed & ~lost).any():
            yield f"{recording.name}: {_share(changed & ~lost)} of the samples are at a limit; cubics replace them"


def _parts(flags: NDArray[np.bool_]) -> str:
    count = int(np.diff(flags.astype(np.int8), prepend=0).clip(min=0).sum())
    return f"{count} moment{'s' * (count != 1)}"


def _share(flags: NDArray[np.bool_]) -> str:
    return f"{100 * float(flags.mean()):.2g} %"
