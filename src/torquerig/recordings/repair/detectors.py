"""The detectors of faults of samples, in their order: each works on what the ones before it have repaired."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.clipping import within_limits
from torquerig.recordings.repair.coarse_codes import of_codes
from torquerig.recordings.repair.common_dropouts import without_dropouts
from torquerig.recordings.repair.examination import Detector, Examination, recordings_to_examine
from torquerig.recordings.repair.gain_changes import one_gain
from torquerig.recordings.repair.held_samples import renewed
from torquerig.recordings.repair.mean_steps import without_mean_steps
from torquerig.recordings.repair.sample_jumps import without_jumps
from torquerig.recordings.repair.slips_removed import without_strikes
from torquerig.recordings.repair.sweeps import without_sweeps
from torquerig.recordings.repair.telegraph_noise import one_level
from torquerig.recordings.repair.time_base import on_one_time_base

DETECTORS: tuple[Detector, ...] = (
    renewed,
    of_codes,
    without_dropouts,
    within_limits,
    on_one_time_base,
    without_strikes,
    one_level,
    one_gain,
    without_mean_steps,
    without_jumps,
    without_sweeps,
)


def examined(recordings: Sequence[Recording], *, converter_step: float = 0.0, full_range: float = inf) -> Examination:
    """Return what the samples of recordings of one rig show, and the recordings repaired.

    Parameters
    ----------
    recordings : sequence of Recording
    converter_step, full_range : float
        Of the converter [V]; 0 and infinity where they are not known.
    """
    seen = recordings_to_examine(tuple(recordings), converter_step=converter_step, full_range=full_range)
    for detector in DETECTORS:
        seen = detector(seen)
    return seen
