"""A nameless torque that follows the speed: from a kink on, or in a window of speeds, whatever the cause.

A law of the library that fits the same mean torques has fewer open numbers and better prior odds. One that fits them
less well must not take the name.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import log

import numpy as np

from torquerig import mechanisms
from torquerig.inference.addition import Addition, free_name
from torquerig.inference.context import Context
from torquerig.inference.knobs import Knob
from torquerig.inference.mean_torques import MeanTorques
from torquerig.sensor_stages.speed_course import SpeedCourse, SpeedShape

_LOG_ODDS = -3.0  # of a torque over the speed, whatever its shape; as of a course over time
_PLACES = 24  # speeds that are compared: a window of 7 % is then hit within its width in a run-up
_MIDDLE, _SPREAD = 0.5, 0.5  # [1] of the largest speed, and of the logarithm: prior of the speed of kink or window
_SIZE = 1.0  # of the signal's standard deviation: standard deviation of the size
_SHAPES: tuple[SpeedShape, ...] = ("kink", "window")
_BEST = 3  # speeds of each shape from which a fit may begin
_SLOWEST, _FASTEST = 0.15, 0.95  # [1] of the largest speed: between these there is a course with two sides
_MOST = 3.0  # [standard deviations] at which a fit begins at most


def propose(context: Context) -> Iterator[Addition]:
    """Yield a kink and a window, each from the speeds at which it explains most of the mean torques of swept runs.

    A run at one speed has one mean torque, which a zero or a scale of the run explains as well.
    """
    torques = MeanTorques.of(context)
    swept = np.abs(torques.speed[torques.swept])
    if not swept.size or not swept.max() > 0:
        return
    fastest = float(swept.max())
    places = np.linspace(max(float(swept.min()), _SLOWEST * fastest), _FASTEST * fastest, _PLACES).tolist()
    for shape in _SHAPES:
        courses = [SpeedCourse(shape=shape, at=at, size=1.0).torque(torques.speed).mean(axis=1) for at in places]
        gains, sizes = torques.explained(np.stack(courses, axis=1))
        best = sorted(zip(gains.tolist(), sizes.tolist(), places, strict=True), reverse=True)[:_BEST]
        if best[0][0] > 0:
            yield _addition(context, shape, fastest, [(size, at) for _, size, at in best])


def _addition(context: Context, shape: SpeedShape, fastest: float, found: list[tuple[float, float]]) -> Addition:
    """Return a course with the sizes [N m] and speeds of the motor [rad/s] from which its fit may begin."""
    name, unit, middle = free_name(context.rig, "unnamed_course"), _SIZE * context.signal, _MIDDLE * fastest
    last = context.shafts[-1]
    what = "that grows with the speed above" if shape == "kink" else "at speeds near"
    return Addition(
        kind="level_course", variant=shape, log_odds=_LOG_ODDS - log(len(_SHAPES)),
        parts=(mechanisms.SpeedCourse(name=name, shape=shape, at=middle),),
        knobs=(Knob(name, "size", unit, factor=False), Knob(name, "at", _SPREAD)),
        starts=tuple((float(np.clip(size / unit, -_MOST, _MOST)), log(at / middle) / _SPREAD) for size, at in found),
        label=f"a torque {what} {abs(found[0][1] * last.turns) * 30 / np.pi:.4g} rpm of {last.part}",
    )  # fmt: skip
