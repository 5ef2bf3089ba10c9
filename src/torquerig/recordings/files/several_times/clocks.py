"""Several columns of times of one file: their rates, and which of them are the same."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.gaps import gaps_in
from torquerig.recordings.files.table_pieces import Columns, TablePieces
from torquerig.recordings.files.time_unit import in_unit, unit_evidence
from torquerig.recordings.files.timing import Timing, timing_of
from torquerig.recordings.names.time_column import TimeColumn

# share of the steps that rise in times whose clock jumps at most now and then [1]
_RISING = 0.9
# times that differ by less than this are the same [samples]; one lost sample makes half a sample or more
_SAME = 0.25
# largest relative difference of two rates that are one (a rounded time column) [1]
_SAME_RATE = 1e-3


@dataclass(frozen=True, kw_only=True)
class Clock:
    """One column of times.

    Parameters
    ----------
    name : str
    seconds : float
        Length of its unit [s].
    start : float
        Its first time [s].
    samples : int
        Up to the last time; blank cells below it do not count.
    grain : float
        The largest step of times that are repeated, of a clock that is read more often than it counts [s]; else 0.
    timing : Timing
        As its first piece shows it, in seconds; ``problem`` is about the whole column.
    """

    name: str
    seconds: float
    start: float
    samples: int
    grain: float
    timing: Timing

    def has_rate_of(self, other: Clock) -> bool:
        """Return whether the rates are the same within 0.1 %, or as exactly as the times are stamped."""
        allowed = max(_SAME_RATE, self.timing.uncertainty, other.timing.uncertainty)
        return abs(self.timing.rate / other.timing.rate - 1) <= allowed


@dataclass
class _Reading:
    """What is known of a column of times while its pieces are read."""

    column: TimeColumn
    seconds: float
    start: float
    timing: Timing
    grain: float = 0.0
    read: int = 0
    samples: int = 0
    last: float | None = None
    problem: str = ""
    leader: str = ""
    low: float = field(default=np.inf)
    high: float = field(default=-np.inf)


def is_rising(times: NDArray[np.float64]) -> bool:
    """Return whether numbers are times: they rise, but for a few places at which a clock was set."""
    steps = np.diff(_whole(times))
    return bool(steps.size and np.mean(steps >= 0) > _RISING and np.mean(steps) > 0)


def clocks_of(table: TablePieces, columns: Sequence[TimeColumn], head: Columns) -> tuple[list[Clock], dict[str, str]]:
    """Return the columns of times, and for each the first one that has the same times.

    Parameters
    ----------
    table : TablePieces
        Names as written in the file.
    columns : sequence of TimeColumn
        Two or more.
    head : mapping of str to ndarray
        Their first piece.
    """
    readings = {one.name: _first(one, head[one.name]) for one in columns}
    _lead(readings, head)
    for piece in table.pieces(list(readings)):
        for name, values in piece.items():
            leader = readings[readings[name].leader]
            _add(readings[name], values, piece[leader.column.name], leader)
    clocks = [_clock(one) for one in readings.values()]
    leaders = {name: one.leader if _stays_same(one, readings[one.leader]) else name for name, one in readings.items()}
    return clocks, leaders


def _stays_same(one: _Reading, leader: _Reading) -> bool:
    span = 0.0 if leader.last is None else leader.last - leader.start
    return one.samples == leader.samples and _is_same(one, leader, span=span)


def _first(column: TimeColumn, times: NDArray[np.float64]) -> _Reading:
    times = _whole(times) * column.seconds
    if times.size < 2 or not np.isfinite(np.diff(times)).all():
        problem = "has fewer than 2 times" if times.size < 2 else "has times that are no finite numbers"
        nothing = Timing(rate=float("nan"), problem=problem)
        return _Reading(column=column, seconds=column.seconds, start=0.0, timing=nothing, problem=nothing.problem)
    timing, steps = timing_of(times, name=column.name), np.diff(times)
    seconds, problem = 1.0, timing.problem
    if not column.stated and timing.rate > 0:
        try:
            seconds, _ = unit_evidence(
                timing, first=float(times[0]), samples=times.size, stated=None, name=column.name, where=""
            )
        except RecordingError as error:
            problem = str(error).removeprefix(": ").removeprefix(f"{column.name} ")
    return _Reading(
        column=column, seconds=column.seconds * seconds, start=float(times[0]) * seconds,
        timing=in_unit(timing, seconds), problem=problem,
        grain=0.0 if steps.all() else seconds * float(np.nanmax(steps)),
    )  # fmt: skip


def _lead(readings: Mapping[str, _Reading], head: Columns) -> None:
    """Set for each column of times the first one that is the same in the first piece."""
    leaders: list[str] = []
    # two times that differ by less than the grain of a coarse one need not be the same
    for name, one in sorted(readings.items(), key=lambda item: item[1].grain):
        for other in leaders:
            first, others = _whole(head[name]), _whole(head[other])
            _compare(one, first, others, readings[other])
            span = float(others[-1] - others[0]) * readings[other].seconds if others.size else 0.0
            if first.size == others.size and _is_same(one, readings[other], span=span):
                one.leader = other
                break
            one.low, one.high = np.inf, -np.inf
        else:
            one.leader = name
            leaders.append(name)


def _compare(one: _Reading, times: NDArray[np.float64], others: NDArray[np.float64], leader: _Reading) -> None:
    count = min(times.size, others.size)
    apart = times[:count] * one.seconds - others[:count] * leader.seconds
    apart = apart[np.isfinite(apart)]
    if apart.size:
        one.low, one.high = min(one.low, float(apart.min())), max(one.high, float(apart.max()))


def _is_same(one: _Reading, leader: _Reading, *, span: float) -> bool:
    """Return whether two columns hold the same times, or the same moments counted from another zero.

    The rows of a table do not come from times of which one begins after the other, which is ``span`` [s] long, ends.
    """
    if one is leader:
        return True
    allowed = _SAME / leader.timing.rate + max(one.timing.scatter, one.grain) + max(leader.timing.scatter, leader.grain)
    size = max(abs(one.low), abs(one.high))
    return one.high - one.low <= allowed and (size <= allowed or size > span > 0)


def _add(one: _Reading, values: NDArray[np.float64], others: NDArray[np.float64], leader: _Reading) -> None:
    times = _whole(values) * one.seconds
    if one is not leader:
        _compare(one, values, others, leader)
    if times.size and not one.problem and one.timing.rate > 0:
        if one.samples < one.read:
            one.problem = f"has no times before sample {one.read}"
        gaps = gaps_in(times, one.timing.rate, first=one.read, before=one.last, scatter=one.timing.scatter)
        if gaps:
            one.problem = f"jumps by {gaps[0].step:.6g} s after sample {gaps[0].sample}"
    one.samples = one.read + times.size if times.size else one.samples
    one.last = float(times[-1]) if times.size else one.last
    one.read += values.size


def _clock(one: _Reading) -> Clock:
    timing = Timing(
        rate=one.timing.rate, uncertainty=one.timing.uncertainty, scatter=one.timing.scatter, note=one.timing.note,
        problem=one.problem,
    )  # fmt: skip
    return Clock(name=one.column.name, seconds=one.seconds, start=one.start, samples=one.samples, grain=one.grain,
                 timing=timing)  # fmt: skip


def _whole(times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the times without the blank cells at their end."""
    filled = np.flatnonzero(np.isfinite(times))
    return times[: filled[-1] + 1 if filled.size else 0]
