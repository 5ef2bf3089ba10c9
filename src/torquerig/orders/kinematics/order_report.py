"""The order report of a motor and gearbox at one speed: lines with causes, coincidences, and a better speed."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite, pi

from torquerig.errors import InputError
from torquerig.orders.kinematics.coincidences import BetterSpeed, Coincidences, better_speed, coincidences
from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
from torquerig.orders.kinematics.line_families import Family

FASTEST = 1e6 * pi / 30  # [rad/s] ten times the fastest dental turbines
SLOWEST_MAINS, FASTEST_MAINS = 0.01, 1e5  # [Hz] railways have 16.7 Hz, ships and aircraft 400 Hz


@dataclass(frozen=True)
class OrdersReport:
    """The lines of one drive at one speed.

    Parameters
    ----------
    kinematics : Kinematics
        Poles, slots, ratio and teeth.
    motor_speed : float
        [rad/s].
    lines : tuple of KinematicLine
        By rising frequency.
    left_out : dict of Family to str
        Families without lines, and the missing data.
    coincidences : Coincidences
        Lines on mains multiples and lines of equal order.
    better : BetterSpeed
        The nearest speed at which the lines keep a distance from the mains multiples.
    """

    kinematics: Kinematics
    motor_speed: float
    lines: tuple[KinematicLine, ...]
    left_out: dict[Family, str]
    coincidences: Coincidences
    better: BetterSpeed

    def fundamental(self, family: Family) -> KinematicLine | None:
        """Return the first harmonic of ``family``, or None without one; lines of further motors do not count."""
        found = (line for line in self.lines if line.family == family and line.harmonic == 1 and not line.at)
        return next(found, None)


def orders_report(
    kinematics: Kinematics,
    motor_speed: float,
    *,
    harmonics: int = 4,
    mains: float = 50.0,
    clearance: float = 1.0,
) -> OrdersReport:
    """Return the lines of ``kinematics`` at ``motor_speed`` [rad/s], their coincidences, and a better speed.

    Parameters
    ----------
    kinematics : Kinematics
        Poles, slots, ratio and teeth of the drive.
    motor_speed : float
        [rad/s], not 0; its sign does not matter.
    harmonics : int
        Members per family.
    mains : float
        [Hz], > 0.
    clearance : float
        Required distance of every line from the mains multiples [Hz].

    Raises
    ------
    InputError
        For a speed of 0 or an impossible mains frequency.
    """
    if not isfinite(motor_speed) or motor_speed == 0:
        raise InputError("at a speed of 0 no line has a frequency; give the motor's speed, for example 1000 rpm")
    if abs(motor_speed) > FASTEST:
        raise InputError(f"a motor speed of {motor_speed * 30 / pi:g} rpm is beyond reason; the largest sensible is "
                         f"{FASTEST * 30 / pi:g} rpm")  # fmt: skip
    if not (isfinite(mains) and SLOWEST_MAINS <= mains <= FASTEST_MAINS):
        raise InputError(f"a mains frequency of {mains:g} Hz is not possible; give for example 50 Hz")
    lines = kinematics.lines(harmonics)
    return OrdersReport(
        kinematics=kinematics,
        motor_speed=motor_speed,
        lines=tuple(sorted(lines, key=lambda line: line.motor_order)),
        left_out=kinematics.left_out,
        coincidences=coincidences(lines, motor_speed, mains=mains),
        better=better_speed(lines, motor_speed, mains=mains, clearance=clearance),
    )
