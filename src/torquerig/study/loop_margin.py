"""Distance of a tuned speed loop from instability, where the first torsional mode brings it close."""

from __future__ import annotations

from math import inf, pi
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import TorquerigError
from torquerig.rig.first_mode import first_elastic_mode
from torquerig.simulation.lower import Lowered, lower
from torquerig.simulation.twin.linear_twin import twin_of
from torquerig.simulation.twin.loop import sampled_loop
from torquerig.simulation.twin.margins import grid, is_stable, loop_gain
from torquerig.simulation.twin.operating_point import operating_point
from torquerig.simulation.twin.plant import plant
from torquerig.study.loop_figures import LoopMargin

if TYPE_CHECKING:
    from torquerig.rig.assembly import Rig


def loop_margin(rig: Rig, *, motor: str, crossover: float, rate: float) -> LoopMargin | None:
    """Return the margin of the speed loop of a motor, linear at the set-point, sampled at ``rate`` [Hz].

    Dry friction counts by its slope, gaps as closed. None where the rig has no one operating point (``twin_of``).
    """
    try:
        twin = twin_of(rig, rate=rate)
    except TorquerigError:
        return None
    on = twin.lowered.node(rig.node(motor))
    rows = [row for row, node in enumerate(twin.lowered.arrays.drives.on) if int(node) == on]
    if not rows:
        return None
    frequencies = grid(twin.open_loop, rate=rate)
    distance = np.abs(1 + loop_gain(twin.open_loop, twin.lowered, controller=rows[0], rate=rate)(frequencies))
    nearest = int(distance.argmin())
    return LoopMargin(
        stable=twin.stable, modulus=float(distance[nearest]), at=float(frequencies[nearest]), mode=_first_mode(rig),
        crossover=crossover, rate=rate,
    )  # fmt: skip


def has_stable_loop(rig: Rig, *, rate: float, lowered: Lowered | None = None) -> bool:
    """Return whether the speed loop, linear at the set-point and sampled at ``rate`` [Hz], is stable.

    The same as ``stable`` of :func:`loop_margin` at a tenth of its time: the eigenvalues alone. True where the rig has
    no one operating point (``twin_of``). ``lowered`` is the rig as arrays, where it is known; a condensed one lacks its
    fast modes and is not used.
    """
    try:
        if lowered is None or lowered.condensation is not None:
            lowered = lower(rig, 0)
        open_loop = plant(lowered, operating_point(rig, lowered))
    except TorquerigError:
        return True
    return is_stable(sampled_loop(open_loop, lowered, rate=rate))


def _first_mode(rig: Rig) -> float:
    try:
        return first_elastic_mode(rig.terms()) / (2 * pi)
    except TorquerigError:
        return inf
