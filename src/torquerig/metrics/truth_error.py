"""How far a reading is from the true load, which only a simulation knows."""

from __future__ import annotations

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.recording import Recording

TRUE_LOAD = "true_load_Nm"


def truth_error(reading: Recording, truth: Recording) -> float:
    """Return the rms of reading minus true load [N m], mean included.

    The true load is all that opposes the motion at the wear part, disturbance lines excluded. The error holds what the
    filter left of the lines, what it took of the load, and the load's ringing of the shaft, which no notch removes.

    Raises
    ------
    RecordingError
        When ``truth`` has no channel of the true load, as every measured recording.
    """
    if TRUE_LOAD not in truth.channels:
        raise RecordingError(f"{truth.name}: the true load is not known; only a simulated recording has {TRUE_LOAD}")
    return float(np.sqrt(np.mean((reading.torque() - truth.channels[TRUE_LOAD].values) ** 2)))
