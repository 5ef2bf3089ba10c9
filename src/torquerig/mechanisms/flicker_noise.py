"""Flicker noise: the sensor's noise rises towards low frequencies, below a corner."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import ForceSensor
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.flicker import FlickerNoise as FlickerStage


@dataclass(frozen=True, kw_only=True)
class FlickerNoise(Part):
    """``D(f) = D0 (corner / f)^exponent`` added to the white noise D0 of ``sensor`` (its ``noise_rms``).

    Source: Horowitz & Hill, The Art of Electronics, 3rd ed., section 8.1.3. Not true down to 0 Hz: it ends at half the
    inverse of the recording's length; a slow zero is a ``sensor_drift``.
    """

    kind: Literal["flicker_noise"] = "flicker_noise"
    group: Literal["sensor"] = "sensor"
    sensor: str = "torque_sensor"
    corner: Annotated[float, Parameter("Hz", "below it the density exceeds the white one", low=0)]
    exponent: Annotated[float, Parameter("1", "1 is pink, 2 a random walk", above=0, high=3)] = 1.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the noise; InputError where ``sensor`` has none."""
        sensor = rig.part(self.sensor)
        if not isinstance(sensor, AmplifiedTorqueSensor | ForceSensor):
            raise InputError(f"{self.name}: sensor: {self.sensor!r} has no noise of its own; name a torque or force "
                             "sensor")  # fmt: skip
        stage = FlickerStage(rms=sensor.noise_rms, corner=self.corner, exponent=self.exponent)
        return (PlacedStage(position=PlacedStage.NOISE, stage=stage),)
