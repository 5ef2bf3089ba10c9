"""Response of a filter chain to a step and a hit that are added to the recording: its distortion of load transients."""

from __future__ import annotations

from dataclasses import dataclass
from math import copysign
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.load_scale import WEAR_PART
from torquerig.filters.evaluation.rise import rise_time

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage

    Floats = NDArray[np.float64]

_WINDOW = 125.0  # decay times of a hit that are evaluated on either side of the step and the hit


@dataclass(frozen=True, kw_only=True)
class StepResponse:
    """Response to a step of height 1.

    Parameters
    ----------
    rise : float
        Rise time from 10 % to 90 % [s]; 0 where the step is not changed.
    late : float
        Time from the step to half the height [s]; negative where that is before it.
    overshoot : float
        Overshoot above 1 within 125 decay times of a hit, half a second at 4 ms [1].
    pre_ringing : float
        The largest response before the step, of either sign [1], in a filter that is not causal.
    hit_peak : float
        Peak of a hit of height 1 that decays in ``hit_decay`` [1].
    hit_decay : float
        [s].
    """

    rise: float
    late: float
    overshoot: float
    pre_ringing: float
    hit_peak: float
    hit_decay: float = WEAR_PART.hit_decay


def step_response(stage: Stage, recording: Recording, *, decay: float = WEAR_PART.hit_decay) -> StepResponse:
    """Return the response of ``stage`` to a step and a hit as high as the torque's standard deviation.

    Both are added in the middle of the recording, in the direction of the mean torque, and the output without them is
    subtracted; the hit decays in ``decay`` [s]. For a linear chain this is the step response; for an adaptive one it
    is the response to a change of this size.

    Raises
    ------
    RecordingError
        For a recording shorter than 16 samples, or a constant one, which gives no height for the step.
    """
    torque = recording.torque()
    if torque.size < 16:
        raise RecordingError(f"{recording.name}: {torque.size} samples are too few for a step response")
    height, at = float(torque.std()), torque.size // 2
    if not height > 0:
        raise RecordingError(
            f"{recording.name}: the torque is constant, so that a step has no height; is the sensor connected?"
        )
    height = copysign(height, float(torque.mean()))
    plain = stage.apply(recording).torque()
    time = (np.arange(torque.size) - at) / recording.sample_rate
    step = (time >= 0).astype(np.float64)
    hit = step * np.exp(-np.maximum(time, 0) / decay)
    responses = [(_with(stage, recording, height * shape) - plain) / height for shape in (step, hit)]
    return _figures(responses[0], responses[1], at, recording.sample_rate, decay)


def _with(stage: Stage, recording: Recording, added: Floats) -> Floats:
    name = recording.torque_name()
    channel = recording.channels[name]
    return stage.apply(recording.with_values(name, channel.values + added / channel.si_per_unit)).torque()


def _figures(step: Floats, hit: Floats, at: int, rate: float, decay: float) -> StepResponse:
    reach = min(round(_WINDOW * decay * rate), at)
    around = step[at - reach : at + reach]
    half = np.flatnonzero(around >= 0.5)
    # one sample before the step belongs to it, because a zero-phase filter has half the height there
    return StepResponse(
        rise=rise_time(around, rate, top=1.0) if half.size else float("inf"),
        late=(int(half[0]) - reach) / rate if half.size else float("inf"),
        overshoot=max(float(around[reach:].max(initial=0.0)) - 1.0, 0.0),
        pre_ringing=float(np.abs(around[: max(reach - 1, 0)]).max(initial=0.0)),
        hit_peak=float(hit[at - reach : at + reach].max()),
        hit_decay=decay,
    )
