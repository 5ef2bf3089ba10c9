"""The motor's angle from the torque alone: the known orders near the set-point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.orders.angle.comb_score import noise_floor_at, order_power
from torquerig.orders.angle.measured_angle import TWO_SIDED, MotorAngle
from torquerig.orders.angle.order_peaks import order_peaks
from torquerig.orders.angle.periodic_angle_error import periodic_angle_error
from torquerig.orders.angle.speed_posterior import REACH, TOLERANCE, speed_posterior
from torquerig.orders.angle.varying_angle import TorqueComb, varying_angle
from torquerig.recordings.set_point import set_point_profile

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

_MAINS = (50.0, 60.0)  # [Hz]
_DETERMINED = 0.5 * TOLERANCE  # [1] a wider 95 % interval says little more than the set-point
_SET_POINT_ALONE = "from the set-point alone: the lines of the torque do not determine the speed"


def motor_angle_from_torque(
    recording: Recording,
    lines: Sequence[KinematicLine],
    *,
    also: Sequence[float] = (),
    largest_deviation: float = np.inf,
) -> MotorAngle:
    """Return the motor's angle from the lines of the torque, or from the set-point where they do not determine it.

    The set-point profile is scaled by one factor (:func:`~torquerig.orders.angle.speed_posterior.speed_posterior`).
    In a steady run the common phase of the lines then shows whether the speed drifts. Where the lines are smeared by
    a speed that varies by per cents, the most likely speed over time is sought.

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
    ``half_width`` is that of the 95 % interval of the posterior; with a drift, the uncertainty of the drift between the
    two ends is added. Where the interval is wider than half the tolerance of a set-point, 1 %, the result is the
    set-point with this tolerance, and ``origin`` states it. The zero of the shaft's angle is not determined.
    """
    if recording.run.profile == "reversal":
        raise RecordingError(
            f"{recording.name}: a reversal has no comb of lines to find the speed from; record an encoder channel"
        )
    speed = set_point_profile(recording, "lines that follow the speed")
    if recording.samples < 4:
        raise RecordingError(f"{recording.name}: {recording.samples} samples hold no line; take a longer recording")
    nominal = np.cumsum(speed) / recording.sample_rate
    orders = np.array(sorted({float(f"{order:.9g}") for order in (*(line.motor_order for line in lines), *also)}))
    return _fitted(recording, nominal, orders, largest_deviation=min(largest_deviation, REACH))


def _fitted(recording: Recording, nominal: Floats, orders: Floats, *, largest_deviation: float) -> MotorAngle:
    """Return the angle of the set-point [rad] times the factor that the lines determine, with a confirmed variation."""
    torque, rate = recording.torque(), recording.sample_rate
    is_steady = recording.run.profile == "steady"
    turned = abs(float(nominal[-1] - nominal[0]))
    hertz = turned / (2 * np.pi) / (nominal.size - 1) * rate
    mains = tuple(each / hertz for each in _MAINS) if is_steady else ()
    peaks = order_peaks(torque, nominal, orders, reach=REACH)
    found = speed_posterior(peaks, orders, mains=mains)
    is_determined = found.half_width < _DETERMINED
    factor, half_width, origin = 1.0, TOLERANCE, _SET_POINT_ALONE
    if is_determined:
        factor, half_width = 1 + found.middle, found.half_width
        name = "set-point" if is_steady else "set-point profile"
        origin = f"from the {name} times {factor:.5f}, by the lines of the torque"
    constant = MotorAngle(nominal * factor, origin, half_width, half_width * turned / TWO_SIDED)
    if not is_steady:
        return constant
    power, per_bin = order_power(torque, nominal)
    floor = noise_floor_at(power, orders / per_bin, within=REACH)
    comb = TorqueComb(torque, nominal, orders, floor, rate, peaks, mains)
    varying = varying_angle(comb, constant, is_determined=is_determined, largest_deviation=largest_deviation)
    if varying is None and not is_determined:
        return constant
    best = varying or constant
    periodic = periodic_angle_error(torque, best.values, orders, comb.floor)
    # the mean speed stays the one that was found
    periodic = periodic - np.linspace(periodic[0], periodic[-1], periodic.size)
    return replace(best, values=best.values + periodic)
