"""An encoder on the motor shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from torquerig.rig.part import Part, PlacedStage
from torquerig.rig.rig import Rig
from torquerig.signals.stages.encoder import Encoder


@dataclass(frozen=True, kw_only=True)
class MotorEncoder(Part):
    """Counts of the motor angle, written beside the torque."""

    kind: Literal["motor_encoder"] = "motor_encoder"
    counts_per_rev: int = 16384

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the counting of the angle."""
        return (PlacedStage(position=PlacedStage.FILE, stage=Encoder(counts_per_rev=self.counts_per_rev)),)
