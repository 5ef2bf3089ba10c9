"""Sensor bandwidth: the low-pass of the amplifier is lower than stated."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor

NAMES = ("sensor_bandwidth",)

_LOG_ODDS = -3.0
_MEDIAN, _SPREAD = 0.3, 0.8  # of the stated bandwidth, and of the logarithm
_STARTS = ((-1.5,), (-0.5,), (0.4,), (1.0,))


def propose(context: Context) -> Iterator[Addition]:
    """Yield a lower cutoff of the measured sensor."""
    sensor = context.rig.part(context.rig.measured)
    if isinstance(sensor, AmplifiedTorqueSensor):
        name = free_name(context.rig, "sensor_bandwidth")
        yield Addition(
            mechanism="sensor_bandwidth", knobs=(Knob(name, "cutoff", _SPREAD),), starts=_STARTS,
            parts=(mechanisms.SensorBandwidth(name=name, sensor=sensor.name, cutoff=_MEDIAN * sensor.bandwidth),),
            log_odds=_LOG_ODDS, label="a lower cutoff of the sensor",
            reported=(Reported("cutoff_Hz", "cutoff", "Hz"),),
        )  # fmt: skip
