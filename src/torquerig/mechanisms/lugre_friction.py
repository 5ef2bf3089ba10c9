"""LuGre friction: bristles that bend before they slide; stick, breakaway and hysteresis result from the model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import BristleFriction, Term

Torque = Annotated[float, Parameter("N*m", "friction torque", low=0)]


@dataclass(frozen=True, kw_only=True)
class LugreFriction(Part):
    """``z' = w - s0 |w| z / g(w)``; ``T = s0 z + s1 z' + viscous w``; ``g = Tc + (Ts - Tc) exp(-(w/ws)^2)``.

    A variant of stribeck_friction: the same curve at steady speed, but it sticks. Backward values default to the
    forward ones.

    Source: Canudas de Wit, Olsson, Astrom & Lischinsky 1995, IEEE Trans. Automatic Control 40(3), eq. 1-4. Not true for
    loads that swing below breakaway for long: LuGre drifts there (Dupont et al. 2002, IEEE TAC 47(5)).
    """

    kind: Literal["lugre_friction"] = "lugre_friction"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    coulomb: Torque
    static: Torque
    stribeck_speed: Annotated[float, Parameter("rad/s", "Stribeck speed", above=0)]
    stiffness: Annotated[float, Parameter("N*m/rad", "stiffness of the bristles (s0)", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "damping of the bristles (s1)", low=0)]
    viscous: Annotated[float, Parameter("N*m*s/rad", "viscous friction", low=0)] = 0.0
    coulomb_backward: Torque | None = None
    static_backward: Torque | None = None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the friction against the frame; none of zero size."""
        backward = self.coulomb if self.coulomb_backward is None else self.coulomb_backward
        static_backward = self.static if self.static_backward is None else self.static_backward
        if not any((self.coulomb, self.static, backward, static_backward, self.viscous)):
            return ()
        return (
            BristleFriction(
                name=self.name,
                on=rig.node(self.at),
                stiffness=self.stiffness,
                damping=self.damping,
                coulomb_forward=self.coulomb,
                coulomb_backward=backward,
                static_forward=self.static,
                static_backward=static_backward,
                stribeck=self.stribeck_speed,
                viscous=self.viscous,
            ),
        )
