"""Parallel offset: two parallel shafts with an offset, whose coupling has angle errors once and twice a turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import HostChange, KinematicError
from torquerig.rig.parts import Coupling
from torquerig.rig.terms import Term, Wave

HARMONICS = 4  # the fifth is below (offset/radius)^5 / 5


@dataclass(frozen=True, kw_only=True)
class ParallelOffset(Part):
    """``e(theta) = sum_h s_h (d/R)^h / h cos(h theta + phi_h)`` in the coupling: d the offset, R the jaws' radius.

    One jaw at R drives a radial slot of a shaft at the distance d: its angle is that of ``1 + (d/R) exp(-i theta)``,
    whose series this is. With n equally loaded jaws only multiples of n remain (s_h = 1), of unequal ones also the
    rest: s_h = u / (n - 1), u by how much one jaw carries more than its n-th (of it). Two jaws: order 2 with
    (d/R)^2 / 2, the classic sign, and order 1 with u d/R. Sine and cosine of the series are drawn as one phase each.
    The torque that follows is the coupling's stiffness times e.

    Source: kinematics of the pin in a slot; signatures.md 3.2 and Xu & Marangoni 1994, J. Sound and Vibration 176(5),
    for the orders 1 and 2. Not valid for bellows and other couplings that turn evenly, nor for the side force, which
    loads bearings and reaches the reading by bending only.
    """

    kind: Literal["parallel_offset"] = "parallel_offset"
    group: Literal["mechanical"] = "mechanical"
    coupling: str = "coupling"
    offset: Annotated[float, Parameter("m", "distance between the two axes", low=0)]
    radius: Annotated[float, Parameter("m", "radius at which the jaws pull", above=0)]
    jaws: int = 2
    unequal_share: Annotated[float, Parameter("1", "what one jaw carries more than its share", low=0, high=1)] = 0.0

    def __post_init__(self) -> None:
        if self.jaws < 2:
            raise ValueError(f"a coupling of {self.jaws} jaws is not possible; write at least 2")
        if self.offset > 0.5 * self.radius:
            raise ValueError(
                f"an offset of {self.offset:g} m is more than half the radius of {self.radius:g} m; correct one of them"
            )

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the coupling carries the error; InputError where ``coupling`` is none."""
        if not isinstance(rig.part(self.coupling), Coupling):
            raise InputError(f"{self.name}: coupling: {self.coupling!r} is no coupling; name one")
        return ()

    def amplitudes(self) -> dict[int, float]:
        """Return the angle error [rad] by order of the shaft, those above zero."""
        slim = self.offset / self.radius
        rest = self.unequal_share / (self.jaws - 1)
        lines = {h: (1.0 if h % self.jaws == 0 else rest) * slim**h / h for h in range(1, HARMONICS + 1)}
        return {order: error for order, error in lines.items() if error > 0}

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the kinematic error of the coupling."""
        waves = (
            Wave(order=order, amplitude=error, phase_key=f"{self.name}.{order}")
            for order, error in self.amplitudes().items()
        )
        return (KinematicError(tuple(waves)),)
