"""Torque ripple in proportion to the motor torque: commutation, back-EMF harmonics, unequal current gains."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, HostChange
from torquerig.rig.parts import Motor
from torquerig.rig.terms import Term, Wave


@dataclass(frozen=True, kw_only=True)
class CommutationRipple(Part):
    """``T = T_motor (1 + d cos(k theta + phi) + sum_h d_h cos(h k theta + phi_h))``: lines that grow with the load.

    ``harmonics`` are d_2, d_3, ...: a dip at each commutation is no cosine.
    k = 6p for six-step commutation, dead time and the pair of 5th and 7th back-EMF harmonics (Jahns & Soong 1996,
    IEEE Trans. Industrial Electronics 43(2)); k = 2p for unequal current gains (Chung & Sul 1998, IEEE Trans. Industry
    Applications 34(5)). The depth is a measured value; from the machine itself it follows in six_step_commutation,
    dead_time, back_emf_harmonics and current_gain. Not valid where the current loop reacts to the line.
    """

    kind: Literal["commutation_ripple"] = "commutation_ripple"
    at: str = "motor"
    group: Literal["electrical"] = "electrical"
    order_motor: Annotated[float, Parameter("1", "order on the motor shaft", above=0)]
    depth: Annotated[float, Parameter("1", "share of the motor torque, zero to peak", low=0)]
    phase: float | None = None
    harmonics: tuple[Annotated[float, Parameter("1", "share at a multiple of the order", low=0)], ...] = ()

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive carries the ripple; InputError where ``at`` is no motor."""
        if not isinstance(rig.part(self.at), Motor):
            raise InputError(f"{self.name}: at: {self.at!r} is no motor; name one")
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the ripple of the motor's torque."""
        first = Wave(order=self.order_motor, amplitude=self.depth, phase=self.phase, phase_key=self.name)
        others = [
            Wave(order=multiple * self.order_motor, amplitude=depth, phase_key=f"{self.name}.{multiple}")
            for multiple, depth in enumerate(self.harmonics, start=2)
        ]
        return (DriveRipple(tuple(wave for wave in (first, *others) if wave.amplitude > 0)),)
