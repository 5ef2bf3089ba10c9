"""The noise that a coarse position puts into the speed of an imposed motion."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from torquerig.recordings.channel_angle import smoothing_reach, unsmoothed_angle_of
from torquerig.recordings.replay import ANGLES

if TYPE_CHECKING:
    from torquerig.recordings.recording import Channel

_SEEN = 0.01  # [1] of the rms speed: as much as a set-point is off
_WHOLE = 0.02  # deviation from whole steps [steps]
_ROUNDING = 1e-9  # [1] of the range of a channel: smaller steps are rounding errors of the file
_SPAN = 0.05  # [s] over which the speed is taken: longer than steps of slow motions, shorter than their changes


def resolution_of(channel: Channel) -> float | None:
    """Return the step in which an angle or position is recorded, in SI; None where no step is seen."""
    if channel.unit == "count":
        return abs(channel.si_per_unit)
    values = channel.in_si()
    between = np.diff(np.unique(values))
    if between.size < 2:
        return None
    step = float(between.min())
    whole, moved = between / step, np.round(np.diff(values) / step)
    is_stepped = step > _ROUNDING * float(np.ptp(values)) and np.all(np.abs(whole - np.round(whole)) < _WHOLE)
    # an even motion has equal steps at any resolution
    return step if is_stepped and np.unique(moved).size > 1 else None


def noisy_speed(channel: Channel, rate: float, *, name: str) -> str | None:
    """Return a sentence where the steps of an imposed angle or position put noise into its speed, else None.

    Parameters
    ----------
    channel : Channel
        Whose derivative drives the model.
    rate : float
        Of its samples [Hz].
    name : str
        Of the channel.

    Notes
    -----
    A value that is rounded to steps q is off by q / sqrt(12) rms. The difference of two such values, each the mean of n
    samples (counts are smoothed), over n sample intervals is off by q rate / (n sqrt(6)). Source: Widrow & Kollar 2008,
    Quantization Noise, chapter 3, on the uniform error of rounding. Rounding errors of samples that stay within one
    step are correlated, and the noise is then smaller.
    """
    if channel.quantity not in ANGLES or channel.values.size < 4:
        return None
    step = resolution_of(channel)
    if step is None:
        return None
    place = unsmoothed_angle_of(channel)
    span = max(round(rate * _SPAN), 1)
    speed = float(np.sqrt(np.mean((place[span:] - place[:-span]) ** 2))) * rate / span if place.size > span else 0.0
    means = 2 * smoothing_reach(channel, rate) + 1 if channel.unit == "count" else 1
    noise = step * rate / (means * sqrt(6))
    if not speed or noise <= _SEEN * speed:
        return None
    unit = "m" if channel.quantity == "position" else "rad"
    return (
        f"{name} is recorded in steps of {step:.3g} {unit}: over a sample of {1e3 / rate:.3g} ms this is a noise of "
        f"{noise:.3g} {unit}/s in its speed, {100 * noise / speed:.2g} % of {speed:.3g} {unit}/s rms, and "
        "inertias turn it into torque; low-pass the channel, record with a finer encoder, or impose a measured speed"
    )
