"""Jumps of a measured angle: no shaft turns further from one sample to the next than the samples around let it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.recordings.channel_angle import unsmoothed_angle_of
from torquerig.recordings.recording import Recording

_QUANTITIES = ("motor_angle", "angle")
_USUAL = 0.99  # quantile of the steps that a run's largest speed is taken from
_FURTHER = 8.0  # times so far in one sample no inertia goes
_COUNTS = 4.0  # and further than an encoder's line may be misplaced
_BESIDE = 10  # samples before and after, which must turn as usual and stay where the jump put them


@dataclass(frozen=True)
class AngleJump:
    """Between samples ``start`` and the next the channel steps by ``turn`` [rad] more than around."""

    channel: str
    start: int
    turn: float


def angle_jumps(recording: Recording) -> tuple[AngleJump, ...]:
    """Return where the recorded angle jumps and stays there: samples or counts that were lost or written twice.

    The largest speed is that of the steps of the whole run, so an angle that hardly moves shows none.
    """
    name = next((own for each in _QUANTITIES if (own := recording.find(each)) is not None), None)
    if name is None or recording.samples < 4 * _BESIDE:
        return ()
    channel = recording.channels[name]
    angle = unsmoothed_angle_of(channel)
    steps = np.diff(angle)
    quantum = channel.si_per_unit if channel.unit == "count" else 0.0
    usual = float(np.quantile(np.abs(steps), _USUAL))
    limit = _FURTHER * usual + _COUNTS * quantum
    found: list[AngleJump] = []
    for at in np.flatnonzero(np.abs(steps) > limit) if usual > 0 else ():
        before, after = int(at) - _BESIDE, int(at) + 1 + _BESIDE
        if before < 0 or after >= angle.size:
            continue
        beside = np.delete(steps[before:after], _BESIDE)
        jump = float(angle[after] - angle[before]) - (after - before) * float(np.median(beside))
        if np.abs(beside).max() <= limit and abs(jump) > limit:
            found.append(AngleJump(name, int(at), jump))
    return tuple(found)
