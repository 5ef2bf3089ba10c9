"""Gain ripple: a gain of the reading that varies with an angle or with time; a description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.gain_ripple import GainRipple as Stage

Depth = Annotated[float, Parameter("1", "relative change of the gain at a multiple, zero to peak", low=0)]


@dataclass(frozen=True, kw_only=True)
class GainRipple(Part):
    """``T (1 + sum_h g_h cos(h (n theta + 2 pi f t) + phi_h))``, theta of the motor; n or f is 0.

    A diagnosis uses it for lines that grow in proportion to the torque as those of no other effect of the library do: a
    gain that varies with the angle, or a load that swells. Empirical; not valid where a line grows otherwise. Source:
    amplitude modulation (Oppenheim & Willsky 1997, Signals and Systems, 8.1).
    """

    kind: Literal["gain_ripple"] = "gain_ripple"
    group: Literal["sensor"] = "sensor"
    order_motor: Annotated[float, Parameter("1", "order on the motor shaft, 0 for a frequency", low=0)] = 0.0
    frequency: Annotated[float, Parameter("Hz", "frequency, 0 for an order", low=0)] = 0.0
    depths: tuple[Depth, ...]

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the varying gain, by the true angle of the motor."""
        stage = Stage(depths=self.depths, order=self.order_motor, frequency=self.frequency, source=self.name)
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=stage),)
