"""Blade pass: one load pulse per blade."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import BladeTorque, Term


@dataclass(frozen=True, kw_only=True)
class BladePass(Part):
    """``load torque += A max(0, cos(b theta + phi))^2``, opposing the motion of the shaft of ``at``.

    Real load, not noise: a filter that removes this line removes data. Mean A/4, first harmonic 4 A/(3 pi) (half-wave
    squared cosine). A is a measured peak: it goes with bed and blade. Source: signatures.md 5.3. Not true
    for unequal blades. ``one_way`` pulses push against forward motion whichever way the shaft turns, as those of a pump
    that works against a pressure do.
    """

    kind: Literal["blade_pass"] = "blade_pass"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    order_output: Annotated[float, Parameter("1", "blades per turn", above=0)]
    amplitude: Annotated[float, Parameter("N*m", "peak of the pulse", low=0)]
    phase: float | None = None
    one_way: bool = False

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the pulses."""
        node = rig.node(self.at)
        return (
            BladeTorque(
                name=self.name,
                on=node,
                order=self.order_output,
                amplitude=self.amplitude,
                phase=self.phase,
                one_way=self.one_way,
            ),
        )
