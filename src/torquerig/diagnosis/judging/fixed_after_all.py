"""Lines that were looked at as orders, at one speed, and were found to keep their frequency.

A simulation of the found tone turns with its own wander, so at an order it would not be looked for where it stands.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import misfits_of
from torquerig.diagnosis.fitting.misfit import misfit_sum
from torquerig.diagnosis.looking.features import Features, features
from torquerig.inference.places import Place

_NEAR = 0.01  # of its frequency: the speed that turned it into an order may have been another run's


def looked_at_as_found(case: Case, held: Sequence[Features]) -> tuple[Case, tuple[Features, ...]]:
    """Return the case and what was held out, each line looked at in the domain in which the search explained it."""
    swaps = _swaps(case)
    if not swaps:
        return case, tuple(held)

    def again(one: Features) -> Features:
        places, unknown = ([swaps.get(place, place) for place in each] for each in (one.places, one.unknown))
        return features(one.observed, places, held=one.held, unknown=unknown)

    seen = tuple(again(one) for one in case.seen)
    misfits = tuple(misfits_of(case.model.rig, seen, case.model.corrections or None))
    cost = misfit_sum(misfits) + float(case.model.positions @ case.model.positions)
    model = replace(case.model, misfits=misfits, cost=cost)
    return replace(case, seen=seen, model=model), tuple(again(one) for one in held)


def _swaps(case: Case) -> dict[Place, Place]:
    """Return the orders among the places at which an accepted tone of fixed frequency stands, and its frequency."""
    steady = [run for run in case.runs if run.steady]
    answer: dict[Place, Place] = {}
    for candidate in case.accepted:
        tone = candidate.place
        if tone is None or tone.domain == "order" or tone in case.seen[0].places or not steady:
            continue
        orders = [place for place in case.seen[0].places if place.domain == "order"]
        apart = {place: abs(place.frequency(steady[0].mean_speed) - tone.at) for place in orders}
        nearest = min(apart, key=lambda place: apart[place], default=None)
        if nearest is not None and apart[nearest] < _NEAR * tone.at:
            answer[nearest] = tone
    return answer
