"""Lines that are but the detail of an effect that was found: no law of an effect tells all of its harmonics."""

from __future__ import annotations

import numpy as np

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import SAME_ORDER, Place

_LAW = 0.05  # of an effect's own line: no law of an effect tells its harmonics to better
_NEAR = 0.02  # of the order of impacts, which slip by up to two per cent: so near to a multiple a line is theirs


def of_an_effect(case: Case, features: Features, column: int) -> bool:
    """Whether the line in this ``column`` of a run belongs to an effect that is in the case's model already.

    The impacts of a bearing make lines at every multiple of their order: how much of each is line, and how much is
    smeared over the band beside it, goes with how they slip, which nobody knows (Randall & Antoni 2011, Mechanical
    Systems and Signal Processing 25(2)).
    """
    return of_impacts(case, features.places[column], features.observed) or _of_its_law(case, features, column)


def of_impacts(case: Case, place: Place, run: Observed) -> bool:
    """Whether a line that a run shows stands at a multiple of the order of impacts that are in the case's model."""
    ratio, turns_a_second = abs(case.nominal.run.gear_ratio or 1.0), abs(run.mean_speed) / (2 * np.pi)
    if place.domain == "frequency" and not (run.steady and turns_a_second):
        return False
    # a line that one run alone shows may be told at its frequency
    at = place.at if place.domain == "order" else place.at / turns_a_second
    own = {part.name for candidate in case.accepted for part in candidate.parts}
    orders = [part.order / ratio for part in case.model.rig.of_kind("bearing_defect") if part.name in own]
    times = [at / each for each in orders]
    return any(round(one) >= 1 and abs(one - round(one)) < _NEAR for one in times)


def _of_its_law(case: Case, features: Features, column: int) -> bool:
    """Whether a line is but the detail of an effect's law: a multiple of its order, and small beside its own line."""
    place, shown = features.places[column], np.isfinite(features.amplitude)
    squares = np.where(shown, np.abs(features.amplitude) ** 2, 0.0).sum(axis=0)
    size = np.sqrt(squares / np.maximum(shown.sum(axis=0), 1))
    for candidate in case.accepted:
        own = candidate.place
        if own is None or own.domain != place.domain or own not in features.places:
            continue
        times = place.at / own.at
        multiple = round(times) > 1 and abs(times - round(times)) * own.at < SAME_ORDER
        if multiple and size[column] < _LAW * size[features.places.index(own)]:
            return True
    return False
