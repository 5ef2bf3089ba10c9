"""The interface of controls of a permanent-magnet machine: from a demand to phase currents through an inverter."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np
from numpy.typing import NDArray

from torquerig.machines.demand import Demand
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.shaft import Shaft


class Control(ABC):
    """A sampled current control with an averaged inverter: one voltage per period, no switching ripple."""

    period: float
    bandwidth: float

    @abstractmethod
    def torque_per_ampere(self, machine: PermanentMagnetMachine) -> float:
        """Return the mean torque per ampere of the current that this control regulates [N*m/A]."""

    @abstractmethod
    def integrate(
        self, machine: PermanentMagnetMachine, *, shaft: Shaft, demand: Demand, periods: int, substeps: int
    ) -> NDArray[np.float64]:
        """Return one row per period, as ``kernel`` lays it out, shape (periods, 8)."""
