"""The angle of a steady run whose speed varies, where lines that did not determine the variation confirm it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.angle.line_likelihood import line_power, line_scores
from torquerig.orders.angle.measured_angle import TWO_SIDED, MotorAngle, of_ends
from torquerig.orders.angle.order_peaks import OrderPeaks, order_peaks
from torquerig.orders.angle.periodic_angle_error import periodic_angle_error
from torquerig.orders.angle.slow_angle_drift import ACCELERATION, slow_angle_drift, usable_lines
from torquerig.orders.angle.speed_posterior import HUM_OFF, REACH
from torquerig.orders.angle.speed_trajectory import speed_trajectory

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_CONFIRMED = 10.0  # log-likelihood that a variation must add to lines that did not determine it
_MODEL = 4.0  # uncertainties by which two models of a drift may differ; rigs with a random load reached 3.2
_SEEN = 30.0  # power over the noise of a peak that is no noise
_TRAJECTORY_ROUNDS = 2  # drift estimates after a trajectory: the first one smooths its steps
_BEATS = 0.6  # [1/rev] a tone nearer to a line than a block of four turns resolves modulates the phase of that line
_NO_BEAT = 1e-3  # [1] power of such a tone relative to the line, at most
_FOREIGN = 2e-3  # [1] a peak further from every order is no line of a speed that drifts slowly


@dataclass(frozen=True)
class TorqueComb:
    """A steady torque, the angle of its set-point [rad], the orders to search, and the noise of a bin at each.

    ``floor`` is the noise power in the unit of the torque squared, ``rate`` the sample rate [Hz], ``peaks`` those of
    the spectrum at constant speed; ``mains`` are the possible frequencies of the mains at the set-point [1/rev].
    """

    torque: Floats
    nominal: Floats
    orders: Floats
    floor: Floats
    rate: float
    peaks: OrderPeaks
    mains: tuple[float, ...]


def varying_angle(
    comb: TorqueComb, constant: MotorAngle, *, is_determined: bool, largest_deviation: float
) -> MotorAngle | None:
    """Return the angle of the varying speed that explains the lines best, or None where a constant speed does.

    Parameters
    ----------
    comb : TorqueComb
    constant : MotorAngle
        The angle at constant speed.
    is_determined : bool
        Whether the lines determine that speed; a drift is sought only from such a speed.
    largest_deviation : float
        Largest relative deviation of the mean speed from the set-point [1].

    Notes
    -----
    Two variations are tried: a slow drift from ``constant``, by the common phase of the lines, and a free trajectory.
    Either is estimated from every second line and must make the other lines more likely, and the reverse (twofold
    cross-validation): hum next to one line, or noise, does not move all lines alike.
    """
    turned = abs(float(comb.nominal[-1] - comb.nominal[0]))

    def is_near(angle: MotorAngle | None) -> bool:
        return angle is not None and abs(_turned(angle.values) / turned - 1) < largest_deviation

    drifted = _drifted(comb, constant) if is_determined else None
    drifted = drifted if is_near(drifted) else None
    trajectory = _trajectory(comb, drifted or constant)
    return trajectory if is_near(trajectory) else drifted


def _drifted(comb: TorqueComb, constant: MotorAngle) -> MotorAngle | None:
    """Return ``constant`` with a confirmed slow drift."""
    angle = constant.values
    usable = usable_lines(angle, comb.orders, comb.floor) & ~_next_to_tones(comb, angle)
    drift, _ = slow_angle_drift(comb.torque, angle, comb.orders, comb.floor, comb.rate, used=usable)
    if not drift.any():
        return None
    angle = angle + periodic_angle_error(comb.torque, angle, comb.orders, comb.floor)
    drift, ends = slow_angle_drift(comb.torque, angle, comb.orders, comb.floor, comb.rate, used=usable)

    def estimated(part: NDArray[np.bool_]) -> Floats:
        return angle + slow_angle_drift(comb.torque, angle, comb.orders, comb.floor, comb.rate, used=part)[0]

    if not _confirmed(comb, angle, usable, estimated, line_power):
        return None
    # how far the mean with a drift is from that without shows how the mean depends on the model of the drift
    difference = min(abs(_turned(angle + drift) - _turned(constant.values)), _MODEL * ends)
    half_width = TWO_SIDED * float(np.hypot(ends, difference)) / _turned(angle)
    return MotorAngle(angle + drift, f"{constant.origin}, with its slow drift", half_width, ends)


def _trajectory(comb: TorqueComb, otherwise: MotorAngle) -> MotorAngle | None:
    """Return the speed over time where it is confirmed against the angle ``otherwise``; None for a run of few turns."""
    every = np.ones(comb.orders.size, dtype=bool)
    needed = _score(comb, otherwise.values) + _CONFIRMED
    found = _along_trajectory(comb, every, needed=needed)
    if found is None or _score(comb, found[0]) < needed or not _sharpens(comb, found[0]):
        return None

    def estimated(part: NDArray[np.bool_]) -> Floats:
        partly = _along_trajectory(comb, part)
        return otherwise.values if partly is None else partly[0]

    if not _confirmed(comb, otherwise.values, every, estimated, line_scores):
        return None
    angle, ends = found
    origin = "from the speed over time, by the lines of the torque near the set-point"
    return of_ends(angle, origin, ends)


def _sharpens(comb: TorqueComb, angle: Floats) -> bool:
    """Return whether the lines along ``angle`` are in sum higher than the peaks at constant speed next to them.

    A wrong trajectory spreads a strong line over other orders: these rise, and the strong line falls.
    """
    relative = np.abs(comb.peaks.at[:, None] / comb.orders - 1)
    highest = np.where(relative < REACH, comb.peaks.power[:, None], 0.0).max(axis=0, initial=0.0)
    seen = (highest > _SEEN * comb.floor) & np.isfinite(comb.floor)
    lines = line_power(comb.torque, angle, comb.orders[seen], comb.floor[seen])
    return float(np.log1p(lines).sum() - np.log1p(highest[seen] / comb.floor[seen]).sum()) > 0


def _along_trajectory(
    comb: TorqueComb, part: NDArray[np.bool_], *, needed: float = -np.inf
) -> tuple[Floats, float] | None:
    """Return the angle of the most likely speed over time by a part of the lines, and the sd between its ends.

    None for a run of few turns, and where the first estimate is so poor that a better one will not reach ``needed``.
    """
    torque, orders, floor = comb.torque, comb.orders[part], comb.floor[part]
    relative = speed_trajectory(torque, comb.nominal, orders, rate=comb.rate)
    if relative is None:
        return None
    angle, ends = np.asarray(np.cumsum(np.gradient(comb.nominal) * relative)), 0.0
    largest = max(ACCELERATION, float(np.abs(np.diff(relative)).max()) * comb.rate)
    for _ in range(_TRAJECTORY_ROUNDS):
        drift, ends = slow_angle_drift(torque, angle, orders, floor, comb.rate, acceleration=largest, factors=(1.0,))
        angle = angle + drift
        if np.isfinite(needed) and (_score(comb, angle) < 0.5 * needed or not _sharpens(comb, angle)):
            return None
        angle = angle + periodic_angle_error(torque, angle, orders, floor)
    return angle, ends


def _confirmed(
    comb: TorqueComb,
    angle: Floats,
    lines: NDArray[np.bool_],
    estimated: Callable[[NDArray[np.bool_]], Floats],
    likelihood: Callable[[Floats, Floats, Floats, Floats], Floats],
) -> bool:
    """Return whether the angle by every second of ``lines``, ranked by power, makes the others more likely."""
    known = np.flatnonzero(lines & np.isfinite(comb.floor))
    if known.size < 2:
        return False
    rank = np.argsort(np.argsort(-line_power(comb.torque, angle, comb.orders[known], comb.floor[known])))
    gained = 0.0
    for part in (rank % 2 == 0, rank % 2 == 1):
        otherwise = estimated(np.isin(np.arange(comb.orders.size), known[part]))
        others = comb.orders[known[~part]], comb.floor[known[~part]]
        after, before = (likelihood(comb.torque, each, *others) for each in (otherwise, angle))
        gained += float(after.sum() - before.sum())
    return gained > _CONFIRMED


def _next_to_tones(comb: TorqueComb, angle: Floats) -> NDArray[np.bool_]:
    """Return which lines beat with hum or with another tone that is in the spectrum, shape (orders,).

    Such a tone modulates the phase of the lines that a block does not resolve from it.
    """
    factor = _turned(angle) / _turned(comb.nominal)
    at, power = comb.peaks.at / factor, comb.peaks.power
    foreign = np.abs(at[:, None] / comb.orders - 1).min(axis=1, initial=np.inf) > _FOREIGN
    foreign &= comb.peaks.over_floor > _SEEN
    # a weaker peak may be a side line of a drift; a stronger one is none
    tones = [(at[foreign], _NO_BEAT * power[foreign])]
    for fundamental in comb.mains:
        harmonics = fundamental * np.arange(1.0, int(comb.orders.max() / fundamental) + 2)
        hum = order_peaks(comb.torque, comb.nominal, harmonics, reach=HUM_OFF)
        tones.append((hum.at / factor, hum.power))
    lines = line_power(comb.torque, angle, comb.orders, np.ones(comb.orders.size))
    at, power = (np.concatenate(each) for each in zip(*tones, strict=True))
    away = np.abs(comb.orders[:, None] - at)
    beats = (away < _BEATS) & (away > comb.peaks.width) & (power > _NO_BEAT * lines[:, None])
    return np.asarray(beats.any(axis=1))


def _score(comb: TorqueComb, angle: Floats) -> float:
    return float(line_scores(comb.torque, angle, comb.orders, comb.floor).sum())


def _turned(angle: Floats) -> float:
    return abs(float(angle[-1] - angle[0]))
