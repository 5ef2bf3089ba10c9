"""Mechanisms as columns of a regression, for those that are functions of angle, speed and time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import lcm, pi

import numpy as np
from numpy.typing import NDArray

from proof.baselines.calibrated import CalibratedRun
from proof.baselines.named_lines import BLADES, MAINS, TEETH
from torquerig.inference.places import SAME_ORDER
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor
from torquerig.scenario.kinematics import kinematics_of

Floats = NDArray[np.float64]

_STRIBECK_SPEEDS = (0.3, 1.0, 3.0)  # [rad/s]
_DRIFT_TIMES = (0.1, 0.3, 1.0)  # of the run
_HARMONICS_OF_MAINS = (1, 2, 3)


@dataclass(frozen=True)
class Column:
    """A column: mechanism (empty: of the nominal model), parameter, place, and values.

    ``values`` (samples,) [N m per unit of its coefficient].
    """

    mechanism: str
    parameter: str
    at: float
    values: Floats


def columns_of(
    run: CalibratedRun, rows: NDArray[np.int64], rig: Rig, *, runs: int, number: int, tones: Sequence[float]
) -> Iterator[Column]:
    """Yield every column of run ``number`` of ``runs`` at its samples ``rows``; the set is the same for every run.

    Parameters
    ----------
    tones : sequence of float
        Fixed frequencies [Hz] of unexplained lines, as candidates for aliased PWM tones.
    """
    angle, time, speed = run.angle[rows], rows / run.rate, run.speed[rows]
    turning = _Turning(angle, time, speed, run.torque.size / run.rate, kinematics_of(rig).ratio)
    for each in range(runs):
        yield Column("", "level", float(each), np.full(rows.size, float(each == number)))
    yield Column("", "viscous", 0.0, speed / turning.ratio)
    yield from turning.nominal_lines(rig)
    yield from turning.slow()
    yield from turning.shaft_lines(rig, float(run.torque.mean()))
    yield from turning.fixed(tones)


@dataclass(frozen=True)
class _Turning:
    """Angle [rad] and speed [rad/s] of the motor over time [s], of one run."""

    angle: Floats
    time: Floats
    speed: Floats
    duration: float
    ratio: float

    def nominal_lines(self, rig: Rig) -> Iterator[Column]:
        """Yield the lines of the nominal model."""
        for order in nominal_orders(rig):
            yield from _pair("", "order_motor", order, order * self.angle)

    def slow(self) -> Iterator[Column]:
        """Yield friction, drag and drift."""
        turns = self.speed / self.ratio
        sign = np.tanh(turns / 0.02)
        yield Column("quadratic_drag", "coefficient_Nms2", 0.0, turns * np.abs(turns))
        yield Column("stribeck_friction", "coulomb_Nm", 0.0, sign)
        for speed in _STRIBECK_SPEEDS:
            yield Column("stribeck_friction", "stribeck_rad_s", speed, sign * np.exp(-((turns / speed) ** 2)))
        yield Column("sensor_drift", "span_V", 0.0, self.time / self.duration)
        for share in _DRIFT_TIMES:
            constant = share * self.duration
            yield Column("sensor_drift", "time_constant_s", constant, 1 - np.exp(-self.time / constant))

    def shaft_lines(self, rig: Rig, torque: float) -> Iterator[Column]:
        """Yield cogging, commutation (proportional to the mean torque), teeth and blades; every order once."""
        motor = next(iter(rig.parts_of(Motor)), None)
        taken = nominal_orders(rig)
        if motor is not None and motor.slots and motor.pole_pairs:
            pulses = 6.0 * motor.pole_pairs
            for one in _pair("commutation_ripple", "order_motor", pulses, pulses * self.angle):
                yield replace(one, values=torque * one.values)
            for order in (lcm(motor.slots, 2 * motor.pole_pairs), motor.slots, 2 * motor.pole_pairs):
                if float(order) not in taken:
                    taken.append(float(order))
                    yield from _pair("cogging", "order_motor", float(order), order * self.angle)
        for name, orders in (("blade_pass", BLADES), ("gear_mesh", TEETH)):
            for order in orders:
                if not any(abs(order / self.ratio - other) < SAME_ORDER for other in taken):
                    yield from _pair(name, "order_output", float(order), order * self.angle / self.ratio)

    def fixed(self, tones: Sequence[float]) -> Iterator[Column]:
        """Yield mains lines and the candidate tones."""
        for grid in MAINS:
            for harmonic in _HARMONICS_OF_MAINS:
                yield from _pair("mains_interference", "frequency_Hz", grid, 2 * pi * grid * harmonic * self.time)
        for tone in tones:
            yield from _pair("pwm_aliasing", "frequency_Hz", tone, 2 * pi * tone * self.time)


def nominal_orders(rig: Rig) -> list[float]:
    """Return the motor orders [1/rev] of the lines of the nominal model."""
    return sorted({round(line.order, 6) for line in Twin(rig).lines()})


def _pair(mechanism: str, parameter: str, at: float, phase: Floats) -> Iterator[Column]:
    yield Column(mechanism, parameter, at, np.cos(phase))
    yield Column(mechanism, parameter, at, np.sin(phase))
