"""Sensor bandwidth: the amplifier's low-pass is lower than the data sheet states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import AmplifierCutoff, HostChange
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class SensorBandwidth(Part):
    """``|H(f)| = 1 / sqrt(1 + (f/fc)^4)``: the second-order Butterworth low-pass of the sensor, at ``cutoff``.

    It replaces the sensor's low-pass where it is lower; the signal passes only one low-pass. Source:
    signatures.md 6.1 (data sheets: 0.2 to 3 kHz). Not valid for a digital sensor, which updates and holds.
    """

    kind: Literal["sensor_bandwidth"] = "sensor_bandwidth"
    group: Literal["sensor"] = "sensor"
    sensor: str = "torque_sensor"
    cutoff: Annotated[float, Parameter("Hz", "true bandwidth at -3 dB", above=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the sensor carries the cutoff; InputError where ``sensor`` is none."""
        if not isinstance(rig.part(self.sensor), AmplifiedTorqueSensor):
            raise InputError(f"{self.name}: sensor: {self.sensor!r} is no torque sensor; name one")
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the cutoff of the sensor's amplifier."""
        return (AmplifierCutoff(self.cutoff),)
