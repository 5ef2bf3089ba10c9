"""Impacts of a bearing: a band that rings, struck at an order of the shaft that need not be whole.

Impacts raise the lines near the mode that they ring. Where the highest line that is left stands far below, at a
multiple of their order, it is a comb's, whose lines beat with each other in every band: that is asked first, and
impacts of what it leaves.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import pi

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.diagnosis.looking.impacts import Impact, impact_orders
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place
from torquerig.linear_twin.twin import Twin

_AMPLITUDES = (0.003, 0.01, 0.03, 0.1, 0.3, 1.0)  # [N m]
_ASIDE = (-0.4, -0.2, 0.0, 0.2, 0.4)  # octaves that the mode may stand off the middle of the band that beats
_DAMPING = 0.05
_FAR_BELOW = 0.5  # of the middle of the band that beats
_NEAR = 0.02  # of the order of impacts, which slip by up to two per cent
_SAMPLED = 0.45  # of the sample rate: a band that goes on to its half is a click, and no mode that rings


def propose(case: Case) -> Iterator[Candidate]:
    """Yield a defect for each order at which a band's envelope beats in several runs."""
    at = loaded_part(case.nominal)
    if at is None:
        return
    turns = Twin(case.nominal).turns[case.nominal.node(at)]
    below = {"ring_frequency": _SAMPLED * min(run.rate for run in case.runs)}
    own = [place for place in case.seen[0].places if place not in case.seen[0].unknown]
    for impact in impact_orders(case.runs, own):
        if _of_a_comb(case, impact):
            continue
        ranked: list[tuple[float, Candidate]] = []
        for amplitude, octaves in product(_AMPLITUDES, _ASIDE):
            part = mechanisms.BearingDefect(
                name="bearing_defect", at=at, order_output=impact.motor_order / turns,
                ring_frequency=impact.band * 2**octaves, damping=_DAMPING, amplitude=amplitude,
            )  # fmt: skip
            knobs = (
                Knob(part.name, "amplitude", 1.0),
                Knob(part.name, "ring_frequency", 0.2),
                Knob(part.name, "damping", 0.7),
            )
            candidate = Candidate(mechanism="bearing_defect", parts=(part,), knobs=knobs, below=below)
            ranked.append((case.misfit_of(candidate.added_to(case.model.rig)), candidate))
        yield min(ranked, key=lambda item: item[0])[1]


def _of_a_comb(case: Case, impact: Impact) -> bool:
    """Whether the highest line left is far below the band, at a multiple of its beat, and one at twice its place."""
    highest = max(case.left, key=lambda peak: peak.excess, default=None)
    if highest is None or not any(_is_second(peak.place, highest.place) for peak in case.left):
        return False
    turning = [abs(run.mean_speed) / (2 * pi) for run in case.runs if run.steady and run.mean_speed]
    at = highest.place.at
    orders = [at if highest.place.domain == "order" else at / turns for turns in turning]
    times = [order / impact.motor_order for order in orders]
    return any(
        order * turns < _FAR_BELOW * impact.band and round(each) >= 1 and abs(each - round(each)) < _NEAR
        for order, turns, each in zip(orders, turning, times, strict=True)
    )


def _is_second(place: Place, first: Place) -> bool:
    return place.domain == first.domain and abs(place.at / first.at - 2) < _NEAR
