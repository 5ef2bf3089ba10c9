"""Sensor hysteresis: rising and falling torque read differently."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.hysteresis import Hysteresis


@dataclass(frozen=True, kw_only=True)
class SensorHysteresis(Part):
    """``T - w (T - P(T))``, P a play operator of half width ``reach``, ``w = width / (2 reach)``.

    Odd harmonics and an offset that depends on the load's history. Source: EURAMET cg-14 (0.02 to 0.3 % of full scale);
    Visintin, Differential Models of Hysteresis, for the operator. Not valid for creep, which depends on time.
    """

    kind: Literal["sensor_hysteresis"] = "sensor_hysteresis"
    group: Literal["sensor"] = "sensor"
    width: Annotated[float, Parameter("N*m", "falling minus rising reading of a large loop", low=0)]
    reach: Annotated[float, Parameter("N*m", "half the swing after which the loop is fully open", above=0)]

    def __post_init__(self) -> None:
        if self.width > 2 * self.reach:
            raise ValueError("a loop cannot be wider than twice its reach; lower width or raise reach")

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the lag."""
        lag = Hysteresis(width=self.width, reach=self.reach)
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=lag),)
