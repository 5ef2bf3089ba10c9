"""Jaw coupling: unequal jaws and spider legs, once per jaw and once per leg."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import HostChange, KinematicError
from torquerig.rig.parts import Coupling
from torquerig.rig.terms import Term, Wave

Radians = Annotated[float, Parameter("rad", "zero-to-peak angle error", low=0)]


@dataclass(frozen=True, kw_only=True)
class JawCoupling(Part):
    """``e(theta) = a cos(n theta + phi) + b cos(2 n theta + psi)`` in the coupling: n jaws, 2 n legs of the spider.

    Three jaws on a motor at 1000 rpm have lines at 50 and 100 Hz, which coincide with the mains.
    Source: signatures.md 3.2; Xu & Marangoni
    1994, J. Sound and Vibration 176(5). The amplitudes are measured or estimated ones; what an offset makes of equal
    jaws follows in parallel_offset. Not valid where the preload changes with the torque.
    """

    kind: Literal["jaw_coupling"] = "jaw_coupling"
    group: Literal["mechanical"] = "mechanical"
    coupling: str = "coupling"
    jaws: int
    jaw_error: Radians = 0.0
    leg_error: Radians = 0.0

    def __post_init__(self) -> None:
        if self.jaws < 1:
            raise ValueError(f"a coupling of {self.jaws} jaws is not possible; write at least 1")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the coupling carries the error; InputError where ``coupling`` is none."""
        if not isinstance(rig.part(self.coupling), Coupling):
            raise InputError(f"{self.name}: coupling: {self.coupling!r} is no coupling; name one")
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the kinematic error of the coupling."""
        lines = ((self.jaws, self.jaw_error), (2 * self.jaws, self.leg_error))
        waves = (
            Wave(order=order, amplitude=error, phase_key=f"{self.name}.{order}") for order, error in lines if error > 0
        )
        return (KinematicError(tuple(waves)),)
