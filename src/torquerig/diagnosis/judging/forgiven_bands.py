"""Which residuals of bands are forgiven: those of bands that are filled by what has a spectrum of its own."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.added_signals import rung_by
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.misfit import BAND_TOLERANCE
from torquerig.diagnosis.looking.features import Features
from torquerig.linear_twin.twin import Twin

Floats = NDArray[np.float64]

_LOAD_SHAPE = 0.35  # of the logarithm: pulses of another shape leave nulls and humps of 1.5 dB and more
_RING_SHAPE = 0.6  # of the logarithm, as the fit has it on the flanks of a ring
_SLOPE = 2.0  # of the logarithm per factor e away from the ring: its reading may be a displacement, a speed or between
_PATH = 2.3  # at most: no path from a bearing through the shafts is 10 dB beside what is smooth


def forgiven(case: Case, features: Features, residuals: Floats) -> Floats:
    """Return the residuals of a run's bands less what a random load and the rings of a bearing may be forgiven.

    Parameters
    ----------
    residuals : ndarray, shape (bands,)
        In units of their spread, above 0 where more was measured than is expected.

    Notes
    -----
    A load's pulses have a spectrum of their own. An impact rings a mode whose reading grows with the frequency, or
    falls, by its distance from the mode, and reaches the sensor through shafts with modes of their own: a share s of
    the density that may be a factor k more or less moves the logarithm of the whole by ``ln(1 + s (k - 1))`` or
    ``ln(1 - s (1 - 1/k))``.
    """
    twin, power = Twin(case.model.rig.at(features.observed.run)), expected(case.model.rig, features).power
    load = np.clip(twin.load_power_between(*features.band_edges) / power, 0.0, 1.0)
    squared = (_LOAD_SHAPE * load) ** 2
    for stage, density in rung_by(twin, features):
        share = np.clip(density / power, 0.0, 0.99)
        off = np.exp(np.clip(_SLOPE * np.abs(np.log(features.band / stage.frequency)), _RING_SHAPE, _PATH))
        squared += np.where(residuals > 0, np.log1p(share * (off - 1)), np.log1p(-share * (1 - 1 / off))) ** 2
    tight = 1 / features.count + BAND_TOLERANCE**2
    return np.asarray(residuals * np.sqrt(tight / (tight + squared)))
