"""Friction of a part against the frame: of the bearings and seals of a shaft, or of the guide of a motion in a line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part
from torquerig.rig.terms import Friction

Smoothing = Annotated[
    float, Parameter("rad/s", "speed over which the signs of dry friction and losses are smoothed", above=0)
]


@dataclass(frozen=True, kw_only=True)
class BearingPart(Part):
    """A part whose output shaft runs in bearings: ``viscous w + coulomb tanh(w / smoothing)`` against the frame."""

    viscous: Annotated[
        float, Parameter("N*m*s/rad", "viscous friction of its (output) shaft against the frame", low=0)
    ] = 0.0
    coulomb: Annotated[float, Parameter("N*m", "Coulomb friction of its (output) shaft against the frame", low=0)] = 0.0
    smoothing: Smoothing = 0.02

    def friction_on(self, node: str) -> tuple[Friction, ...]:
        """Return its friction on a node; nothing where it states none."""
        return _friction(self.name, node, viscous=self.viscous, coulomb=self.coulomb, smoothing=self.smoothing)


@dataclass(frozen=True, kw_only=True)
class GuidedPart(Part):
    """A part whose far side moves in a line on a guide: ``viscous v + coulomb tanh(v / smoothing)``."""

    viscous: Annotated[float, Parameter("N*s/m", "viscous friction of what moves against the frame", low=0)] = 0.0
    coulomb: Annotated[float, Parameter("N", "Coulomb friction of what moves against the frame", low=0)] = 0.0
    smoothing: Annotated[
        float, Parameter("m/s", "speed over which the signs of dry friction and losses are smoothed", above=0)
    ] = 1e-3

    def friction_on(self, node: str) -> tuple[Friction, ...]:
        """Return its friction on a node; nothing where it states none."""
        return _friction(self.name, node, viscous=self.viscous, coulomb=self.coulomb, smoothing=self.smoothing)


def _friction(name: str, node: str, *, viscous: float, coulomb: float, smoothing: float) -> tuple[Friction, ...]:
    if not (viscous or coulomb):
        return ()
    return (
        Friction(
            name=f"{name}.bearing",
            on=node,
            viscous=viscous,
            coulomb_forward=coulomb,
            coulomb_backward=coulomb,
            static_forward=coulomb,
            static_backward=coulomb,
            smoothing=smoothing,
        ),
    )
