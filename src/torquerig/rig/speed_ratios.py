"""Turns of each shaft per turn of another, by the springs with a ratio between them."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from math import isclose

from torquerig.errors import InputError
from torquerig.rig.terms import GROUND, Spring


def speed_ratios(springs: Sequence[Spring], reference: str) -> dict[str, float]:
    """Return the turns [1] of each node per turn of the node ``reference``; nodes that nothing links are left out.

    Raises
    ------
    InputError
        Where two ways to a node give different ratios.
    """
    ratios, waiting = {reference: 1.0}, deque([reference])
    while waiting:
        here = waiting.popleft()
        for spring in springs:
            for start, end, factor in ((spring.a, spring.b, 1 / spring.ratio), (spring.b, spring.a, spring.ratio)):
                if start != here or end == GROUND:
                    continue
                turned = ratios[here] * factor
                if end not in ratios:
                    ratios[end] = turned
                    waiting.append(end)
                elif not isclose(ratios[end], turned, rel_tol=1e-9):
                    raise InputError(
                        f"{spring.name}: the gears round this loop do not match; {end} would have to "
                        f"turn {turned:g} and {ratios[end]:g} times as fast as {reference}"
                    )
    return ratios
