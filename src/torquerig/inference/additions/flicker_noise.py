"""Flicker noise: the noise of the sensor rises towards low frequencies."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.parts import ForceSensor

NAMES = ("flicker_noise",)

_LOG_ODDS = -14.0  # slow parts of the load and of the speed, which no model has exactly, look like it
_CORNER, _SPREAD = 10.0, 2.3  # [Hz] prior median: amplifiers have 1 to 100 Hz; and of its logarithm
_STARTS = ((-1.0,), (0.0,), (1.0,), (2.0,))


def propose(context: Context) -> Iterator[Addition]:
    """Yield 1/f noise of the measured sensor."""
    sensor = context.rig.part(context.rig.measured)
    if isinstance(sensor, AmplifiedTorqueSensor | ForceSensor) and sensor.noise_rms > 0:
        name = free_name(context.rig, "flicker_noise")
        yield Addition(
            mechanism="flicker_noise", knobs=(Knob(name, "corner", _SPREAD),), starts=_STARTS, log_odds=_LOG_ODDS,
            parts=(mechanisms.FlickerNoise(name=name, sensor=sensor.name, corner=_CORNER),),
            label=f"noise of {sensor.name} that rises towards low frequencies",
            reported=(Reported("corner_Hz", "corner", "Hz"),),
        )  # fmt: skip
