"""Assembly conditions of planetary sets, and the nearest sets that meet them."""

from __future__ import annotations

from math import pi, sin
from typing import Literal

Fixed = Literal["ring", "carrier", "sun"]

RATIO_KEPT = 0.02  # [1] largest relative difference of a stated ratio and that of the teeth
PER_RATIO = 200.0  # [teeth] weight of a relative change of ratio: one per cent counts as two teeth
SHIFTED = 1.0  # [teeth] largest difference of a planet from (ring - sun) / 2 that profile shift allows


def stage_ratio(sun: int, ring: int, fixed: Fixed = "ring") -> float:
    """Return input turns per output turn without sign [1]: sun to carrier, sun to ring, or ring to carrier."""
    return {"ring": 1 + ring / sun, "carrier": ring / sun, "sun": 1 + sun / ring}[fixed]


def assembly_fault(sun: int, ring: int, planets: int | None = None, planet: int | None = None) -> str:
    """Return the assembly condition that a set violates, in words; empty where it violates none.

    Conditions: ``(sun + ring) / planets`` whole, so that equal planets at equal angles find the teeth; neighbours
    clear, ``(sun + planet) sin(pi / planets) > planet + 2`` with full addenda; ``ring = sun + 2 planet`` within the
    tooth that profile shift allows (21/31/84 is a real set). Source: handbook 4.2; Muller, Epicyclic Drive Trains.
    """
    natural = (ring - sun) / 2
    if natural < 1:
        return f"no planet fits between a sun of {sun} and a ring of {ring}"
    if planet is not None and abs(planet - natural) > SHIFTED:
        return (
            f"ring = sun + 2 planet requires planets of {natural:g} teeth, not {planet} (profile shift allows one off)"
        )
    if planets is None:
        return ""
    if (sun + ring) % planets:
        return f"(sun + ring) / planets = {(sun + ring) / planets:.4g} must be whole"
    teeth = natural if planet is None else planet
    if planets > 1 and (sun + teeth) * sin(pi / planets) <= teeth + 2:
        return f"neighbouring planets of {teeth:g} teeth would collide"
    return ""


def nearest_sets(
    sun: int, ring: int, planets: int | None, *, ratio: float, fixed: Fixed = "ring"
) -> tuple[tuple[int, int], ...]:
    """Return up to three (sun, ring) that can be assembled, nearest in teeth and ratio.

    Parameters
    ----------
    sun, ring : int
        The stated teeth.
    planets : int or None
        Number of equal planets.
    ratio : float
        The required ratio [1]; a deviation of one per cent counts as two teeth.
    fixed : {"ring", "carrier", "sun"}
    """
    suns = range(max(6, sun - 12), sun + 13)
    able = [(s, r) for s in suns for r in range(s + 2, 12 * s + 1) if not assembly_fault(s, r, planets)]

    def distance(teeth: tuple[int, int]) -> float:
        deviation = abs(stage_ratio(*teeth, fixed) / ratio - 1)
        return abs(teeth[0] - sun) + abs(teeth[1] - ring) + PER_RATIO * deviation

    return tuple(sorted(able, key=distance)[:3])


def assembly_remedy(sets: tuple[tuple[int, int], ...], ratio: float, fixed: Fixed = "ring") -> str:
    """Return the remedy with the sets and their ratios, for example ``21/84 (5), 22/86 (4.909)``."""
    if not sets:
        return "use fewer planets"
    named = [f"{sun}/{ring} ({stage_ratio(sun, ring, fixed):.4g})" for sun, ring in sets]
    return (
        f"the nearest sun/ring that can be assembled (and their ratio; {ratio:.4g} is required) are {', '.join(named)}"
    )
