"""Rms error of a reading against the true load, which a simulation knows or a second sensor measured."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.metrics.measured_load import measured_load

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

TRUE_LOAD = "true_load_Nm"
TRUE_LOADS = (TRUE_LOAD, "true_load_N")
"""Channel of the true load of a simulated rig that turns, and of one that moves in a line."""


def true_load(recording: Recording) -> NDArray[np.float64] | None:
    """Return the true load [N m], in a line [N], shape (samples,), else a measured one; None where neither is known."""
    name = next((one for one in TRUE_LOADS if one in recording.channels), None)
    if name is not None:
        return recording.channels[name].in_si()
    measured = measured_load(recording)
    return None if measured is None else measured.values


def truth_error(reading: Recording, truth: Recording) -> float:
    """Return the rms of reading minus true load [N m], in a line [N], mean included.

    The true load is all that opposes the motion at the wear part, disturbance lines excluded, referred to the measured
    shaft by the ratio between (losses between are part of the error). The error
    consists of residual lines behind the filter, lost parts of the load, and shaft vibration due to the load, which no
    notch removes.

    Raises
    ------
    RecordingError
        When ``truth`` has no channel of the true load and none of a measured one.
    """
    return float(np.sqrt(np.mean(difference(reading, truth) ** 2)))


def difference(reading: Recording, truth: Recording) -> NDArray[np.float64]:
    """Return reading minus true load [N m], shape (samples,); RecordingError as for :func:`truth_error`."""
    load = true_load(truth)
    if load is None:
        raise RecordingError(f"{truth.name}: the true load is not known; only a simulated recording has {TRUE_LOAD}, "
                             "or a measured one a channel with of: load")  # fmt: skip
    return np.asarray(reading.torque() - load, dtype=np.float64)
