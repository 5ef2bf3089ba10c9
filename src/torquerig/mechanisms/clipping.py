"""Clipping: the reading runs into a supply rail or the end of a range."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.clip import Clip


@dataclass(frozen=True, kw_only=True)
class Clipping(Part):
    """``V = min(max(V, -limit), limit)`` at the converter's input, noise included, or at the amplifier's output.

    The rails of an amplifier clip the signal before the cable adds a hum, which is then visible on the flat tops.
    Flat tops, odd harmonics, a mean that is too small. Source: signatures.md 6.9. Not valid for a rail that bends
    before it breaks.
    """

    kind: Literal["clipping"] = "clipping"
    group: Literal["sensor"] = "sensor"
    where: Literal["input", "amplifier"] = "input"
    limit: Annotated[float, Parameter("V", "largest reading, plus and minus", above=0)]

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the limits."""
        position = PlacedStage.INPUT if self.where == "input" else PlacedStage.AMPLIFIER
        return (PlacedStage(position=position, stage=Clip(limit=self.limit)),)
