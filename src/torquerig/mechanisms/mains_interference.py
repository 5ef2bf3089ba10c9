"""Mains interference: hum of the supply on the sensor's cable, at a fixed frequency."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.tone import Tone

Volts = Annotated[float, Parameter("V", "zero-to-peak amplitude of a harmonic", low=0)]


@dataclass(frozen=True, kw_only=True)
class MainsInterference(Part):
    """``V += sum_h a_h cos(2 pi h f t + phi_h)`` behind the amplifier; no part of it turns with the machine.

    The amplitudes are measured. Harmonic 1 of 50 Hz is a ground loop, 2 a single-phase rectifier, 6 a three-phase
    one. Source: Morrison, Grounding and Shielding. Not valid where the current loop runs out of volts and the hum
    becomes a real torque.
    """

    kind: Literal["mains_interference"] = "mains_interference"
    group: Literal["sensor"] = "sensor"
    frequency: Annotated[float, Parameter("Hz", "mains frequency", above=0)] = 50.0
    amplitudes: tuple[Volts, ...]
    phases: tuple[float, ...] = ()

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the hum."""
        tone = Tone(frequency=self.frequency, amplitudes=self.amplitudes, phases=self.phases, source=self.name)
        return (PlacedStage(position=PlacedStage.CABLE, stage=tone),)
