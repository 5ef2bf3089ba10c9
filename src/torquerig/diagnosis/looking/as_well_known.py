"""A simulated run whose angle is known no better than the recording's, so that what is read off both errs alike."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.signal import butter, sosfiltfilt

from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.motor_angle.smoothed_speed import speed_of

_FOLLOWED = 1.0  # [Hz] up to which lines of the torque, or a simulated set-point, tell how the shaft turned
_SETTLED = 2.0  # periods of that, over which the filter begins and ends


def as_well_known(copy: Observed, recorded: Observed) -> Observed:
    """Return the simulated ``copy`` of a run, its true angle less what nobody would know where none was measured.

    What is lost is the ripple of the speed: the angle is filtered forwards and backwards (Butterworth, 2nd order,
    1 Hz), beside the straight line through its ends.
    """
    if recorded.angle_measured:
        return copy
    line = np.linspace(copy.angle[0], copy.angle[-1], copy.angle.size)
    sections = butter(2, _FOLLOWED, fs=copy.rate, output="sos")
    padding = min(copy.angle.size - 1, round(_SETTLED / _FOLLOWED * copy.rate))
    angle = line + sosfiltfilt(sections, copy.angle - line, padlen=padding)
    return replace(copy, angle=angle, speed=speed_of(angle, copy.rate), angle_measured=False)
