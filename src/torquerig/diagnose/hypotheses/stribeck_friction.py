"""Dry friction at the loaded part, with a peak near standstill."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from torquerig import mechanisms
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.knobs import Knob
from torquerig.diagnose.loaded_part import loaded_part

_COULOMB, _PEAKS, _SPEEDS = (0.03, 0.1, 0.3, 0.8), (1.1, 2.0), (0.3, 1.0, 3.0)  # [N m], [1], [rad/s]


def propose(case: Case) -> Iterator[Candidate]:
    """Yield the friction curve that fits best among a few sizes, peaks and Stribeck speeds."""
    at = loaded_part(case.nominal)
    if at is None:
        return
    ranked: list[tuple[float, Candidate]] = []
    for coulomb, peak, speed in product(_COULOMB, _PEAKS, _SPEEDS):
        part = mechanisms.StribeckFriction(
            name="stribeck_friction", at=at, coulomb=coulomb, static=coulomb * peak, stribeck_speed=speed
        )
        knobs = tuple(Knob(part.name, field, 0.8) for field in ("coulomb", "static", "stribeck_speed"))
        candidate = Candidate(mechanism="stribeck_friction", parts=(part,), knobs=knobs)
        ranked.append((case.misfit_of(candidate.added_to(case.model.rig)), candidate))
    yield min(ranked, key=lambda item: item[0])[1]
