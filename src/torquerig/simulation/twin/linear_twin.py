"""The linear model of a rig about its operating point: modes, poles, margins, lines, crossings."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import pi

from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.rig.assembly import Rig
from torquerig.simulation.lower import Lowered, lower
from torquerig.simulation.twin.crossings import Crossing, crossings
from torquerig.simulation.twin.lines import OrderLine, order_lines
from torquerig.simulation.twin.loop import closed_loop, sampled_loop
from torquerig.simulation.twin.margins import Margins, is_stable, margins
from torquerig.simulation.twin.modes import Mode, Pole, loop_poles, modes
from torquerig.simulation.twin.operating_point import OperatingPoint, operating_point
from torquerig.simulation.twin.plant import plant
from torquerig.simulation.twin.system import LinearSystem


@dataclass(frozen=True)
class Twin:
    """A rig for small changes about its operating point; ``point.left_out`` lists what is not modelled.

    Parameters
    ----------
    open_loop : LinearSystem
        The rig without its speed loop: the motor follows ``command of CONTROLLER``.
    closed_loop : LinearSystem
        With the loop, its sampled controller taken as a continuous one; the same as ``open_loop`` without a drive.
    sampled_loop : LinearSystem
        With the loop as it is, exact at the samples; without a drive the sampled rig.
    rate : float
        Samples and control steps per second [Hz].
    """

    rig: Rig
    lowered: Lowered
    point: OperatingPoint
    open_loop: LinearSystem
    closed_loop: LinearSystem
    sampled_loop: LinearSystem
    rate: float

    @property
    def stable(self) -> bool:
        """Whether the sampled loop is stable."""
        return is_stable(self.sampled_loop)

    def modes(self) -> tuple[Mode, ...]:
        """Return the elastic modes of the open-loop rig."""
        return modes(self.rig, self.lowered, point=self.point)

    def loop_poles(self) -> tuple[Pole, ...]:
        """Return the roots with the speed loop closed, those of the sampled controller."""
        return loop_poles(self.sampled_loop, self.modes())

    def margins(self) -> tuple[Margins, ...]:
        """Return the margins of each speed loop."""
        return margins(self.open_loop, self.lowered, rate=self.rate)

    def order_lines(self, kinematic: Iterable[KinematicLine] = ()) -> tuple[OrderLine, ...]:
        """Return the lines of the rig's effects, and those of ``kinematic`` whose order no effect has."""
        return order_lines(self.rig, self.lowered, self.point, kinematic=kinematic)

    def crossings(self, lines: Iterable[OrderLine], *, top_speed: float) -> tuple[Crossing, ...]:
        """Return where the lines meet the modes up to ``top_speed`` [rad/s], as the measured spring shows them."""
        found = self.modes()
        return crossings(tuple(lines), found, self.closed_loop, sensor=self.rig.measured, top_speed=top_speed)

    @property
    def reads_a_spring(self) -> bool:
        """Whether a spring is measured; else it is an imposed motion, and ``sensor`` is no output."""
        return self.rig.measured in self.lowered.spring_names

    @property
    def sensor(self) -> str:
        """The output that is read."""
        return f"torque in {self.rig.measured}"

    @property
    def motor_speed_rpm(self) -> float:
        """Speed of the leading shaft at the operating point [rpm]."""
        return float(self.point.speeds[self.lowered.node(self.lowered.leader())]) * 30 / pi


def twin_of(rig: Rig, *, rate: float = 25_000.0, seed: int = 0) -> Twin:
    """Return the linear twin of a rig about the set-point of its run.

    Parameters
    ----------
    rate : float
        Of the sampled controller [Hz].
    seed : int
        Draws the phases of lines; no transfer depends on it.

    Raises
    ------
    InputError
        Where there is no one operating point: two speed controllers, or a loop that comes to no steady speed.
    """
    lowered = lower(rig, seed)
    point = operating_point(rig, lowered)
    open_loop = plant(lowered, point)
    return Twin(
        rig=rig,
        lowered=lowered,
        point=point,
        open_loop=open_loop,
        closed_loop=closed_loop(open_loop, lowered),
        sampled_loop=sampled_loop(open_loop, lowered, rate=rate),
        rate=rate,
    )
