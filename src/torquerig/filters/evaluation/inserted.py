"""What a chain makes of a step and of a hit that are put into the recording: its distortion of load transients."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.rise import rise_time

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage

    Floats = NDArray[np.float64]

HIT_DECAY = 4e-3  # [s] of the hit that is put in: the wear rig's at 0.5 mm
_LOOKED_AT = 0.5  # [s] around the step and after the hit


@dataclass(frozen=True, kw_only=True)
class StepShown:
    """What comes out where a step of height 1 goes in.

    Parameters
    ----------
    rise : float
        From 10 % to 90 % [s]; 0 where the step is kept.
    late : float
        When half the height is reached, from the step on [s]; negative where that is before it.
    overshoot : float
        By how much the answer exceeds 1 within half a second [1].
    foreseen : float
        The largest answer before the step, of either sign [1]: what a filter that looks ahead shows too early.
    hit_peak : float
        Peak of a hit of height 1 and 4 ms decay [1].
    """

    rise: float
    late: float
    overshoot: float
    foreseen: float
    hit_peak: float


def inserted(stage: Stage, recording: Recording) -> StepShown:
    """Return what ``stage`` makes of a step, and of a hit, as high as the torque's standard deviation.

    Both are put into the middle of the recording, and what comes out without them is subtracted: for a chain that adds
    and scales this is its step response, for one that adapts what it does to a change of this size.

    Raises
    ------
    RecordingError
        For a recording shorter than 16 samples, or a constant one, in which nothing can be compared.
    """
    torque = recording.torque()
    if torque.size < 16:
        raise RecordingError(f"{recording.name}: {torque.size} samples are too few to put a step in")
    height, at = float(torque.std()), torque.size // 2
    if not height > 0:
        raise RecordingError(
            f"{recording.name}: a constant torque gives no measure for a step; is the sensor connected?"
        )
    plain = stage.apply(recording).torque()
    time = (np.arange(torque.size) - at) / recording.sample_rate
    step = (time >= 0).astype(np.float64)
    hit = step * np.exp(-np.maximum(time, 0) / HIT_DECAY)
    answers = [(_with(stage, recording, height * shape) - plain) / height for shape in (step, hit)]
    return _shown(answers[0], answers[1], at, recording.sample_rate)


def _with(stage: Stage, recording: Recording, added: Floats) -> Floats:
    name = recording.torque_name()
    channel = recording.channels[name]
    return stage.apply(recording.with_values(name, channel.values + added / channel.si_per_unit)).torque()


def _shown(step: Floats, hit: Floats, at: int, rate: float) -> StepShown:
    reach = min(round(_LOOKED_AT * rate), at)
    around = step[at - reach : at + reach]
    half = np.flatnonzero(around >= 0.5)
    # one sample before the step belongs to it: a filter without delay is at half its height there
    return StepShown(
        rise=rise_time(around, rate, top=1.0) if half.size else float("inf"),
        late=(int(half[0]) - reach) / rate if half.size else float("inf"),
        overshoot=max(float(around[reach:].max(initial=0.0)) - 1.0, 0.0),
        foreseen=float(np.abs(around[: max(reach - 1, 0)]).max(initial=0.0)),
        hit_peak=float(hit[at - reach : at + reach].max()),
    )
