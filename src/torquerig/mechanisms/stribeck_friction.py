"""Dry friction with a Stribeck peak, by direction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Friction, Term

Torque = Annotated[float, Parameter("N*m", "friction torque", low=0)]

Viscous = Annotated[float, Parameter("N*m*s/rad", "viscous friction", low=0)]


@dataclass(frozen=True, kw_only=True)
class StribeckFriction(Part):
    """``sign(w) (Tc + (Ts - Tc) exp(-(w/ws)^2))`` on the shaft of ``at``, sign as ``tanh(w / smoothing)``.

    ``viscous w`` is added, where stated. Backward values default to the forward ones. Below the smoothing speed it
    creeps where a real contact sticks. Source: Armstrong-Helouvry, Dupont & Canudas de Wit 1994, Automatica 30(7).
    """

    kind: Literal["stribeck_friction"] = "stribeck_friction"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    coulomb: Torque
    static: Torque
    stribeck_speed: Annotated[float, Parameter("rad/s", "Stribeck speed", above=0)]
    coulomb_backward: Torque | None = None
    static_backward: Torque | None = None
    viscous: Viscous = 0.0
    viscous_backward: Viscous | None = None
    smoothing: Annotated[float, Parameter("rad/s", "speed over which the sign is smoothed", above=0)] = 0.02

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the friction against the frame."""
        return (
            Friction(
                name=self.name,
                on=rig.node(self.at),
                coulomb_forward=self.coulomb,
                coulomb_backward=self.coulomb if self.coulomb_backward is None else self.coulomb_backward,
                static_forward=self.static,
                static_backward=self.static if self.static_backward is None else self.static_backward,
                stribeck=self.stribeck_speed,
                viscous=self.viscous,
                viscous_backward=self.viscous_backward,
                smoothing=self.smoothing,
            ),
        )
