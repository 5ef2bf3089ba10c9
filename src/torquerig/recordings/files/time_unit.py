"""The unit of a column of times that states none: evidence from a stated rate, and from the numbers themselves."""

from __future__ import annotations

import re
from dataclasses import replace

from torquerig.errors import RecordingError
from torquerig.recordings.files.timing import Timing

_SECONDS = {
    "milliseconds": 1e-3, "microseconds": 1e-6, "nanoseconds": 1e-9, "minutes": 60.0, "hours": 3600.0, "days": 86_400.0,
}  # fmt: skip
# the years 2001 to 2286 since 1970, in each unit; as seconds they are beyond the year 30 000
_SINCE_1970 = {"milliseconds": (1e12, 1e13), "microseconds": (1e15, 1e16), "nanoseconds": (1e18, 1e19)}
# days since 1900 (Excel) of the years 1954 to 2119, and since the year 0 (MATLAB) of 1945 to 2135
_DAY_NUMBERS = {"Excel": (20_000.0, 80_000.0), "MATLAB": (710_400.0, 779_800.0)}
# the rate that no logger of a torque has, and that of times in days read as seconds at half a sample a second [Hz]
_TOO_FAST, _FAST = 1e6, 43_200.0
# 20240305101159: a date of the years 1970 to 2099, written as one number
_WRITTEN_DATE = re.compile(
    r"(?:19[7-9]|20[0-9])[0-9](?:0[1-9]|1[0-2])(?:0[1-9]|[12][0-9]|3[01])(?:[01][0-9]|2[0-3])[0-5][0-9][0-5][0-9]"
)
_DAY = 86_400.0  # [s]
_IN_DAYS = re.compile(r"(?:[\[(/_]|\bin )\s*(?:d|days?|tagen?)[\])]?$", re.IGNORECASE)
# a rate below which the order lines of a shaft are not seen [Hz], and samples from which the question is worth asking
_SLOW, _MANY = 20.0, 100
# largest difference of two rates that are the same [1]
_SAME = 1e-3
# largest deviation of a rate from a round number: times of few digits, and a clock that is off [1]
_ROUND = 2e-4


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
    if _IN_DAYS.search(name.strip()):
        return _DAY, f"the column {name} is the time, in days"
    if stated is not None:
        for word, seconds in _SECONDS.items():
            if abs(timing.rate / seconds / stated - 1) <= max(_SAME, timing.uncertainty):
                note = f"the column {name} states no unit; with {stated:g} Hz stated, its numbers are {word}"
                return seconds, note
        return 1.0, ""
    for word, (low, high) in _SINCE_1970.items():
        if low <= first < high:
            return _SECONDS[word], f"the column {name} states no unit; {first:.10g} is a date only in {word} since 1970"
    if _WRITTEN_DATE.fullmatch(f"{first:.0f}"):
        raise RecordingError(
            f"{where}: {name} holds dates written as one number ({first:.0f}), which a number cannot hold to less than "
            "4 ms; save the times as seconds"
        )
    if timing.rate > _FAST:
        return _seconds_or_days(timing, first=first, samples=samples, name=name, where=where)
    if timing.rate < _SLOW and samples >= _MANY:
        raise RecordingError(
            f"{where}: {name} states no unit: its steps of {1 / timing.rate:.6g} are {timing.rate:.6g} Hz if they are "
            f"seconds, and {1000 * timing.rate:.6g} Hz if they are milliseconds; name it time_s or time_ms, or write "
            "sample_rate_Hz into a sidecar"
        )
    return 1.0, ""


def _seconds_or_days(timing: Timing, *, first: float, samples: int, name: str, where: str) -> tuple[float, str]:
    """Return the length of the unit of fast times without a unit [s], as :func:`unit_evidence`.

    A sample rate is usually a round number: in days where only that is one, in seconds where only this is.
    """
    program = next((one for one, (low, high) in _DAY_NUMBERS.items() if low <= first < high), "")
    is_fraction = first >= 0 and first + samples / timing.rate < 1
    if not program and not is_fraction:
        return 1.0, ""
    in_days = _is_round(timing.rate / _DAY, timing, digits=2)
    in_seconds = _is_round(timing.rate, timing, digits=3) and timing.rate < _TOO_FAST
    if program and (timing.rate > _TOO_FAST or (in_days and not in_seconds)):
        return _DAY, f"the column {name} states no unit; {first:.10g} is a day number of {program}"
    if not in_days and (in_seconds or _is_round(timing.rate, timing, digits=3)):
        return 1.0, ""
    if not in_days and timing.rate <= _TOO_FAST and not program:
        return 1.0, ""
    raise RecordingError(
        f"{where}: {name} states no unit: its times show {timing.rate:.6g} Hz if they are seconds, and "
        f"{timing.rate / _DAY:.6g} Hz if they are days; name it time_s or time_d, or "
        "write sample_rate_Hz into a sidecar"
    )


def _is_round(rate: float, timing: Timing, *, digits: int) -> bool:
    tolerance = min(max(timing.uncertainty, _ROUND), _SAME)
    return abs(float(f"{rate:.{digits}g}") / rate - 1) <= tolerance


def in_unit(timing: Timing, seconds: float) -> Timing:
    """Return the sampling of times whose unit is ``seconds`` long."""
    return replace(timing, rate=timing.rate / seconds, scatter=timing.scatter * seconds)
