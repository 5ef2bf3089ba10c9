"""The motor's angle from the torque alone: the comb of known orders near the set-point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.orders.angle.comb_score import comb_score, noise_floor_at, order_power
from torquerig.orders.angle.measured_angle import MotorAngle
from torquerig.orders.angle.periodic_angle_error import periodic_angle_error
from torquerig.orders.angle.slow_angle_drift import ACCELERATION, slow_angle_drift
from torquerig.orders.angle.speed_trajectory import speed_trajectory
from torquerig.recordings.set_point import set_point_profile

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

_SET_POINT_ERROR = 0.015  # [1] largest relative deviation of the speed from the set-point (CONTRACTS.md: 0.01)
_SET_POINT_SD = _SET_POINT_ERROR / np.sqrt(3)  # [1] its standard deviation, where no line improves on it
_CLEAR = 5.0  # robust standard deviations of the best score over the median, at least
_TRAJECTORY_PENALTY = 3.0  # score by which a free speed trajectory must exceed a constant factor
_TRAJECTORY_ROUNDS = 2  # drift estimates after a trajectory: the first one smooths its steps
_LOWEST_SCORE = 20.0  # score of the lines along an accepted angle, at least; noise alone reached half of it
_SET_POINT_ALONE = "from the set-point alone: no comb of lines exceeds the noise"


def motor_angle_from_torque(
    recording: Recording,
    lines: Sequence[KinematicLine],
    *,
    also: Sequence[float] = (),
    largest_deviation: float = np.inf,
) -> MotorAngle:
    """Return the motor's angle with the highest score of the comb of ``lines`` in the torque.

    The set-point profile is scaled by one factor within 1.5 %, found by the summed log power at all orders. In a
    steady run, slow deviations from it are then estimated from the common phase of the lines above the noise.

    Parameters
    ----------
    recording : Recording
        A steady run or a ramp, with the set-point speed in its run.
    lines : sequence of KinematicLine
        The lines to search.
    also : sequence of float
        Further orders of the motor to search [1/rev].
    largest_deviation : float
        Largest relative deviation of the mean speed of a steady run from its set-point [1]; a trajectory beyond it has
        followed a strong unknown line.

    Raises
    ------
    RecordingError
        For a run without a set-point, or a reversal, where the method does not apply.

    Notes
    -----
    ``speed_sd`` is the larger of two: the Cramer-Rao bound of the lines above the noise, phases unknown (Rife &
    Boorstyn 1974, IEEE Trans. Inf. Theory 20, eq. 17), and the uncertainty of the drift between the two ends.
    Source: maximum likelihood of a harmonic comb in coloured noise (Fyfe & Munck 1997 for the need). Where no line
    exceeds the noise, the result is the set-point, and ``origin`` states it. The zero of the shaft's angle is not
    determined.
    """
    if recording.run.profile == "reversal":
        raise RecordingError(
            f"{recording.name}: a reversal has no comb of lines to find the speed from; record an encoder channel"
        )
    speed = set_point_profile(recording, "lines that follow the speed")
    if recording.samples < 4:
        raise RecordingError(f"{recording.name}: {recording.samples} samples hold no line; take a longer recording")
    nominal = np.cumsum(speed) / recording.sample_rate
    torque = recording.torque()
    orders = np.array(sorted({float(f"{order:.9g}") for order in (*(line.motor_order for line in lines), *also)}))
    comb = _comb(torque, nominal, orders)
    if recording.run.profile != "steady":
        if not comb.is_clear:
            return MotorAngle(nominal, _SET_POINT_ALONE, comb.sd)
        origin = f"from the set-point profile times {comb.factor:.5f}, by the comb of lines"
        return MotorAngle(nominal * comb.factor, origin, comb.sd)
    found = _steady_angles(torque, nominal, orders, comb, recording.sample_rate)
    turned = nominal[-1] - nominal[0]
    near = [each for each in found if abs((each.angle[-1] - each.angle[0]) / turned - 1) < largest_deviation]
    return _best_of(near, torque, nominal, orders, comb)


@dataclass(frozen=True)
class _Found:
    """A candidate angle [rad], its source in words, the uncertainty between its ends [rad], and its penalty [1]."""

    angle: NDArray[np.float64]
    origin: str
    ends: float
    penalty: float = 0.0


def _steady_angles(
    torque: NDArray[np.float64], nominal: NDArray[np.float64], orders: NDArray[np.float64], comb: _Comb, rate: float
) -> list[_Found]:
    """Return the candidates: a constant factor, the same with a slow drift, and a free speed trajectory.

    The factor need not be clear here, because strong lines that do not belong to the comb can hide its maximum. The
    candidates are compared later by the score of the lines along each angle.
    """
    scaled = nominal * comb.factor
    scaled = scaled + periodic_angle_error(torque, scaled, orders, comb.floor)
    drift, ends = slow_angle_drift(torque, scaled, orders, comb.floor, rate)
    origin = f"from the set-point times {comb.factor:.5f}"
    found = [
        _Found(scaled, f"{origin}, by the comb of lines", ends),
        _Found(scaled + drift, f"{origin} and its slow drift, by the comb of lines", ends),
    ]
    relative = speed_trajectory(torque, nominal, orders, rate=rate)
    if relative is not None:
        angle = np.cumsum(np.gradient(nominal) * relative)
        largest = max(ACCELERATION, float(np.abs(np.diff(relative)).max()) * rate)
        for _ in range(_TRAJECTORY_ROUNDS):
            drift, ends = slow_angle_drift(
                torque, angle, orders, comb.floor, rate, acceleration=largest, factors=(1.0,)
            )
            angle = angle + drift
            angle = angle + periodic_angle_error(torque, angle, orders, comb.floor)
        origin = "from the speed over time, by the comb of lines near the set-point"
        found.append(_Found(angle, origin, ends, penalty=_TRAJECTORY_PENALTY))
    return found


def _best_of(
    found: Sequence[_Found],
    torque: NDArray[np.float64],
    nominal: NDArray[np.float64],
    orders: NDArray[np.float64],
    comb: _Comb,
) -> MotorAngle:
    """Return the candidate with the highest score less its penalty; the set-point's where all scores are too low."""
    scores = [comb_score(torque, each.angle, orders, comb.floor) for each in found]
    if not found or max(scores) < _LOWEST_SCORE:
        return MotorAngle(nominal, _SET_POINT_ALONE, _SET_POINT_SD)
    best = found[int(np.argmax([score - each.penalty for score, each in zip(scores, found, strict=True)]))]
    angle = best.angle + periodic_angle_error(torque, best.angle, orders, comb.floor)
    known = comb.sd if comb.is_clear else 0.0
    return MotorAngle(angle, best.origin, max(known, best.ends / abs(float(angle[-1] - angle[0]))))


@dataclass(frozen=True)
class _Comb:
    """The most likely factor on the set-point, its uncertainty, and the noise power of a bin near each line [unit^2].

    Where the factor is not clear, the uncertainty is that of the set-point.
    """

    factor: float
    sd: float
    floor: NDArray[np.float64]
    is_clear: bool


def _comb(torque: NDArray[np.float64], nominal: NDArray[np.float64], orders: NDArray[np.float64]) -> _Comb:
    """Return the speed factor with the largest summed log power of the order spectrum at the lines."""
    power, per_bin = order_power(torque, nominal)
    seen = orders[orders * (1 + _SET_POINT_ERROR) / per_bin < 0.9 * power.size]
    floor = noise_floor_at(power, orders / per_bin, within=_SET_POINT_ERROR)
    step = 0.25 * per_bin / max(seen.max(initial=1.0), 1.0)
    factors = 1 + np.arange(-_SET_POINT_ERROR, _SET_POINT_ERROR, step)
    score = np.zeros(factors.size)
    information = np.zeros(factors.size)
    bins = np.arange(power.size)
    for order, level in zip(orders, floor, strict=True):
        if order in seen:
            excess = np.interp(order * factors / per_bin, bins, power) / level
            score += np.log1p(excess)
            # a line exceeds what noise reaches with probability e^-7; its phase has 2 pi / per_bin samples
            information += np.where(excess > 7, excess, 0.0) * (2 * np.pi * order / per_bin) ** 2 / 6
    best = int(np.argmax(score))
    deviation = 1.4826 * float(np.median(np.abs(score - np.median(score))))
    is_clear = bool(score[best] - np.median(score) > _CLEAR * deviation and information[best])
    sd = float(1 / np.sqrt(information[best])) if is_clear else _SET_POINT_SD
    return _Comb(float(factors[best]), sd, floor, is_clear)
