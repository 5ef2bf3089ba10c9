"""PWM aliasing: the switching of a drive, folded by the sampling to a fixed frequency above what shafts pass on."""

from __future__ import annotations

from collections.abc import Iterator
from math import log

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import Addition, Reported, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.linear_twin.twin import Twin

NAMES = ("pwm_aliasing",)

_LOG_ODDS = -8.0  # within one step of the search, where a tone of any cause has as many steps per hertz
_PASSED = 0.1  # [1] of a torque: where any shaft passes more to the reading, a tone may be a torque


def propose(context: Context) -> Iterator[Addition]:
    """Yield a tone for each found frequency that no shaft passes on.

    A folded frequency is as likely in each hertz up to half the sample rate, one of another cause in each octave: the
    odds are those of the two densities.
    """
    rig, name = context.rig, free_name(context.rig, "pwm_aliasing")
    highest = 0.5 * min(seen.run.rate for seen in context.data.seen)
    tones = [line.place for line in context.lines if line.place.domain == "frequency"]
    passed = _passed(context, np.array([place.at for place in tones]))
    for place, gain in zip(tones, passed.tolist(), strict=True):
        if gain < _PASSED and not rig.of_kind("pwm_aliasing"):  # a drive has one switching frequency

            def switching(volts: float, at: float = place.at) -> mechanisms.PwmAliasing:
                return mechanisms.PwmAliasing(name=name, frequency=at, amplitude=volts)

            yield from one_size(
                context, switching, field="amplitude", place=place, mechanism="pwm_aliasing",
                log_odds=_LOG_ODDS + log(log(highest) * min(place.at / highest, 1.0)),
                label=f"switching of the drive, folded to {place.at:.5g} Hz, where {rig.measured} reads no torque",
                fixed={"frequency_Hz": (place.at, context.resolution, "Hz")},
                reported=(Reported("amplitude_V", "amplitude", "V"),),
            )  # fmt: skip


def _passed(
    context: Context, frequency: np.ndarray[tuple[int], np.dtype[np.float64]]
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return the largest share of a torque on any driven or loaded shaft that reaches the reading [1]."""
    twin = Twin(context.rig)
    acted = sorted(twin.turns.keys() & {getattr(term, "on", None) for term in twin.terms})
    if not frequency.size or not acted:
        return np.zeros(frequency.size)
    return np.asarray(np.max([np.abs(twin.torque_on(node)(frequency)) for node in acted], axis=0))
