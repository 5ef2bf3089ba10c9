"""Sensor non-linearity: a nonlinear characteristic and a gain error."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.characteristic import Characteristic


@dataclass(frozen=True, kw_only=True)
class SensorNonlinearity(Part):
    """``T (1 + e + n x + m x^2)``, x = T / full scale: gain error e, quadratic n, cubic m.

    e causes no line, but an error of every energy; n and m give 2f, 3f and sums of large lines: n A^2 / (2 full
    scale) at 2f of a line A. Source: signatures.md 6.5, 6.13; DIN 51309 (0.05 to 0.5 % of full scale). Not true much
    beyond full scale.
    """

    kind: Literal["sensor_nonlinearity"] = "sensor_nonlinearity"
    group: Literal["sensor"] = "sensor"
    full_scale: Annotated[float, Parameter("N*m", "nominal torque of the sensor", above=0)]
    gain_error: Annotated[float, Parameter("1", "relative error of the sensitivity", above=-1)] = 0.0
    quadratic: Annotated[float, Parameter("1", "deviation at full scale by the square, as a share")] = 0.0
    cubic: Annotated[float, Parameter("1", "deviation at full scale by the cube, as a share")] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the characteristic."""
        bent = Characteristic(
            full_scale=self.full_scale, gain_error=self.gain_error, quadratic=self.quadratic, cubic=self.cubic
        )
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=bent),)
