"""Noise hump: noise of a fixed band of frequencies, independent of speed; an empirical description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.band_noise import BandNoise


@dataclass(frozen=True, kw_only=True)
class NoiseHump(Part):
    """``D(f) = rms^2 / (f w sqrt(2 pi)) exp(-ln(f / f0)^2 / 2 w^2)`` of one-sided density behind the amplifier.

    A diagnosis uses it for a band of noise that no other effect of the library explains. Source: the log-normal
    density. Not valid where the noise follows the speed or the load: then it is an
    effect of the shafts.
    """

    kind: Literal["noise_hump"] = "noise_hump"
    group: Literal["sensor"] = "sensor"
    rms: Annotated[float, Parameter("V", "standard deviation of the noise", low=0)]
    frequency: Annotated[float, Parameter("Hz", "middle of the band", above=0)]
    width: Annotated[float, Parameter("1", "one sigma of the frequency's logarithm", above=0)] = 0.05

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the noise."""
        stage = BandNoise(rms=self.rms, frequency=self.frequency, width=self.width)
        return (PlacedStage(position=PlacedStage.CABLE, stage=stage),)
