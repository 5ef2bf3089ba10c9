"""A duty cycle: segments of constant or linearly changing speed, each with its load, repeated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.errors import InputError
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.tabulated import Tabulated


@dataclass(frozen=True, kw_only=True)
class Segment:
    """One stretch of a duty cycle.

    Parameters
    ----------
    duration : float
        [s], > 0.
    speed : float
        Of the motor at the end of the segment [rad/s].
    ramp : bool
        Whether it is reached linearly over the segment; otherwise it is constant from the start.
    load : float or None
        Mean torque against the wear part's motion [N m]; None: the rig's load applies.
    held : bool
        Whether the drive must hold the load at rest too.
    """

    duration: float
    speed: float
    ramp: bool = False
    load: float | None = None
    held: bool = False


def duty_cycle(segments: Sequence[Segment], *, repeats: int | None = None) -> Tabulated:
    """Return the profile of a duty cycle; ``repeats`` None repeats it as long as the run lasts.

    A ramp starts at the speed at which the previous segment ended. For the first segment this is the last one.

    Raises
    ------
    InputError
        When there is no segment, a duration is 0 or less, or some but not all state a load.
    """
    if not segments:
        raise InputError("a duty cycle needs at least one segment; write its duration and speed")
    stated = [one.load is not None for one in segments]
    if any(stated) and not all(stated):
        raise InputError(f"segment {stated.index(False) + 1} states no load, but others do; give every segment one")
    time, speed, load, held = [0.0], [_start(segments, 0)], [segments[0].load or 0.0], [segments[0].held]
    for number, one in enumerate(segments):
        if not one.duration > 0:
            raise InputError(f"segment {number + 1} lasts {one.duration:g} s; a segment lasts more than 0 s")
        first = (time[-1], _start(segments, number), one.load or 0.0)
        last = (first[0] + one.duration, one.speed, one.load or 0.0)
        for point in (first, last):
            if (*point, one.held) != (time[-1], speed[-1], load[-1], held[-1]):
                for kept, value in zip((time, speed, load), point, strict=True):
                    kept.append(value)
                held.append(one.held)
    rows = Breakpoints(
        time=tuple(time), speed=tuple(speed), load=tuple(load) if all(stated) else None,
        held=tuple(held) if any(held) else None,
    )  # fmt: skip
    return Tabulated(rows=rows, repeats=repeats, name="duty_cycle")


def _start(segments: Sequence[Segment], number: int) -> float:
    return segments[number - 1].speed if segments[number].ramp else segments[number].speed
