"""Low-pass of the data logger, of any order, before its converter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.logger_low_pass import HIGHEST
from torquerig.sensor_stages.logger_low_pass import LoggerLowPass as LoggerStage


@dataclass(frozen=True, kw_only=True)
class LoggerLowPass(Part):
    """``|H(f)| = 1 / sqrt(1 + (f/fc)^(2n))`` (Butterworth), or the Bessel low-pass of order n with -3 dB at fc.

    It comes after amplifier and noise. Source: Butterworth 1930; Thomson 1949. Not true for digital filters of linear
    phase (FIR) in a logger, whose delay is constant.
    """

    kind: Literal["logger_low_pass"] = "logger_low_pass"
    group: Literal["sensor"] = "sensor"
    cutoff: Annotated[float, Parameter("Hz", "frequency of -3 dB", above=0)]
    order: int
    characteristic: Literal["butterworth", "bessel"] = "butterworth"

    def __post_init__(self) -> None:
        if not 0 <= self.order <= HIGHEST:
            raise ValueError(f"order {self.order} cannot be; write 0 (no filter) to {HIGHEST}")

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the low-pass."""
        stage = LoggerStage(cutoff=self.cutoff, order=self.order, characteristic=self.characteristic)
        return (PlacedStage(position=PlacedStage.INPUT, stage=stage),)
