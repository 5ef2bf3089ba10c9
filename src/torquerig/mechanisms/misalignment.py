"""Misalignment: two shafts that meet at an angle turn unevenly against each other, twice a turn."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, tan
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import HostChange, KinematicError
from torquerig.rig.parts import Coupling
from torquerig.rig.terms import Term, Wave


@dataclass(frozen=True, kw_only=True)
class Misalignment(Part):
    """``e(theta) = tan(b/2)^2 cos(2 theta + phi)`` in the coupling, about b^2/4: the first term of the Cardan error.

    From ``w2/w1 = cos b / (1 - sin(b)^2 cos(theta)^2)``, whose angle error is ``sum_n tan(b/2)^(2n)/n sin(2 n theta)``;
    the next term is ``tan(b/2)^2 / 2`` of the first (0.4 % at 10 degrees) and left out. The torque that follows is the
    coupling's stiffness times e, through the shafts. Source: Seherr-Thoss, Schmelz & Aucktor, Universal Joints and
    Driveshafts. Not valid for bellows and other couplings that turn evenly; a parallel offset (1x and 2x by the forces
    of the coupling) is not in here.
    """

    kind: Literal["misalignment"] = "misalignment"
    group: Literal["mechanical"] = "mechanical"
    coupling: str = "coupling"
    angle: Annotated[float, Parameter("rad", "angle between the shafts", low=0, high=pi / 4)]
    phase: float | None = None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the coupling carries the error; InputError where ``coupling`` is none."""
        if not isinstance(rig.part(self.coupling), Coupling):
            raise InputError(f"{self.name}: coupling: {self.coupling!r} is no coupling; name one")
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the kinematic error of the coupling; none where the shafts meet at no angle."""
        if self.angle == 0:
            return ()
        twice = Wave(order=2.0, amplitude=tan(0.5 * self.angle) ** 2, phase=self.phase, phase_key=self.name)
        return (KinematicError((twice,)),)
