"""Friction of the bearings and seals of a part against the frame."""

from __future__ import annotations

from typing import Annotated

from torquerig.parameter import Parameter
from torquerig.rig.terms import Friction

Viscous = Annotated[float, Parameter("N*m*s/rad", "viscous friction of its output shaft against the frame", low=0)]
Coulomb = Annotated[float, Parameter("N*m", "Coulomb friction of its output shaft against the frame", low=0)]
Smoothing = Annotated[
    float, Parameter("rad/s", "speed over which the signs of dry friction and losses are smoothed", above=0)
]


def bearing_friction(name: str, node: str, *, viscous: float, coulomb: float, smoothing: float) -> tuple[Friction, ...]:
    """Return ``viscous w + coulomb tanh(w / smoothing)`` on a node; nothing where both are zero.

    Parameters
    ----------
    name : str
        The part.
    viscous, coulomb, smoothing : float
        [N m s/rad], [N m], [rad/s]; in a line [N s/m], [N], [m/s].
    """
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
