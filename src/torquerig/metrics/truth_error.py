"""Rms error of a reading against the true load, which only a simulation knows."""

from __future__ import annotations

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.recording import Recording

TRUE_LOAD = "true_load_Nm"


def truth_error(reading: Recording, truth: Recording) -> float:
    """Return the rms of reading minus true load [N m], mean included.

    The true load is all that opposes the motion at the wear part, disturbance lines excluded. The error
    consists of residual lines behind the filter, lost parts of the load, and shaft vibration due to the load, which no
    notch removes.

    Raises
    ------
    RecordingError
        When ``truth`` has no channel of the true load, as every measured recording.
    """
    if TRUE_LOAD not in truth.channels:
        raise RecordingError(f"{truth.name}: the true load is not known; only a simulated recording has {TRUE_LOAD}")
    return float(np.sqrt(np.mean((reading.torque() - truth.channels[TRUE_LOAD].values) ** 2)))
