"""A motor: rotor inertia, bearing and iron friction, torque limit, and the lag of its current."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.machines.winding import has_winding, no_winding
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import IN_A_MOTOR, HostChange
from torquerig.rig.terms import Friction, Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Motor(Part):
    """The rotor and its drive stage; the torque itself comes from a SpeedController.

    Losses: ``viscous w + coulomb tanh(w / smoothing)`` on the rotor; 0.5 rad/s is the smoothing of the reference rig.
    ``model`` is its name in the catalog. Pole pairs and slots are kinematics: the lines follow from them, the torque
    does not.
    """

    on_shaft: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_MOTOR

    kind: Literal["motor"] = "motor"
    model: str = ""
    inertia: Annotated[float, Parameter("kg*m^2", "rotor inertia", above=0)]
    viscous: Annotated[float, Parameter("N*m*s/rad", "viscous friction", low=0)] = 0.0
    coulomb: Annotated[float, Parameter("N*m", "Coulomb friction", low=0)] = 0.0
    smoothing: Annotated[float, Parameter("rad/s", "speed over which the sign is smoothed", above=0)] = 0.5
    torque_limit: Annotated[float, Parameter("N*m", "torque limit of the drive", above=0)]
    current_loop_bandwidth: Annotated[float, Parameter("Hz", "bandwidth of the current loop", above=0)] = 500.0
    pole_pairs: int | None = None
    slots: int | None = None

    def __post_init__(self) -> None:
        if self.pole_pairs is None or self.slots is None:
            return
        if self.pole_pairs < 1 or self.slots < 3:
            raise ValueError(f"{self.slots} slots and {self.pole_pairs} pole pairs cannot be; write at least 3 and 1")
        if not has_winding(self.pole_pairs, self.slots):
            raise ValueError(no_winding(self.pole_pairs, self.slots))

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return rotor inertia and losses."""
        node = rig.node(self.name)
        losses = Friction(
            name=f"{self.name}.losses",
            on=node,
            viscous=self.viscous,
            coulomb_forward=self.coulomb,
            coulomb_backward=self.coulomb,
            static_forward=self.coulomb,
            static_backward=self.coulomb,
            smoothing=self.smoothing,
        )
        return Inertia(node=node, inertia=self.inertia), losses
