"""Quantization: codes coarser than the converter's data sheet states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.rounding import Rounding


@dataclass(frozen=True, kw_only=True)
class Quantization(Part):
    """``V = step round(V / step)``, after the converter: a wrong range, a digital sensor, a file with few digits.

    Source: Widrow & Kollar, Quantization Noise: a floor of step / sqrt(12) rms where the signal crosses many codes.
    Not valid for codes of unequal width.
    """

    kind: Literal["quantization"] = "quantization"
    group: Literal["sensor"] = "sensor"
    step: Annotated[float, Parameter("V", "distance of two codes", low=0)]

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the coarser codes."""
        return (PlacedStage(position=PlacedStage.FILE, stage=Rounding(step=self.step)),)
