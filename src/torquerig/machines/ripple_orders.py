"""The torque lines of a machine and its control at a steady speed, for the ripple of the torque-level model."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import ceil, gcd, pi

import numpy as np

from torquerig.errors import InputError
from torquerig.machines.control import Control
from torquerig.machines.demand import TorqueDemand
from torquerig.machines.drive_run import run_drive
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.shaft import ImposedSpeed

ELECTRICAL_ORDERS = 36  # up to six times the six-step line
FEWEST_ORDERS = 6
SETTLING = 25.0  # time constants, after which a transient has decayed to 1e-11
FEWEST_SAMPLES = 4096


@dataclass(frozen=True)
class RippleLine:
    """``T = T_mean (1 + depth cos(order_motor angle + phase))``, the line that ``commutation_ripple`` takes."""

    order_motor: int
    depth: float
    phase: float


@dataclass(frozen=True)
class RippleOrders:
    """The torque's mean [N*m] and its lines at whole electrical orders, at the ``speed`` [rad/s] that was run."""

    speed: float
    demanded_torque: float
    mean_torque: float
    lines: tuple[RippleLine, ...]

    def depth(self, order_motor: int) -> float:
        """Return the amplitude of a motor order relative to the mean torque; 0 where no line can stand."""
        return next((line.depth for line in self.lines if line.order_motor == order_motor), 0.0)

    def amplitude(self, order_motor: int) -> float:
        """Return the amplitude of a motor order [N*m]."""
        return self.depth(order_motor) * abs(self.mean_torque)

    def above(self, depth: float) -> tuple[RippleLine, ...]:
        """Return the lines deeper than ``depth``, strongest first."""
        return tuple(sorted((line for line in self.lines if line.depth > depth), key=lambda line: -line.depth))


@cache
def ripple_orders(
    machine: PermanentMagnetMachine, control: Control, *, speed: float, torque: float, substeps: int = 4
) -> RippleOrders:
    """Return the torque lines at imposed ``speed`` [rad/s] and demanded ``torque`` [N*m], computed once.

    The speed is moved by up to half a period per measured stretch, so that whole turns fill whole periods and no line
    leaks into another; the number of periods shares no factor with that of the turns, so that what lies above half the
    sampling rate does not fold onto a line. Orders go up to 36 per electrical turn, or to the last multiple of six that
    the sampling shows. Mechanical sub-orders (unequal poles) are outside this model.

    Raises
    ------
    InputError
        When the period is too long to show even six orders at this speed, or torque or speed is zero.
    """
    if speed == 0 or torque == 0:
        raise InputError(
            "ripple_orders: a ripple relative to the mean torque needs speed and torque; write both non-zero"
        )
    orders, turns, periods = _stretch(machine.pole_pairs * abs(speed), control.period)
    run_speed = float(np.sign(speed)) * turns * 2 * pi / (machine.pole_pairs * periods * control.period)
    settling = SETTLING * (machine.time_constant + 1 / (2 * pi * control.bandwidth))
    settling_periods = periods * ceil(settling / (periods * control.period))
    run = run_drive(
        machine,
        control,
        shaft=ImposedSpeed(speed=run_speed),
        demand=TorqueDemand(torque=torque),
        duration=(settling_periods + periods) * control.period,
        substeps=substeps,
    )
    spectrum = np.fft.rfft(run.torque[-periods:]) / periods
    mean = float(spectrum[0].real)
    found = 2 * spectrum[turns * np.arange(1, orders + 1)] / mean
    if speed < 0:
        found = np.conj(found)
    lines = tuple(
        RippleLine(order * machine.pole_pairs, float(abs(line)), float(np.angle(line)))
        for order, line in enumerate(found, start=1)
    )
    return RippleOrders(run_speed, torque, mean, lines)


def _stretch(electrical_speed: float, period: float) -> tuple[int, int, int]:
    """Return orders that show, and electrical turns and sampling periods of the stretch, without a common factor."""
    per_turn = 2 * pi / (electrical_speed * period)
    if per_turn <= 2 * FEWEST_ORDERS:
        raise InputError(
            f"ripple_orders: {per_turn:.3g} samples per electrical turn cannot show {FEWEST_ORDERS} orders; "
            f"shorten the period to {per_turn * period / (2 * FEWEST_ORDERS + 1) * 1e6:.3g} us, or a lower speed"
        )
    shown = min(ELECTRICAL_ORDERS, ceil(per_turn / (2 * FEWEST_ORDERS) - 1) * FEWEST_ORDERS)
    turns = max(7, ceil(FEWEST_SAMPLES / per_turn))
    periods = round(turns * per_turn)
    while gcd(turns, periods) > 1:
        periods += 1
    return shown, turns, periods
