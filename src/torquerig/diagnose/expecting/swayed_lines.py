"""What the lines of a rig put beside each other: slow ones sway the motor's angle, and with it the phase of fast ones.

Wanted as a doubt, not as lines: what stands at a side line is not yet another effect.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.linear.twin import LineSource, Twin, passed
from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.looking.places import Place, order

Floats = NDArray[np.float64]

_REACH = 16.0  # orders of the motor: what strays faster moves no shaft far
_MOST = 0.58  # of a line stands in its first side line at most: the maximum of Bessel's J1
_SLOWEST = 0.05  # [Hz]


def swayed_lines(
    twin: Twin, seen: Features, *, sizes: Floats, points: Floats, motor: Floats, power: Floats
) -> Iterator[tuple[Place, Floats]]:
    """Yield where side lines of the rig's lines stand, with their sizes [N m], shape (stretches,).

    A line of order m that sways the motor's angle by ``delta`` makes of a line of order n and size A side lines
    ``n delta A / 2`` at n + m and n - m (first order in ``n delta``, the source being periodic in the angle). Along an
    angle that was measured only what the shafts pass otherwise there than at the line is left of them. Side lines below
    the spread that chance gives an amplitude are passed over.

    Parameters
    ----------
    sizes : ndarray, shape (lines, stretches)
        Of the twin's lines in the reading [N m].
    points : ndarray, shape (stretches,)
        Speed of the motor in each stretch [rad/s].
    motor : ndarray, shape (stretches,)
        Its torque [N m].
    power : ndarray, shape (bands,)
        Density that the lines stand in [(N m)^2/Hz].
    """
    lines = twin.lines()
    slow = [row for row, line in enumerate(lines) if line.order <= _REACH and line.transfer.sway is not None]
    if not slow or not sizes.size:
        return
    turns = points / (2 * pi)
    orders = np.array([line.order for line in lines])[:, None]
    density = np.interp(orders * turns, seen.band, np.nan_to_num(power))
    sways = _sways(twin, [lines[row] for row in slow], turns, motor)
    side = np.minimum(0.5 * orders[:, None] * sways, _MOST) * sizes[:, None]  # (lines, slow, stretches)
    slower = orders[slow, 0] < orders
    pairs = np.argwhere((side > np.sqrt(density / seen.duration)[:, None]).any(axis=2) & slower)
    if not pairs.size:
        return
    fast, by = pairs.T
    sides = np.concatenate([orders[fast] - orders[slow][by], orders[fast] + orders[slow][by]])
    through = [lines[row].transfer for row in fast]
    own = np.tile(passed(through, orders[fast] * turns), (2, 1))
    relative = passed([*through, *through], sides * turns) / own
    left = np.abs(relative - 1) if seen.observed.angle_measured else np.abs(relative)
    for at, size in zip(sides[:, 0].tolist(), left * np.tile(side[fast, by], (2, 1)), strict=True):
        yield order(at), size


def _sways(twin: Twin, slow: Sequence[LineSource], turns: Floats, motor: Floats) -> Floats:
    """Return by how much slow lines sway the motor's angle in each stretch [rad], shape (lines, stretches)."""
    sway = [line.transfer.sway for line in slow if line.transfer.sway is not None]
    at = np.maximum(np.array([line.order for line in slow])[:, None] * turns, _SLOWEST)
    source = np.array([line.amplitude * (np.abs(motor) if line.by_load else np.ones(motor.size)) for line in slow])
    return np.asarray(source * np.abs(twin.shafts.each_at(sway, at)))
