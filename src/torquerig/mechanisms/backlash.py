"""Backlash: a gap in the spring of a gear, or of a link between two things that move in a line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import ExtraGap, HostChange
from torquerig.rig.parts import Link
from torquerig.rig.parts.gear_stage import gear_stage
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class Backlash(Part):
    """``T = k (twist - middle - g/2)`` beyond the gap and zero inside, damping only in contact, never pulling.

    Source: Nordin & Gutman 2002, Automatica 38 (physical dead-zone model); contact law: terms.Spring.
    In a line ``gear`` names a link and the gap is in m. Rattle and limit cycles result from the simulation.
    Not valid where the deformation of the tooth flanks matters.
    """

    kind: Literal["backlash"] = "backlash"
    gear: str = "gearbox"
    gap: Annotated[float, Parameter("rad", "full gap at the output", low=0)]
    middle: Annotated[float, Parameter("rad", "input angle / ratio less output angle in the middle of the gap")] = 0.0

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the gear or link carries the gap; InputError where ``gear`` is neither."""
        if not isinstance(rig.part(self.gear), Link):
            gear_stage(rig, self.gear, owner=self.name)
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the gap."""
        return (ExtraGap(self.gap, self.middle),)
