"""Which planetary sets can be put together: assembly, neighbours, planet teeth, and the nearest sets that can."""

from __future__ import annotations

from math import pi, sin
from typing import Literal

Fixed = Literal["ring", "carrier", "sun"]

RATIO_KEPT = 0.02  # [1] by how much a stated ratio and that of the teeth may differ
PER_RATIO = 200.0  # [teeth] what counts as much as another ratio: one per cent is two teeth
SHIFTED = 1.0  # [teeth] by how much profile shift lets a planet differ from (ring - sun) / 2


def stage_ratio(sun: int, ring: int, fixed: Fixed = "ring") -> float:
    """Return input turns per output turn without their sign: sun to carrier, sun to ring, or ring to carrier."""
    return {"ring": 1 + ring / sun, "carrier": ring / sun, "sun": 1 + sun / ring}[fixed]


def assembly_fault(sun: int, ring: int, planets: int | None = None, planet: int | None = None) -> str:
    """Return why a set cannot be put together, or nothing where it can.

    Conditions: ``(sun + ring) / planets`` whole, so that equal planets at equal angles find the teeth; neighbours
    clear, ``(sun + planet) sin(pi / planets) > planet + 2`` with full addenda; ``ring = sun + 2 planet`` within the
    tooth that profile shift allows (21/31/84 is a real set). Source: handbook 4.2; Muller, Epicyclic Drive Trains.
    """
    natural = (ring - sun) / 2
    if natural < 1:
        return f"no planet has room between a sun of {sun} and a ring of {ring}"
    if planet is not None and abs(planet - natural) > SHIFTED:
        return f"ring = sun + 2 planet asks for planets of {natural:g} teeth, not {planet} (profile shift: one off)"
    if planets is None:
        return ""
    if (sun + ring) % planets:
        return f"(sun + ring) / planets = {(sun + ring) / planets:.4g} must be whole"
    teeth = natural if planet is None else planet
    if planets > 1 and (sun + teeth) * sin(pi / planets) <= teeth + 2:
        return f"neighbours of {teeth:g} teeth would not clear each other"
    return ""


def nearest_sets(
    sun: int, ring: int, planets: int | None, *, ratio: float, fixed: Fixed = "ring"
) -> tuple[tuple[int, int], ...]:
    """Return up to three (sun, ring) that can be put together, nearest in teeth and ratio.

    Parameters
    ----------
    sun, ring : int
        What was asked for.
    planets : int or None
        Number of equal planets.
    ratio : float
        The ratio that is wanted [1]; one per cent beside it counts as two teeth.
    fixed : {"ring", "carrier", "sun"}
    """
    suns = range(max(6, sun - 12), sun + 13)
    able = [(s, r) for s in suns for r in range(s + 2, 12 * s + 1) if not assembly_fault(s, r, planets)]

    def distance(teeth: tuple[int, int]) -> float:
        away = abs(stage_ratio(*teeth, fixed) / ratio - 1)
        return abs(teeth[0] - sun) + abs(teeth[1] - ring) + PER_RATIO * away

    return tuple(sorted(able, key=distance)[:3])


def assembly_remedy(sets: tuple[tuple[int, int], ...], ratio: float, fixed: Fixed = "ring") -> str:
    """Return the remedy that names the sets: ``near a ratio of 5, 21/84 (5) and 22/86 (4.909) can be assembled``."""
    if not sets:
        return "take fewer planets"
    named = [f"{sun}/{ring} ({stage_ratio(sun, ring, fixed):.4g})" for sun, ring in sets]
    return f"the nearest sun/ring that assemble (and their ratio; {ratio:.4g} is wanted) are {', '.join(named)}"
