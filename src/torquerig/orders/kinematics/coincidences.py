"""Which order lines cannot be told apart at one speed: on mains multiples or of equal order; and a better speed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import pi

import numpy as np

from torquerig.orders.kinematics.kinematic_lines import KinematicLine

# mains harmonics are counted up to the 40th by the power-quality standards (IEC 61000-3-2, EN 50160 counts to the 25th)
HIGHEST_MAINS_MULTIPLE = 40


@dataclass(frozen=True)
class OnMains:
    """A line that stands on a mains multiple: ``multiple`` times the mains, ``offset`` [Hz] away from it."""

    line: KinematicLine
    frequency: float
    multiple: int
    offset: float


@dataclass(frozen=True)
class EqualOrder:
    """Lines of different families at one order: no speed parts them; load, current, coast-down or other teeth may."""

    motor_order: float
    frequency: float
    lines: tuple[KinematicLine, ...]


@dataclass(frozen=True)
class Coincidences:
    """What stands on what at one motor speed [rad/s] with one mains frequency [Hz]."""

    motor_speed: float
    mains: float
    on_mains: tuple[OnMains, ...]
    equal_orders: tuple[EqualOrder, ...]


@dataclass(frozen=True)
class BetterSpeed:
    """The nearest motor speed at which the lines keep clear of the mains.

    Parameters
    ----------
    motor_speed : float
        [rad/s]; the speed asked about where that is clear already.
    clearance : float
        The smallest distance of any line to a mains multiple there [Hz].
    wanted : float
        The clearance that was asked for [Hz].
    crowded : tuple of KinematicLine
        The lines that are nearer than ``wanted`` even there; empty where the search succeeded.
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
    """Return the nearest speed at which no line lies within ``clearance`` of a mains multiple, as far as there is one.

    The search goes in whole rpm up to ``within`` of the speed either way. Where no speed is clear, the one with the
    fewest crowded lines is returned, among equals the one with the widest smallest distance. Equal orders stay equal
    at any speed.

    Parameters
    ----------
    lines : iterable of KinematicLine
        The lines to keep clear.
    motor_speed : float
        The speed asked about [rad/s].
    mains : float
        Mains frequency [Hz].
    clearance : float
        Wanted distance [Hz]; twice the half-width of the reference report's band-stops by default.
    within : float
        Share of the speed to search on either side [1].
    """
    listed = tuple(lines)
    asked = abs(motor_speed) * 30 / pi
    speeds = np.concatenate([[asked], np.arange(np.ceil(asked * (1 - within)), np.floor(asked * (1 + within)) + 1)])
    distance = _distance_to_mains(np.array([line.motor_order for line in listed]), speeds, mains)
    near = distance < clearance
    crowded = near.sum(axis=1)
    smallest = distance.min(axis=1, initial=mains / 2)
    # fewest crowded lines first; among clear speeds the nearest, among crowded ones the widest
    last = np.where(crowded == 0, 0.0, -smallest)
    best = int(np.lexsort((np.abs(speeds - asked), last, crowded))[0])
    left = tuple(line for line, is_near in zip(listed, near[best], strict=True) if is_near)
    return BetterSpeed(float(speeds[best]) * pi / 30, float(smallest[best]), clearance, left)


def _distance_to_mains(orders: np.ndarray, speeds_rpm: np.ndarray, mains: float) -> np.ndarray:
    """Distance of each line to the nearest mains multiple [Hz], shape (speeds, lines)."""
    frequency = np.outer(speeds_rpm / 60, orders)
    multiple = np.clip(np.round(frequency / mains), 1, HIGHEST_MAINS_MULTIPLE)
    return np.asarray(np.abs(frequency - multiple * mains))


def _equal_orders(lines: tuple[KinematicLine, ...], motor_speed: float) -> tuple[EqualOrder, ...]:
    groups: dict[float, list[KinematicLine]] = {}
    for line in sorted(lines, key=lambda line: line.motor_order):
        # orders are ratios of small whole numbers: what agrees to nine digits is equal
        groups.setdefault(float(f"{line.motor_order:.9g}"), []).append(line)
    return tuple(
        EqualOrder(order, members[0].frequency(motor_speed), tuple(members))
        for order, members in groups.items()
        if len({line.family for line in members}) > 1
    )
