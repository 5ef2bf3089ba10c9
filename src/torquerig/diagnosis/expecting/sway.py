"""What a swaying shaft does to lines: slow ones sway the motor's angle, and with it the phase of fast ones.

The side lines are wanted as a doubt and not as lines: what stands at one is not yet another effect.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.special import j0, j1

from torquerig.diagnosis.expecting.skirts import FOLLOWED
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.side_lines import REACH
from torquerig.linear_twin.twin import LineSource, Twin, passed, sources
from torquerig.orders.angle.periodic_angle_error import SLOW

Floats = NDArray[np.float64]

_SLOWEST = 0.05  # [Hz]
_DOUBT = 0.3  # of what a line loses [1]: the sway is a model's, and lines of one shaft sway it together
_LITTLE = 0.1  # [rad] takes a four-hundredth of a line
_LARGEST = 1.84  # [rad] where Bessel's J1 is largest


class Sway:
    """How a rig's lines sway its motor, seen along the angle of a run.

    A line of order m that sways the motor's angle by ``delta`` leaves ``J0(n delta)`` of a line of order n and size A,
    and gives it side lines ``J1(n delta) A`` at n + m and n - m, J being Bessel's functions and the source periodic in
    the angle (Jacobi and Anger's expansion, Abramowitz & Stegun 1964, 9.1.41). Along an angle that was measured the
    line is whole, and of the side lines that is left which the shafts pass otherwise there than at the line.

    In a steady run the sway of the slowest lines is followed in the torque (``periodic_angle_error``): they
    take nothing, and only their side lines stay in doubt. True while the slow lines are far below the shafts' modes or
    known with them; side lines of side lines are left out.

    Parameters
    ----------
    turns : ndarray, shape (stretches,)
        Of the motor [1/s].
    motor : ndarray, shape (stretches,)
        Its torque [N m].
    """

    def __init__(self, twin: Twin, seen: Features, *, turns: Floats, motor: Floats) -> None:
        self.seen, self.turns, self.lines = seen, turns, twin.lines()
        slow = [line for line in self.lines if line.order <= REACH and line.transfer.sway is not None]
        self.orders = np.array([line.order for line in self.lines])[:, None]
        self.slow = np.array([line.order for line in slow])
        # by how much each line's phase is swayed [rad], shape (lines, slow, stretches)
        self.phase = (
            self.orders[:, None] * _sways(twin, slow, turns, motor)
            if slow
            else np.zeros((len(self.lines), 0, turns.size))
        )
        self.phase[self.slow >= self.orders] = 0.0

    @cached_property
    def left(self) -> Floats:
        """What is left of each line, shape (lines, stretches)."""
        if self.seen.observed.angle_measured or not self.slow.size:
            return np.ones((len(self.lines), self.turns.size))
        unseen = self.slow[:, None] * self.turns > FOLLOWED
        if self.seen.observed.steady:
            unseen &= self.slow[:, None] > SLOW
        loses = (self.phase > _LITTLE) & unseen
        left = np.ones_like(self.phase)
        left[loses] = j0(self.phase[loses])
        return np.asarray(np.abs(np.prod(left, axis=1)))

    def beside(self, sizes: Floats, power: Floats) -> tuple[Floats, Floats]:
        """Return orders beside which more or less than the rig's lines may stand, shape (n,), and how much [N m].

        The latter is of shape (n, stretches).

        Parameters
        ----------
        sizes : ndarray, shape (lines, stretches)
            Of the lines in the reading, were nothing swayed [N m].
        power : ndarray, shape (bands,)
            Density that the lines stand in [(N m)^2/Hz]: side lines below the spread of an amplitude are passed over.
        """
        if not self.slow.size:
            return np.zeros(0), np.zeros((0, self.turns.size))
        doubt = _DOUBT * (1 - self.left) * sizes
        spread = np.sqrt(np.interp(self.orders * self.turns, self.seen.band, np.nan_to_num(power)) / self.seen.duration)
        own = np.flatnonzero((doubt > spread).any(axis=1))
        orders, much = [self.orders[own, 0]], [doubt[own]]
        fast, by = np.nonzero((0.5 * self.phase * sizes[:, None] > spread[:, None]).any(axis=2))
        if fast.size:
            side = j1(np.minimum(self.phase[fast, by], _LARGEST)) * sizes[fast]
            line, apart = self.orders[fast], self.slow[by, None]
            beside = np.concatenate([line - apart, line + apart])
            every, own = [line.transfer for line in self.lines], np.unique(fast)
            at_line = np.zeros((len(every), self.turns.size), dtype=np.complex128)
            asked = np.concatenate([self.orders[own], beside]) * self.turns
            at_each = passed(every, asked, np.concatenate([own, fast, fast]))
            at_line[own], below, above = np.split(at_each, [own.size, own.size + fast.size])
            relative = np.concatenate([below / at_line[fast], above / at_line[fast]])
            orders.append(beside[:, 0])
            reached = np.abs(relative - 1) if self.seen.observed.angle_measured else np.abs(relative)
            much.append(np.concatenate([side, side]) * reached)
        return np.concatenate(orders), np.concatenate(much)


def _sways(twin: Twin, slow: Sequence[LineSource], turns: Floats, motor: Floats) -> Floats:
    """Return by how much slow lines sway the motor's angle in each stretch [rad], shape (lines, stretches)."""
    sway = [line.transfer.sway for line in slow if line.transfer.sway is not None]
    at = np.maximum(np.array([line.order for line in slow])[:, None] * turns, _SLOWEST)
    return np.asarray(sources(slow, motor) * np.abs(twin.shafts.each_at(sway, at)))
