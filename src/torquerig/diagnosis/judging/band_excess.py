"""By how much a steady run's spectrum lies above the model's, band by band: what two runs are compared by."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.correction import Correction, corrected
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.looking.features import Features

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class BandExcess:
    """Of one run, in each band.

    Parameters
    ----------
    features : Features
    log : ndarray, shape (bands,)
        Logarithm of measured over expected density [1], not finite where lines leave nothing.
    load_share : ndarray, shape (bands,)
        Part of the expected density that the load makes [1].
    variance : ndarray, shape (bands,)
        Of ``log``, by the number of independent values alone.
    doubt : ndarray, shape (bands,)
        By how much the model says that ``log`` may be off [1].
    """

    features: Features
    log: Floats
    load_share: Floats
    variance: Floats
    doubt: Floats


def band_excesses(case: Case, beyond: Sequence[Correction] = ()) -> list[BandExcess]:
    """Return the excess of every steady run over the case's twin, corrected for what it has ``beyond`` that twin."""
    answer = []
    corrections: Sequence[Correction | None] = beyond or [None] * len(case.seen)
    for features, correction in zip(case.seen, corrections, strict=True):
        if features.turning is None and features.power.size:
            model = expected(case.model.rig, features)
            model = model if correction is None else corrected(model, correction)
            share = np.broadcast_to(model.load_share, features.band.shape)
            with np.errstate(divide="ignore"):  # a band that holds nothing is not compared
                excess = np.log(features.power / model.power)
            doubt = np.broadcast_to(model.power_tolerance, features.band.shape)
            answer.append(BandExcess(features, excess, share, 1 / features.count, doubt))
    return answer
