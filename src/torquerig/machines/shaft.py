"""The shaft of a machine: an imposed speed, or a load on a spring."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from torquerig.machines import kernel
from torquerig.machines.checks import check_fields
from torquerig.parameter import Parameter


@dataclass(frozen=True, kw_only=True)
class ImposedSpeed:
    """A dynamometer that imposes the speed independent of the torque, as for measuring a motor's ripple."""

    speed: Annotated[float, Parameter("rad/s", "speed of the rotor")]

    def __post_init__(self) -> None:
        check_fields(self)

    def kernel_row(self) -> kernel.Shaft:
        """Return the shaft in the layout of the kernel: infinite inertias."""
        return kernel.Shaft(0.0, 0.0, 0.0, 0.0, 0.0, self.speed)


@dataclass(frozen=True, kw_only=True)
class TwoMasses:
    """Rotor, spring, load: ``J1 w1' = T - Ts``, ``J2 w2' = Ts - T_load`` with ``Ts = k (a1 - a2) + d (w1 - w2)``.

    ``load_torque`` is constant and has a sign; both masses start at ``initial_speed`` with the spring at rest.
    """

    rotor_inertia: Annotated[float, Parameter("kg*m^2", "rotor inertia", above=0)]
    load_inertia: Annotated[float, Parameter("kg*m^2", "load inertia", above=0)]
    stiffness: Annotated[float, Parameter("N*m/rad", "torsional stiffness", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "damping of the spring", low=0)] = 0.0
    load_torque: Annotated[float, Parameter("N*m", "constant load torque")] = 0.0
    initial_speed: Annotated[float, Parameter("rad/s", "speed at the start")] = 0.0

    def __post_init__(self) -> None:
        check_fields(self)

    def kernel_row(self) -> kernel.Shaft:
        """Return the shaft in the layout of the kernel."""
        inverse_rotor, inverse_load = 1 / self.rotor_inertia, 1 / self.load_inertia
        stiffness, damping = self.stiffness, self.damping
        return kernel.Shaft(inverse_rotor, inverse_load, stiffness, damping, self.load_torque, self.initial_speed)


Shaft = ImposedSpeed | TwoMasses
