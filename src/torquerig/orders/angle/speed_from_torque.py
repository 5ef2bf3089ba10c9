"""What angle the motor turned through, judged from the torque alone: the comb of known orders around the set-point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.orders.angle.angle_within_a_turn import angle_within_a_turn
from torquerig.orders.angle.coherence import coherence, floor_beside, order_power
from torquerig.orders.angle.measured_angle import MotorAngle
from torquerig.orders.angle.speed_course import speed_course
from torquerig.orders.angle.wander import ACCELERATION, wander
from torquerig.recordings.set_point import set_point_profile

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

_SET_POINT_ERROR = 0.015  # share by which the real speed may differ from the set-point (the rig's sheet: 0.01)
_UNTOLD = _SET_POINT_ERROR / np.sqrt(3)  # its standard deviation where no line tells more
_STANDS_OUT = 5.0  # robust standard deviations by which the comb's best score must exceed its median
_PLAINER = 3.0  # by which a free course must be the more coherent
_COURSE_ROUNDS = 2  # of following the lines' phases after a course: the first straightens its steps
_COHERENT = 20.0  # by which a course's lines must stand out: noise alone, followed, has been seen at half of it
_NONE_STANDS_OUT = "from the set-point alone: no comb of lines stands out"


def motor_angle_from_torque(
    recording: Recording, lines: Sequence[KinematicLine], *, also: Sequence[float] = (), strays: float = np.inf
) -> MotorAngle:
    """Return the motor's angle for which the comb of ``lines`` stands out most in the torque.

    The set-point profile is scaled by one factor within 1.5 %, found by the summed log power at all orders; in a
    steady run the slow wander around it is then followed by the common phase of the lines that stand out.

    Parameters
    ----------
    recording : Recording
        A steady run or a ramp, with the set-point speed in its run.
    lines : sequence of KinematicLine
        The lines to look for.
    also : sequence of float
        Further orders of the motor to look for [1/rev].
    strays : float
        By what share the mean speed of a steady run may leave its set-point; a course that leaves it by more has gone
        after a strong line that nobody knows [1].

    Raises
    ------
    RecordingError
        For a run without a set-point, or a reversal, where a comb has no footing.

    Notes
    -----
    ``speed_sd`` is the larger of two: the Cramer-Rao bound of the lines that stand out, phases unknown (Rife & Boorstyn
    1974, IEEE Trans. Inf. Theory 20, eq. 17), and what the wander leaves unknown of the angle between the two ends.
    Source: maximum likelihood of a harmonic comb in coloured noise (Fyfe & Munck 1997 for the need). It stops being
    true where no line stands out (then it is the set-point, and says so), and it tells the course of the angle, not
    where the shaft's zero is.
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
        if not comb.stands_out:
            return MotorAngle(nominal, _NONE_STANDS_OUT, comb.sd)
        told = f"from the set-point profile times {comb.factor:.5f}, by the comb of lines"
        return MotorAngle(nominal * comb.factor, told, comb.sd)
    found = _steady_angles(torque, nominal, orders, comb, recording.sample_rate)
    turned = nominal[-1] - nominal[0]
    near = [each for each in found if abs((each.angle[-1] - each.angle[0]) / turned - 1) < strays]
    return _best_of(near, torque, nominal, orders, comb)


@dataclass(frozen=True)
class _Found:
    """An angle [rad], what is told of it, the uncertainty between its ends [rad], and what it must gain [1]."""

    angle: NDArray[np.float64]
    told: str
    ends: float
    price: float = 0.0


def _steady_angles(
    torque: NDArray[np.float64], nominal: NDArray[np.float64], orders: NDArray[np.float64], comb: _Comb, rate: float
) -> list[_Found]:
    """Return one factor, the same with a slow wander, and a course that leaves the factor by per cents.

    The factor need not stand out of its neighbours: strong lines beside the comb hide how much better it is, and
    whether it is will be asked of the lines along the angle. So will be whether the wander makes them clearer.
    """
    scaled = nominal * comb.factor
    scaled = scaled + angle_within_a_turn(torque, scaled, orders, comb.floor)
    strayed, ends = wander(torque, scaled, orders, comb.floor, rate)
    told = f"from the set-point times {comb.factor:.5f}"
    found = [
        _Found(scaled, f"{told}, by the comb of lines", ends),
        _Found(scaled + strayed, f"{told} and its wander, by the comb of lines", ends),
    ]
    course = speed_course(torque, nominal, orders, rate=rate)
    if course is not None:
        angle = np.cumsum(np.gradient(nominal) * course)
        bend = max(ACCELERATION, float(np.abs(np.diff(course)).max()) * rate)
        for _ in range(_COURSE_ROUNDS):
            strayed, ends = wander(torque, angle, orders, comb.floor, rate, acceleration=bend, livelier=(1.0,))
            angle = angle + strayed
            angle = angle + angle_within_a_turn(torque, angle, orders, comb.floor)
        told = "from the course of the comb of lines around the set-point"
        found.append(_Found(angle, told, ends, price=_PLAINER))
    return found


def _best_of(
    found: Sequence[_Found],
    torque: NDArray[np.float64],
    nominal: NDArray[np.float64],
    orders: NDArray[np.float64],
    comb: _Comb,
) -> MotorAngle:
    """Return the angle along which the lines stand out most, the set-point's where they stand out in none."""
    heights = [coherence(torque, each.angle, orders, comb.floor) for each in found]
    if not found or max(heights) < _COHERENT:
        return MotorAngle(nominal, _NONE_STANDS_OUT, _UNTOLD)
    best = found[int(np.argmax([height - each.price for height, each in zip(heights, found, strict=True)]))]
    angle = best.angle + angle_within_a_turn(torque, best.angle, orders, comb.floor)
    known = comb.sd if comb.stands_out else 0.0
    return MotorAngle(angle, best.told, max(known, best.ends / abs(float(angle[-1] - angle[0]))))


@dataclass(frozen=True)
class _Comb:
    """The likeliest factor on the set-point, its uncertainty, and the noise power of a bin beside each line [unit^2].

    Where the factor does not stand out the uncertainty is that of the set-point.
    """

    factor: float
    sd: float
    floor: NDArray[np.float64]
    stands_out: bool


def _comb(torque: NDArray[np.float64], nominal: NDArray[np.float64], orders: NDArray[np.float64]) -> _Comb:
    """Scan the speed factor for the largest summed log power of the order spectrum at the lines."""
    power, per_bin = order_power(torque, nominal)
    seen = orders[orders * (1 + _SET_POINT_ERROR) / per_bin < 0.9 * power.size]
    floor = floor_beside(power, orders / per_bin, within=_SET_POINT_ERROR)
    step = 0.25 * per_bin / max(seen.max(initial=1.0), 1.0)
    factors = 1 + np.arange(-_SET_POINT_ERROR, _SET_POINT_ERROR, step)
    score = np.zeros(factors.size)
    information = np.zeros(factors.size)
    bins = np.arange(power.size)
    for order, level in zip(orders, floor, strict=True):
        if order in seen:
            excess = np.interp(order * factors / per_bin, bins, power) / level
            score += np.log1p(excess)
            # only what the floor itself hardly ever reaches (e^-7) is a line; 2 pi / per_bin samples of its phase
            information += np.where(excess > 7, excess, 0.0) * (2 * np.pi * order / per_bin) ** 2 / 6
    best = int(np.argmax(score))
    spread = 1.4826 * float(np.median(np.abs(score - np.median(score))))
    stands_out = bool(score[best] - np.median(score) > _STANDS_OUT * spread and information[best])
    sd = float(1 / np.sqrt(information[best])) if stands_out else _UNTOLD
    return _Comb(float(factors[best]), sd, floor, stands_out)
