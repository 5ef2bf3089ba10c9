"""Order lines that coincide at one speed, with mains multiples or with each other, and a better test speed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.orders.kinematics.kinematic_lines import KinematicLine

# power-quality standards count mains harmonics up to the 40th (IEC 61000-3-2; EN 50160 up to the 25th)
HIGHEST_MAINS_MULTIPLE = 40


@dataclass(frozen=True)
class OnMains:
    """A line at ``multiple`` times the mains, ``offset`` [Hz] away from it; ``frequency`` in [Hz]."""

    line: KinematicLine
    frequency: float
    multiple: int
    offset: float


@dataclass(frozen=True)
class EqualOrder:
    """Lines of different families at one order; no speed separates them, but load, current or a coast-down may."""

    motor_order: float
    frequency: float
    lines: tuple[KinematicLine, ...]


@dataclass(frozen=True)
class Coincidences:
    """The coincidences at one motor speed [rad/s] and one mains frequency [Hz]."""

    motor_speed: float
    mains: float
    on_mains: tuple[OnMains, ...]
    equal_orders: tuple[EqualOrder, ...]


@dataclass(frozen=True)
class BetterSpeed:
    """The nearest motor speed at which all lines keep a distance from the mains multiples.

    Parameters
    ----------
    motor_speed : float
        [rad/s]; the given speed where that is clear already.
    clearance : float
        The smallest distance of any line to a mains multiple there [Hz].
    wanted : float
        The required clearance [Hz].
    crowded : tuple of KinematicLine
        The lines that are nearer than ``wanted`` at that speed; empty where the search succeeded.
    """

    motor_speed: float
    clearance: float
    wanted: float
    crowded: tuple[KinematicLine, ...]


def coincidences(
    lines: Iterable[KinematicLine], motor_speed: float, *, mains: float = 50.0, within: float = 0.5
) -> Coincidences:
    """Return the lines within ``within`` [Hz] of a mains multiple, and those of different families at equal order."""
    listed = tuple(lines)
    on_mains = []
    for line in listed:
        frequency = line.frequency(motor_speed)
        multiple = round(frequency / mains)
        if 1 <= multiple <= HIGHEST_MAINS_MULTIPLE and abs(frequency - multiple * mains) <= within:
            on_mains.append(OnMains(line, frequency, multiple, frequency - multiple * mains))
    on_mains.sort(key=lambda hit: hit.frequency)
    return Coincidences(motor_speed, mains, tuple(on_mains), _equal_orders(listed, motor_speed))


def better_speed(
    lines: Iterable[KinematicLine],
    motor_speed: float,
    *,
    mains: float = 50.0,
    clearance: float = 1.0,
    within: float = 0.10,
) -> BetterSpeed:
    """Return the nearest speed at which no line is within ``clearance`` of a mains multiple, if there is one.

    The search covers whole rpm up to the share ``within`` on either side of the speed. Where no speed is clear, the
    one with the fewest lines within ``clearance`` is returned, and among equals the one with the largest smallest
    distance. Equal orders coincide at any speed.

    Parameters
    ----------
    lines : iterable of KinematicLine
        The lines to keep clear.
    motor_speed : float
        The given speed [rad/s].
    mains : float
        Mains frequency [Hz].
    clearance : float
        Required distance [Hz]; twice the half-width of the reference report's band-stops by default.
    within : float
        Share of the speed to search on either side [1].
    """
    listed = tuple(lines)
    given = abs(motor_speed) * 30 / pi
    speeds = np.concatenate([[given], np.arange(np.ceil(given * (1 - within)), np.floor(given * (1 + within)) + 1)])
    distance = _distance_to_mains(np.array([line.motor_order for line in listed]), speeds, mains)
    near = distance < clearance
    crowded = near.sum(axis=1)
    smallest = distance.min(axis=1, initial=mains / 2)
    # fewest near lines first; among clear speeds the nearest, among others the one with the largest distance
    last = np.where(crowded == 0, 0.0, -smallest)
    best = int(np.lexsort((np.abs(speeds - given), last, crowded))[0])
    still_near = tuple(line for line, is_near in zip(listed, near[best], strict=True) if is_near)
    return BetterSpeed(float(speeds[best]) * pi / 30, float(smallest[best]), clearance, still_near)


def _distance_to_mains(orders: np.ndarray, speeds_rpm: np.ndarray, mains: float) -> np.ndarray:
    """Return the distance of each line to the nearest mains multiple [Hz], shape (speeds, lines)."""
    frequency = np.outer(speeds_rpm / 60, orders)
    multiple = np.clip(np.round(frequency / mains), 1, HIGHEST_MAINS_MULTIPLE)
    return np.asarray(np.abs(frequency - multiple * mains))


def _equal_orders(lines: tuple[KinematicLine, ...], motor_speed: float) -> tuple[EqualOrder, ...]:
    groups: dict[float, list[KinematicLine]] = {}
    for line in sorted(lines, key=lambda line: line.motor_order):
        # orders are ratios of small whole numbers: equal to nine digits means equal
        groups.setdefault(float(f"{line.motor_order:.9g}"), []).append(line)
    return tuple(
        EqualOrder(order, members[0].frequency(motor_speed), tuple(members))
        for order, members in groups.items()
        if len({(line.family, line.at) for line in members}) > 1
    )
