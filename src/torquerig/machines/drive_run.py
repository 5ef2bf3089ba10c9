"""A run of a machine with its control on a shaft: torque, currents, angle and speed at every sampling period."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import SimulationError
from torquerig.machines import kernel
from torquerig.machines.control import Control
from torquerig.machines.demand import Demand
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.shaft import Shaft

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class DriveRun:
    """The results of a run, sampled at the start of each period."""

    period: float
    rows: Floats

    @property
    def torque(self) -> Floats:
        """Electromagnetic torque, (n,) [N*m]."""
        return self.rows[:, kernel.TORQUE]

    @property
    def currents(self) -> Floats:
        """Currents of the three phases, (n, 3) [A]."""
        return self.rows[:, kernel.CURRENT_A : kernel.CURRENT_C + 1]

    @property
    def angle(self) -> Floats:
        """Mechanical rotor angle, (n,) [rad]."""
        return self.rows[:, kernel.ANGLE]

    @property
    def speed(self) -> Floats:
        """Rotor speed, (n,) [rad/s]."""
        return self.rows[:, kernel.SPEED]

    @property
    def shaft_torque(self) -> Floats:
        """Torque in the spring, (n,) [N*m]; zero at an imposed speed."""
        return self.rows[:, kernel.SHAFT_TORQUE]

    @property
    def load_speed(self) -> Floats:
        """Speed of the load, (n,) [rad/s]."""
        return self.rows[:, kernel.LOAD_SPEED]


def run_drive(
    machine: PermanentMagnetMachine,
    control: Control,
    *,
    shaft: Shaft,
    demand: Demand,
    duration: float,
    substeps: int = 1,
) -> DriveRun:
    """Return the run from rest of the currents, over ``duration`` [s]; the same inputs give the same bytes.

    ``substeps`` are Runge-Kutta steps per period; one is enough while the electrical angle moves less than about
    0.2 rad in a period.

    Raises
    ------
    SimulationError
        When the run leaves the finite numbers: names the state and the time.
    """
    periods = max(1, round(duration / control.period))
    rows = control.integrate(machine, shaft=shaft, demand=demand, periods=periods, substeps=substeps)
    if not np.isfinite(rows[-1]).all():
        first = int(np.argmin(np.isfinite(rows).all(axis=1)))
        raise SimulationError(
            f"the machine's run leaves the finite numbers at {first * control.period:g} s; its fastest mode is too "
            "fast for the period, shorten the period or raise substeps"
        )
    return DriveRun(control.period, rows)
