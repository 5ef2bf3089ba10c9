"""The temperatures of one variant of a motor over a duty: course, steady cycle, peak, time to the limit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.thermal_motor import ThermalMotor
from torquerig.thermal.two_node import Stretch

Floats = NDArray[np.float64]
LONGEST = 2**60  # cycles that are searched for the limit


@dataclass(frozen=True, kw_only=True)
class Warming:
    """A repeated duty as exact stretches of one variant; temperatures are in [C].

    Parameters
    ----------
    stretches : tuple of Stretch
    durations : tuple of float
        Of each stretch [s].
    ambient : float
        Ambient temperature [C].
    """

    stretches: tuple[Stretch, ...]
    durations: tuple[float, ...]
    ambient: float

    @property
    def length(self) -> float:
        """The length of a cycle [s]."""
        return sum(self.durations)

    def cycle_map(self) -> tuple[Floats, Floats]:
        """Return M and v: the rises at the end of a cycle are ``M x + v`` of those at its start."""
        matrix, offset = np.eye(2), np.zeros(2)
        for stretch, duration in zip(self.stretches, self.durations, strict=True):
            decay, gained = stretch.propagators(duration)
            matrix, offset = decay @ matrix, decay @ offset + gained
        return matrix, offset

    def settled(self) -> Floats | None:
        """Return the rises at the start of the periodic cycle [K], ``(1 - M)^-1 v``.

        None where there is none: copper loss increases faster with temperature than the heat flow (thermal runaway).
        """
        matrix, offset = self.cycle_map()
        if float(np.abs(np.linalg.eigvals(matrix)).max()) >= 1:
            return None
        return np.asarray(np.linalg.solve(np.eye(2) - matrix, offset))

    def extremes(self, start: Floats) -> tuple[float, float, float]:
        """Return lowest and highest winding and highest housing temperature of a cycle from ``start`` [K], in [C].

        The winding's are exact: at the ends of the stretches or where its slope is zero within one. The housing's is
        that of the ends.
        """
        winding, housing = [start[0]], [start[1]]
        for stretch, duration in zip(self.stretches, self.durations, strict=True):
            turn = stretch.turning(duration, start)
            winding += [] if turn is None else [stretch.after(turn, start)[0]]
            start = stretch.after(duration, start)
            winding.append(start[0])
            housing.append(start[1])
        lowest, highest, hottest = min(winding), max(winding), max(housing)
        return float(lowest) + self.ambient, float(highest) + self.ambient, float(hottest) + self.ambient

    def course(self, start: Floats, *, points: int = 400) -> tuple[Floats, Floats]:
        """Return times [s], shape (n,), and winding and housing temperatures [C], shape (n, 2), over one cycle."""
        times, found, at = [0.0], [start], 0.0
        for stretch, duration in zip(self.stretches, self.durations, strict=True):
            count = max(1, round(points * duration / self.length))
            for share in np.arange(1, count + 1) / count:
                times.append(at + share * duration)
                found.append(stretch.after(float(share * duration), start))
            start, at = found[-1], at + duration
        return np.array(times), np.array(found) + self.ambient

    def time_to(self, limit: float, start: Floats) -> float | None:
        """Return the time [s] at which the winding first reaches ``limit`` [C] from ``start`` [K]; None if never.

        From a cold start every cycle is warmer than the one before it. The cycle in which the limit is reached is found
        by doubling and bisection, and the time within it by bisection.
        """
        wanted = limit - self.ambient
        first, settled = self.cycle_map(), self.settled()
        if self._reaches(wanted, start):
            return self._moment(wanted, start)
        if settled is not None and not self._reaches(wanted, settled):
            return None
        matrices, offsets, count = [first[0]], [first[1]], 1
        while not self._reaches(wanted, matrices[-1] @ start + offsets[-1]):
            with np.errstate(over="ignore", invalid="ignore"):
                offsets.append(matrices[-1] @ offsets[-1] + offsets[-1])
                matrices.append(matrices[-1] @ matrices[-1])
            count *= 2
            if count > LONGEST:
                return None
        passed, state = 0, start
        for matrix, offset in zip(reversed(matrices[:-1]), reversed(offsets[:-1]), strict=True):
            count //= 2
            ahead = matrix @ state + offset
            if not self._reaches(wanted, ahead):
                passed, state = passed + count, ahead
        state = first[0] @ state + first[1]
        return (passed + 1) * self.length + self._moment(wanted, state)

    def _reaches(self, wanted: float, start: Floats) -> bool:
        return self.extremes(start)[1] - self.ambient >= wanted

    def _moment(self, wanted: float, start: Floats) -> float:
        """Return the time within the cycle from ``start`` at which the winding's rise first is ``wanted`` [s]."""
        if start[0] >= wanted:
            return 0.0
        at = 0.0
        for stretch, duration in zip(self.stretches, self.durations, strict=True):
            turn = stretch.turning(duration, start)
            top = duration if turn is None or stretch.after(turn, start)[0] < wanted else turn
            if stretch.after(top, start)[0] >= wanted:
                low, high = 0.0, top
                while high - low > 1e-9 * (1.0 + high):
                    middle = 0.5 * (low + high)
                    low, high = (middle, high) if stretch.after(middle, start)[0] < wanted else (low, middle)
                return at + high
            start, at = stretch.after(duration, start), at + duration
        return at


def warming(motor: ThermalMotor, duty: MotorDuty, *, ambient: float) -> Warming:
    """Return the warming of one variant of a motor by a duty, at ``ambient`` [C]."""
    rows = zip(duty.torque_square.tolist(), duty.speed.tolist(), duty.speed_square.tolist(), strict=True)
    return Warming(
        stretches=tuple(
            motor.stretch(torque_square=torque, speed=speed, speed_square=square, ambient=ambient)
            for torque, speed, square in rows
        ),
        durations=tuple(duty.duration.tolist()),
        ambient=ambient,
    )
