"""The unit of a column of times that states none: evidence from a stated rate, and from the numbers themselves."""

from __future__ import annotations

from dataclasses import replace

from torquerig.errors import RecordingError
from torquerig.recordings.files.timing import Timing

_SECONDS = {"milliseconds": 1e-3, "microseconds": 1e-6, "nanoseconds": 1e-9, "minutes": 60.0, "hours": 3600.0}
# the years 2001 to 2286 since 1970, in each unit; as seconds they are beyond the year 30 000
_SINCE_1970 = {"milliseconds": (1e12, 1e13), "microseconds": (1e15, 1e16), "nanoseconds": (1e18, 1e19)}
# Excel's day numbers of the years 1954 to 2119, and the rate that no logger of a torque has [Hz]
_DAY_NUMBERS, _TOO_FAST = (20_000.0, 80_000.0), 1e6
# a rate below which the order lines of a shaft are not seen [Hz], and samples from which the question is worth asking
_SLOW, _MANY = 20.0, 100
# largest difference of two rates that are the same [1]
_SAME = 1e-3


def unit_evidence(
    timing: Timing, *, first: float, samples: int, stated: float | None, name: str, where: str
) -> tuple[float, str]:
    """Return the length of the unit of times without a unit [s], and a note where it is not a second.

    A stated rate decides; else a number that is a date only in one unit. Slow times of many samples may be seconds or
    milliseconds.

    Parameters
    ----------
    timing : Timing
        Of the times as seconds.
    first : float
        The first time.
    samples : int
    stated : float or None
        A rate that is known otherwise [Hz].
    name, where : str
        Of column and file.

    Raises
    ------
    RecordingError
        Where two units are possible.
    """
    if stated is not None:
        for word, seconds in _SECONDS.items():
            if abs(timing.rate / seconds / stated - 1) <= max(_SAME, timing.uncertainty):
                note = f"the column {name} states no unit; with {stated:g} Hz stated, its numbers are {word}"
                return seconds, note
        return 1.0, ""
    for word, (low, high) in _SINCE_1970.items():
        if low <= first < high:
            return _SECONDS[word], f"the column {name} states no unit; {first:.10g} is a date only in {word} since 1970"
    if _DAY_NUMBERS[0] <= first < _DAY_NUMBERS[1] and timing.rate > _TOO_FAST:
        return 86_400.0, f"the column {name} states no unit; {first:.10g} is a day number of Excel"
    if timing.rate < _SLOW and samples >= _MANY:
        raise RecordingError(
            f"{where}: {name} states no unit: its steps of {1 / timing.rate:.6g} are {timing.rate:.6g} Hz if they are "
            f"seconds, and {1000 * timing.rate:.6g} Hz if they are milliseconds; name it time_s or time_ms, or write "
            "sample_rate_Hz into a sidecar"
        )
    return 1.0, ""


def in_unit(timing: Timing, seconds: float) -> Timing:
    """Return the sampling of times whose unit is ``seconds`` long."""
    return replace(timing, rate=timing.rate / seconds, scatter=timing.scatter * seconds)
