"""PWM aliasing: the drive's switching frequency, aliased into the recording by its sample rate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.tone import Tone, folded

Hertz = Annotated[float, Parameter("Hz", "frequency", above=0)]


@dataclass(frozen=True, kw_only=True)
class PwmAliasing(Part):
    """``V += a cos(2 pi f t + phi)`` behind the amplifier, f fixed whatever the speed.

    State either ``frequency``, as it appears, or ``switching_frequency``, the true one: samples taken at f_s show it at
    ``|f - n f_s|`` (20, 24 and 25.28 kHz at 25 kHz: 5 kHz, 1 kHz and 280 Hz). Source: Holmes & Lipo 2003, Pulse Width
    Modulation for Power Converters; Oppenheim & Schafer (sampling). The amplitude is measured, it goes with the cable;
    what the shafts pass on follows in pwm_ripple. The side lines at multiples of the electrical
    frequency, which do move with speed, are not in here.
    """

    kind: Literal["pwm_aliasing"] = "pwm_aliasing"
    group: Literal["sensor"] = "sensor"
    frequency: Hertz | None = None
    switching_frequency: Hertz | None = None
    amplitude: Annotated[float, Parameter("V", "zero-to-peak amplitude", low=0)]
    phase: float | None = None

    def __post_init__(self) -> None:
        if (self.frequency is None) == (self.switching_frequency is None):
            raise ValueError("state one of frequency (as it appears) and switching_frequency (the true one)")

    def apparent_frequency(self, sample_rate: float) -> float:
        """Return the frequency of the line [Hz] in samples taken at ``sample_rate`` [Hz]."""
        return folded(self._true_frequency(), sample_rate)

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the tone; sampling aliases it."""
        tone = Tone(
            frequency=self._true_frequency(),
            amplitudes=(self.amplitude,),
            phases=() if self.phase is None else (self.phase,),
            source=self.name,
        )
        return (PlacedStage(position=PlacedStage.CABLE, stage=tone),)

    def _true_frequency(self) -> float:
        return self.switching_frequency or self.frequency or 0.0
