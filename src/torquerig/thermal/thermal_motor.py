"""Thermal model of one variant of a motor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.thermal.two_node import Stretch, TwoNode

COPPER = 0.00393  # [1/K] of 20 C: temperature coefficient of resistance of annealed copper (IEC 60028)
COLD = 20.0  # [C] at which resistances are stated
IRON_EXPONENT = 1.5  # between hysteresis (1) and eddy currents (2)


@dataclass(frozen=True, kw_only=True)
class ThermalMotor:
    """Losses, network and limit of one variant.

    Copper loss ``q T^2 (1 + 0.00393 (Tw - 20 C))`` heats the winding, q = 3 R20 / Kt^2; friction and iron loss heat
    the housing: ``coulomb w + viscous w^2 + iron (w / rated)^1.5``. Saturation (a torque constant that falls at peak
    torque), hot magnets, and switching losses of the drive are not included.

    Parameters
    ----------
    network : TwoNode
    copper_loss : float
        q at 20 C [W/(N m)^2].
    torque_constant : float
        Kt per rms ampere [N m/A]; NaN where it is unknown.
    coulomb, viscous : float
        Friction [N m], [N m s/rad].
    iron, rated_speed : float
        No-load loss other than friction [W] at the rated speed [rad/s].
    limit : float
        Largest winding temperature [C].
    """

    network: TwoNode
    copper_loss: float
    torque_constant: float
    coulomb: float
    viscous: float
    iron: float
    rated_speed: float
    limit: float

    @property
    def phase_resistance(self) -> float:
        """R of one phase at 20 C [ohm] that belongs to ``copper_loss``."""
        return self.copper_loss * self.torque_constant**2 / 3

    def current(self, torque: float) -> float:
        """Return the rms phase current [A] for a torque [N m]."""
        return torque / self.torque_constant

    def stretch(self, *, torque_square: float, speed: float, speed_square: float, ambient: float) -> Stretch:
        """Return the stretch of one mean square of torque and one speed, at ``ambient`` [C]."""
        cold = self.copper_loss * torque_square
        winding = cold * (1 + COPPER * (ambient - COLD))
        housing = self.loss_of_speed(speed, speed_square)
        return self.network.stretch(np.array([winding, housing]), COPPER * cold)

    def loss_of_speed(self, speed: float, speed_square: float) -> float:
        """Return friction and iron loss [W]."""
        iron = self.iron * float(np.power(speed / self.rated_speed, IRON_EXPONENT))
        return self.coulomb * speed + self.viscous * speed_square + iron
