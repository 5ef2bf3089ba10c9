"""Gear ratio of the least rms torque: the alpha-beta method, in closed form."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf, sqrt

import numpy as np

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.gearbox_use import behind_chain
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.output_torque import OutputTorque
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.rig.reading_place import effort_unit


@dataclass(frozen=True, kw_only=True)
class AlphaBeta:
    """The task at the output shaft and the inertia of a motor.

    With ``T`` the rms of the load's torque (its own inertia included), ``w`` the rms of its acceleration, ``P`` the
    mean of torque times acceleration, ``J`` the rotor, ``eta`` the efficiency and ``i`` the ratio, the motor's torque
    ``J w' i + T'/(i eta)`` has the mean square ``J^2 i^2 w^2 + T^2/(i eta)^2 + 2 J P / eta``: least at
    ``i = sqrt(T / (eta J w))``. A rating ``T_N`` gives the accelerating factor ``alpha = T_N^2 / J``, the task the load
    factor ``beta = 2 (w T + P)``; a motor can fit only if ``alpha >= beta / eta``, and then with every ratio for which
    ``(T / (eta i sqrt(J)) - w i sqrt(J))^2 <= alpha - beta / eta``.

    The separation of motor and load is of Van de Straete, Degezelle, De Schutter and Belmans, Servo motor selection
    criterion for mechatronic applications, IEEE/ASME Trans. Mechatronics 3 (1998) 43-50; the names and the form with an
    efficiency are of Giberti, Cinquemani and Legnani, The role of the gearbox in an automatic machine (2011),
    eq. 22-27 (tau there is 1/i). Not included: the motor's friction, the gearbox's inertia, power that flows
    back (eta as for forward power).

    Parameters
    ----------
    torque, acceleration, product : float
        T [N m], w [rad/s^2], P [N m rad/s^2].
    inertia : float
        J [kg m^2]
    efficiency : float
        eta [1]
    """

    torque: float
    acceleration: float
    product: float
    inertia: float
    efficiency: float = 1.0

    @property
    def best(self) -> float:
        """The ratio of the least rms torque [1]; infinite where the task never accelerates."""
        if self.acceleration == 0:
            return inf
        return sqrt(self.torque / (self.efficiency * self.inertia * self.acceleration))

    @property
    def beta(self) -> float:
        """The load factor of the task [W/s]."""
        return 2 * (self.acceleration * self.torque + self.product)

    def alpha(self, rating: float) -> float:
        """Return the accelerating factor of the motor with a continuous torque ``rating`` [N m], in [W/s]."""
        return rating**2 / self.inertia

    def rms_torque(self, ratio: float) -> float:
        """Return the rms torque of the motor with a ratio [N m]."""
        turned, borne = self.inertia * ratio * self.acceleration, self.torque / (ratio * self.efficiency)
        return sqrt(max(0.0, turned**2 + borne**2 + 2 * self.inertia * self.product / self.efficiency))

    def fitting(self, rating: float) -> tuple[float, float] | None:
        """Return the least and the largest ratio that the rating allows; None where no ratio does."""
        spare = self.alpha(rating) - self.beta / self.efficiency
        if spare < 0:
            return None
        root, borne = sqrt(spare), self.torque / self.efficiency
        if self.acceleration == 0:
            return (borne / rating if rating > 0 else inf), inf
        summed = sqrt(spare + 4 * self.acceleration * borne)
        scale = 2 * self.acceleration * sqrt(self.inertia)
        return (summed - root) / scale, (summed + root) / scale


def alpha_beta(drive: SizedDrive, values: Values | None = None) -> AlphaBeta:
    """Return the task of a drive's profile and its motor's rotor, for one set of open values.

    A step of the set-point is part of the task as this drive performs it, at its limit and present ratio.
    """
    chosen = {name: known.nominal() for name, known in drive.data.items()} | dict(values or {})
    behind, rig = behind_chain(drive, chosen), drive.with_values(chosen)
    efficiency = drive.gain(chosen) / drive.ratio
    inertia = float(getattr(rig.part(drive.part.name), "inertia", 0.0))
    return AlphaBeta(
        torque=behind.rms, acceleration=_rms(behind, behind.acceleration**2), inertia=inertia, efficiency=efficiency,
        product=float(_mean(behind, behind.torque.mean(axis=1) * behind.acceleration)),
    )  # fmt: skip


def best_ratio(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``ideal_ratio``, ``speed_ratio``, ``best_ratio`` and ``best_ratio_use`` [1].

    The ratio of the least rms torque; the largest that the motor's speed allows; the smaller of the two; and the rms
    torque there over the rated torque. Without acceleration in the cycle, the least rms torque is at no finite
    ratio: only the speed limits it. Empty where what is measured moves in a line: a lead takes the place of a ratio.
    """
    if effort_unit(drive.rig) == "N":
        return {}
    speed, rated = f"maximum speed of {drive.motor_name}", f"rated torque of {drive.motor_name}"
    top = float(np.abs(behind_chain(drive, {}).speed).max())
    known = {**drive.data, speed: drive.motor.max_speed}

    def reached(values: Values) -> float:
        return min(alpha_beta(drive, values).best, values[speed] / top)

    accelerates = alpha_beta(drive).acceleration > 0
    still = Figure(missing="an acceleration in the cycle: without one the largest ratio is the best")
    return {
        "ideal_ratio": over_intervals(drive.data, lambda v: alpha_beta(drive, v).best, source="alpha-beta")
        if accelerates else still,
        "speed_ratio": over_intervals(
            {speed: drive.motor.max_speed}, lambda v: v[speed] / top, source="maximum speed / output"
        ),
        "best_ratio": over_intervals(known, reached, source="alpha-beta, limited by the motor's speed"),
        "best_ratio_use": over_intervals(
            {**known, rated: drive.motor.rated_torque},
            lambda v: alpha_beta(drive, v).rms_torque(reached(v)) / v[rated],
            source="rms torque at the best ratio / rated torque",
        ),
    }  # fmt: skip


def _mean(behind: OutputTorque, pieces: np.ndarray) -> float:
    return float(np.sum(behind.duration * pieces) / behind.duration.sum())


def _rms(behind: OutputTorque, squares: np.ndarray) -> float:
    return sqrt(_mean(behind, squares))
