"""The Campbell diagram: motor speeds at which an order line meets a mode, and the response of the sensor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.rig.terms import GROUND
from torquerig.simulation.twin.lines import OrderLine
from torquerig.simulation.twin.modes import Mode
from torquerig.simulation.twin.system import LinearSystem

RADIANS_PER_RPM = pi / 30
OVERDAMPED = 0.7071  # [1] from here on a mode has no peak over frequency


@dataclass(frozen=True)
class Crossing:
    """The crossing of one line and one mode.

    Parameters
    ----------
    line : OrderLine
    mode : int
        Its number, from 1.
    frequency : float
        [Hz].
    speed : float
        Motor speed [rad/s].
    gain : float
        Amplitude at the sensor per amplitude of the line [N m per N m, or N m per rad].
    torque : float or None
        Amplitude at the sensor [N m]; None where the line's own is not known.
    magnification : float
        ``1 / (2 damping)`` [1]: how much the mode lifts a steady line above a slow one (Den Hartog, Mechanical
        Vibrations, section 2.11).
    """

    line: OrderLine
    mode: int
    frequency: float
    speed: float
    gain: float
    torque: float | None
    magnification: float

    @property
    def speed_rpm(self) -> float:
        """Motor speed [rpm]."""
        return self.speed / RADIANS_PER_RPM


def crossings(
    lines: Sequence[OrderLine], modes: Sequence[Mode], system: LinearSystem, *, sensor: str, top_speed: float,
) -> tuple[Crossing, ...]:  # fmt: skip
    """Return the crossings of lines and modes up to ``top_speed`` [rad/s] of the motor, the strongest first.

    Lines of unknown amplitude come after the others. Modes damped beyond 0.7 have no peak and are not met. The modes
    are taken not to move with speed; what moves in a rig of this kind is the slope of its friction alone.

    Parameters
    ----------
    system : LinearSystem
        The twin with its speed loop closed, as the sensor sees the lines.
    sensor : str
        The spring that is read.
    """
    effect, found = f"torque in {sensor}", []
    for line in lines:
        for number, mode in enumerate(modes, start=1):
            speed = 2 * pi * mode.damped / line.order if line.order > 0 else np.inf
            if mode.damping >= OVERDAMPED or speed > top_speed:
                continue
            gain = abs(_transfer(line, system, effect, mode.damped))
            found.append(
                Crossing(
                    line=line,
                    mode=number,
                    frequency=mode.damped,
                    speed=speed,
                    gain=float(gain),
                    torque=None if line.amplitude is None else float(gain) * line.amplitude,
                    magnification=0.5 / mode.damping if mode.damping > 0 else float("inf"),
                )
            )
    return tuple(sorted(found, key=lambda one: (one.torque is None, -(one.gain if one.torque is None else one.torque))))


def nearest_to(speed: float, found: Sequence[Crossing]) -> Crossing | None:
    """Return the crossing whose speed is nearest to ``speed`` [rad/s], in proportion; None where there is none."""
    if speed == 0:
        return None
    return min(found, key=lambda one: abs(one.speed / abs(speed) - 1), default=None)


def _transfer(line: OrderLine, system: LinearSystem, effect: str, frequency: float) -> complex:
    """Return the transfer of a line at a frequency [Hz], with that of its opposite torque on the housing."""
    ends = [(line.enters, 1.0)]
    if line.against != GROUND:
        ends.append((f"torque on {line.against}", -1.0))
    return sum(sign * complex(system.transfer(end, effect, np.array([frequency]))[0]) for end, sign in ends)
