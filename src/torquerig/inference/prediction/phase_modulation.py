"""Side lines of a line whose shaft turns unevenly with a known period, where the angle does not follow that.

A torque of order n on a shaft that sways by ``theta cos(m phi)`` about the known angle is
``a cos(n phi + n theta cos(m phi))``: phase modulation of the index ``beta = n theta``. It keeps the share
``J0(beta)^2`` of its power and leaves ``J1(beta)^2``, for a small sway ``(n theta / 2)^2``, at each of the orders n + m
and n - m, from where the shafts pass it on (J: Bessel functions). Lines of second order, n +- 2 m, are left out: below
3 % of the first ones' power up to beta = 0.7. Several slow lines modulate one after the other. Above beta = 1.5 the
first side lines are not the largest ones; there the model ends, and lets the index go to 0. Source: any text on
modulation (Rutman 1978, Proc. IEEE 66).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.linear_twin.transfer import Response
from torquerig.linear_twin.twin import LineSource, Passage, Twin, passed
from torquerig.rig.terms import GROUND

Floats = NDArray[np.float64]

_LEAST = 1e-8  # [1] of a line's power: a smaller side line is below what any converter shows next to it
_LARGEST = 1.7  # [rad] of phase: at 0.7 the index is 3 % smaller for it, at 1.5 by half, at 3 nothing is left


class SideLines(NamedTuple):
    """Side lines of the lines of a rig, and what they take from them.

    Parameters
    ----------
    kept : ndarray, shape (lines, segments)
        Share of its power that each line keeps [1].
    frequency, square : ndarray, shape (side lines, segments)
        [Hz], and mean square of the amplitude in the reading [(N m)^2].
    nodes : tuple of str
        What the line of each side line follows.
    """

    kept: Floats
    frequency: Floats
    square: Floats
    nodes: tuple[str, ...]


def side_lines(twin: Twin, seen: RunFeatures, lines: Sequence[LineSource], source: Floats) -> SideLines:
    """Return the side lines of the lines of a twin; ``source`` are their amplitudes, shape (lines, segments)."""
    from scipy.special import j0, j1

    turning = np.abs(seen.speed) / (2 * pi)
    orders = np.array([line.order for line in lines])
    depth = _depths(twin, seen, lines, source)
    kept = np.prod(np.square(j0(depth)), axis=1)
    line, slow = np.nonzero((0.25 * np.square(depth)).max(axis=2, initial=0.0) > _LEAST)
    side = np.concatenate([orders[line] - orders[slow], orders[line] + orders[slow]])
    line, slow = np.tile(line, 2), np.tile(slow, 2)
    frequency = side[:, None] * turning
    if not line.size:
        return SideLines(kept, frequency, frequency.copy(), ())
    gain = np.abs(passed([each.transfer for each in lines], frequency, line))
    square = np.square(gain * source[line] * j1(depth[line, slow]))
    return SideLines(kept, frequency, square, tuple(lines[each].node for each in line.tolist()))


def _depths(twin: Twin, seen: RunFeatures, lines: Sequence[LineSource], source: Floats) -> Floats:
    """Return by what angle [rad] each line (axis 0) turns in phase as each slower one (axis 1) sways.

    Shape (lines, lines, segments).
    """
    if np.isinf(seen.run.followed) and {line.node for line in lines} == {twin.drives[0].on}:
        return np.zeros((len(lines), len(lines), source.shape[1]))
    key = tuple((line.owner, line.order, line.node, *(on for on, _ in line.transfer.acts)) for line in lines)
    sways = seen.kept.get("sway by lines", (twin.shafts, key), lambda: _sways(twin, seen, lines))
    index = sways * source[None]
    return np.asarray(index * np.exp(-((index / _LARGEST) ** 4)))


def _sways(twin: Twin, seen: RunFeatures, lines: Sequence[LineSource]) -> Floats:
    """Return the same per unit of the slower lines' sources.

    Lines that the speed loop answers with are side lines already and have none.
    """
    turning = np.abs(seen.speed) / (2 * pi)
    answer = np.zeros((len(lines), len(lines), turning.size))
    known = (twin.shafts.frequency <= seen.run.followed).astype(float)
    first = [row for row, line in enumerate(lines) if line.transfer.answer is None]
    orders = np.array([line.order for line in lines])
    for node in dict.fromkeys(lines[row].node for row in first):
        own = np.array([row for row in first if lines[row].node == node])
        slow = [row for row in first if orders[row] < orders[own].max()]
        different = {id(lines[row].transfer): lines[row].transfer for row in slow}
        made = {each: _swayed_by(twin, cause, node, known) for each, cause in different.items()}
        found = [(row, each) for row in slow if (each := made[id(lines[row].transfer)]) is not None]
        if found:
            rows = np.array([row for row, _ in found])
            theta = np.abs(twin.shafts.each_at([each for _, each in found], orders[rows, None] * turning))
            faster = orders[own, None, None] * (orders[own, None, None] > orders[None, rows, None])
            answer[np.ix_(own, rows)] = faster * theta
    return answer


def _swayed_by(twin: Twin, cause: Passage, node: str, known: Floats) -> Response | None:
    """Return the response of a node's angle about the known one to a cause, on the shafts' grid, in turns of the motor.

    Of the motor's angle the share ``known`` is known, shape (points,) [1]. None for a node without a speed in
    proportion to the motor's.
    """
    angles, motor = twin.shafts.angles, twin.drives[0].on
    acts = [(on, share) for on, share in cause.acts if on != GROUND]
    if node not in twin.turns or any(on not in angles[node] for on, _ in acts):
        return None
    ratio = twin.turns[node] * twin.direction(node)
    parts = [share * (angles[node][on] / ratio - known * angles[motor][on]) for on, share in acts]
    return np.asarray(sum(parts, np.zeros(twin.shafts.frequency.size, dtype=np.complex128)))
