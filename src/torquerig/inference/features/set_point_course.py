"""How fast the set-point of the speed changes within the blocks of a run, as a spectrum in its bands.

A set-point that bends (the end of a ramp, the top of a sine) has a course that no straight line takes out of a block,
and the torque that accelerates the shafts follows it. It is known and not random, but small and slow: its mean square
in each band is all that is needed.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.features.bands import bands
from torquerig.inference.features.segment import Segment
from torquerig.inference.measured_run import MeasuredRun
from torquerig.recordings.set_point import set_point_profile

Floats = NDArray[np.float64]


def acceleration_density(run: MeasuredRun, segments: Sequence[Segment]) -> Floats:
    """Return the mean density of the set-point's acceleration [(rad/s^2)^2/Hz], shape (segments, bands); 0 if steady.

    Each block has its mean and its straight line removed and a Hann window, as the torque has.
    """
    answer = np.zeros((len(segments), segments[0].bands.low.size if segments else 0))
    try:
        speed = None if run.is_steady else set_point_profile(run.recording, "the acceleration of a run")
    except TorquerigError:
        speed = None
    if speed is None:
        return answer
    acceleration, nothing = np.gradient(speed) * run.rate, np.zeros(0)
    for row, segment in enumerate(segments):
        courses = [acceleration[block.samples] for block in segment.blocks]
        own = bands(courses, [(nothing, nothing)] * len(courses), run.rate, slowest=run.slowest)
        answer[row] = np.nan_to_num(own.power)
    return answer
