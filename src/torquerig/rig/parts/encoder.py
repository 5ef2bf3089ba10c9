"""An encoder on the motor shaft: its channel of counts, and the measured speed of the speed loop."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import EncoderAngleError, waves_of
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.terms import Drive, ImposedMotion, Sensing, Wave
from torquerig.sensor_stages.encoder import Encoder

Angle = Annotated[float, Parameter("rad", "amplitude of the angle error, by order of the motor", low=0)]


@dataclass(frozen=True, kw_only=True)
class MotorEncoder(Part):
    """Counts of ``theta + sum of a_k cos(k theta + phi_k)``, as a further channel.

    The first encoder of a rig writes the channel ``encoder_count``, each further one ``NAME_count``.

    With ``controller`` that speed controller sees the speed by it: the difference of two samples of the counted angle,
    times the rate, through a first-order filter. Limit cycles at low speed and the torque at order k (in proportion to
    speed and gain) then come of themselves. An encoder_error on the same motor is in the counts too. A period counter
    is not in here.

    Source: the definition of an incremental encoder; signatures.md 2.5 (Hanselman 1990, IEEE Trans. Industrial
    Electronics 37).
    """

    kind: Literal["motor_encoder"] = "motor_encoder"
    counts_per_rev: int = 16384
    controller: str = ""
    speed_filter: Annotated[float, Parameter("s", "time constant of the speed filter", low=0)] = 0.0
    angle_error: Mapping[float, Angle] = field(default_factory=dict)
    phases: Mapping[float, float] = field(default_factory=dict)

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the counting of the angle."""
        waves = (*self._error(), *self._added(rig))
        error = tuple((wave.order, wave.amplitude, wave.phase or 0.0) for wave in waves)
        first = rig.parts_of(MotorEncoder)[0]
        channel = "encoder_count" if first.name == self.name else f"{self.name}_count"
        stage = Encoder(counts_per_rev=self.counts_per_rev, channel=channel, error=error)
        return (PlacedStage(position=PlacedStage.FILE, stage=stage),)

    def sensing(self) -> Sensing:
        """Return how a speed loop measures its speed with this encoder."""
        return Sensing(counts=self.counts_per_rev, error=self._error(), filter_time=self.speed_filter)

    def _added(self, rig: Rig) -> Iterator[Wave]:
        """Yield the errors that effects give to an encoder on the counted shaft: the driven one, else the imposed."""
        terms = rig.terms()
        shafts = [term.on for term in terms if isinstance(term, Drive) and self.controller in ("", term.name)]
        shafts += [term.on for term in terms if isinstance(term, ImposedMotion)]
        for waves in encoder_errors(rig, shafts[0]).values() if shafts else ():
            yield from waves

    def _error(self) -> tuple[Wave, ...]:
        return tuple(
            Wave(order=order, amplitude=amplitude, phase=self.phases.get(order, 0.0))
            for order, amplitude in self.angle_error.items()
        )


def encoder_errors(rig: Rig, shaft: str) -> dict[str, tuple[Wave, ...]]:
    """Return by the names of the effects the angle errors [rad] of an encoder on the node ``shaft``."""
    hosts = {part.name for part in rig.parts if rig.node(part.name) == shaft}
    return {part.name: waves_of(rig.changes_of(part), EncoderAngleError) for part in rig.parts if part.host in hosts}
