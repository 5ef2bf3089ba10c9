"""The channels of a MATLAB file: vectors and columns of matrices, with names, units, rates and times."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.matlab.leaves import Leaf
from torquerig.recordings.files.matlab.stated_rate import rate_of, states_rate
from torquerig.recordings.files.matlab.tree import Numbers, Unread
from torquerig.recordings.files.number_table import distinct
from torquerig.recordings.files.starts import late_starts
from torquerig.recordings.files.table_pieces import PIECE
from torquerig.recordings.files.timebase import rate_of_times
from torquerig.recordings.names.time_column import time_column


@dataclass(frozen=True, kw_only=True)
class Channel:
    """One column of the table: an array of the file and the number of its column."""

    numbers: Numbers
    column: int

    def read(self, first: int, last: int) -> NDArray[np.float64]:
        """Return the samples ``[first, last)``, shape (samples,)."""
        return np.ascontiguousarray(self.numbers.read(first, last)[:, self.column])


@dataclass(frozen=True, kw_only=True)
class Channels:
    """What a table needs: the channels by name, rates [Hz], units, starts [s], and what is not read."""

    channels: Mapping[str, Channel]
    rates: Mapping[str, float]
    units: Mapping[str, str]
    skipped: Mapping[str, str]
    notes: tuple[str, ...] = ()
    starts: Mapping[str, float] = field(default_factory=dict)


@dataclass
class _Found:
    skipped: dict[str, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)


def channels_of(leaves: Sequence[Leaf], *, where: str, remedy: str) -> Channels:
    """Return the channels among the arrays of a file.

    A name is the field's, or the label's, as long as only one has it; else as much of the path as tells them apart
    (``torque.data``). The columns of a matrix that is as long as the channels become ``name_1`` to ``name_n``.

    Raises
    ------
    RecordingError
        Where there is no vector of numbers; with ``remedy``, how to save the channels.
    """
    found = _Found()
    signals = _signals(leaves, found)
    if not signals:
        listed = "; ".join(f"{name}: {reason}" for name, reason in list(found.skipped.items())[:6]) or "nothing"
        raise RecordingError(
            f"{where}: there is no vector of two or more numbers among its variables ({listed}); {remedy}"
        )
    bare = _bare(signals)
    if bare:
        notes = (f"{signals[0].path[-1]}: a matrix of two columns is read as time [s] and torque [V]",)
        rates = _stated_rates(leaves, bare, where)
        return Channels(channels=bare, rates=rates, units={}, skipped=found.skipped, notes=notes)
    return _named(leaves, signals, found, where)


def _signals(leaves: Sequence[Leaf], found: _Found) -> list[Leaf]:
    """Return the leaves that are channels, and note the others with the reason."""
    arrays = [leaf for leaf in leaves if isinstance(leaf.node, Numbers) and leaf.node.size > 1]
    vectors = {leaf.node.samples for leaf in arrays if isinstance(leaf.node, Numbers) and leaf.node.width == 1}
    longest = max((leaf.node.samples for leaf in arrays if isinstance(leaf.node, Numbers)), default=0)
    lengths = vectors or {longest}
    signals = []
    for leaf in leaves:
        name, node = ".".join(leaf.path), leaf.node
        if isinstance(node, Unread):
            found.skipped[name] = node.reason
        elif isinstance(node, str):
            if not states_rate(leaf.path[-1]):
                found.skipped[name] = "a text"
        elif node.size < 2:
            if not states_rate(leaf.path[-1]):
                found.skipped[name] = "a single number" if node.size else "empty"
        elif node.width > 1 and len([size for size in node.shape if size > 1]) > 2:
            found.skipped[name] = f"an array of {len(node.shape)} dimensions"
        elif node.width > 1 and node.samples not in lengths:
            found.skipped[name] = f"a matrix of {node.shape[0]} x {node.shape[1]}, and no channel is as long"
        else:
            signals.append(leaf)
    return signals


@np.errstate(all="ignore")
def _bare(signals: Sequence[Leaf]) -> dict[str, Channel]:
    """Return time and volts where the file is one matrix of two columns, of which the first rises."""
    node = signals[0].node
    if len(signals) != 1 or not isinstance(node, Numbers) or node.width != 2:
        return {}
    if np.any(np.diff(node.read(0, PIECE)[:, 0]) <= 0):
        return {}
    return {name: Channel(numbers=node, column=column) for column, name in enumerate(("time_s", "torque_V"))}


def _named(leaves: Sequence[Leaf], signals: Sequence[Leaf], found: _Found, where: str) -> Channels:
    signals = _one_time(signals, found)
    times = {leaf.scope: leaf for leaf in reversed(signals) if leaf.is_time}
    several = len(times) > 1
    scalars = _scalar_rates(leaves, where)
    names = short_names([leaf.path for leaf in signals])
    channels: dict[str, Channel] = {}
    rates: dict[str, float] = {}
    units: dict[str, str] = {}
    starts: dict[str, float] = {}
    for name, leaf in zip(names, signals, strict=True):
        node = leaf.node
        if not isinstance(node, Numbers) or (several and leaf.is_time):
            continue
        rate = leaf.rate or scalars.get(leaf.scope, scalars.get(()))
        own = times.get(leaf.scope) or times.get(())
        if several and own is not None and rate is None:
            rate = _rate_by(own, where)
            if rate is None:
                found.skipped[name] = f"its times {'.'.join(own.path)} are not even; save it to its own file"
                continue
        columns = _column_names(name, node.width, leaf.columns, taken=channels)
        for column, one in enumerate(columns):
            channels[one] = Channel(numbers=node, column=column)
            rates |= {one: rate} if rate else {}
            starts |= {one: _seconds(own, 1)[0]} if several and own is not None else {}
            units |= {one: leaf.unit} if leaf.unit else {}
        if leaf.note:
            found.notes.append(f"{name}: {leaf.note}")
        if node.is_logical:
            found.notes.append(f"{name}: true and false are read as 1 and 0")
        if node.width > 1:
            found.notes.append(f"{name}: a matrix of {node.width} columns is read as {columns[0]} to {columns[-1]}")
    notes = (*found.notes, *late_starts(starts, rates))
    return Channels(channels=channels, rates=rates, units=units, skipped=found.skipped, notes=notes, starts=starts)


def _column_names(name: str, width: int, given: tuple[str, ...], *, taken: Iterable[str]) -> list[str]:
    if width == 1:
        return [name]
    if len(set(given)) == width and not set(given) & set(taken):
        return list(given)
    return [f"{name}_{column + 1}" for column in range(width)]


def _one_time(signals: Sequence[Leaf], found: _Found) -> list[Leaf]:
    """Return the signals with one time where all structs have the same times, under the plain name of the first."""
    times = [leaf for leaf in signals if leaf.is_time]
    if len(times) < 2 or not all(_same(times[0], other) for other in times[1:]):
        return list(signals)
    first = Leaf(path=times[0].path[-1:], node=times[0].node, unit=times[0].unit, is_time=True)
    found.notes.append(f"{len(times)} structs have the same times, which are read once as {first.path[-1]}")
    return [first, *(leaf for leaf in signals if not leaf.is_time)]


def _same(one: Leaf, other: Leaf) -> bool:
    if not isinstance(one.node, Numbers) or not isinstance(other.node, Numbers) or one.node.size != other.node.size:
        return False
    return all(
        np.array_equal(one.node.read(first, first + PIECE), other.node.read(first, first + PIECE), equal_nan=True)
        for first in range(0, one.node.samples, PIECE)
    )


def _rate_by(time: Leaf, where: str) -> float | None:
    times = _seconds(time, time.node.samples if isinstance(time.node, Numbers) else 0)
    try:
        return rate_of_times(times, name=".".join(time.path), where=where) if times.size > 1 else None
    except RecordingError:
        return None


@np.errstate(all="ignore")
def _seconds(time: Leaf, count: int) -> NDArray[np.float64]:
    """Return the first ``count`` times of a leaf [s]."""
    if not isinstance(time.node, Numbers):
        return np.empty(0)
    column = time_column([time.path[-1]], {time.path[-1]: time.unit})
    seconds: NDArray[np.float64] = time.node.read(0, count)[:, 0] * (column.seconds if column else 1.0)
    return seconds


def _scalar_rates(leaves: Iterable[Leaf], where: str) -> dict[tuple[str, ...], float]:
    """Return the rate that scalars and texts such as ``fs`` state, by the struct that they are in [Hz]."""
    stated: dict[tuple[str, ...], dict[str, object]] = {}
    for leaf in leaves:
        value = leaf.node.scalar() if isinstance(leaf.node, Numbers) else leaf.node
        if isinstance(value, str | float):
            stated.setdefault(leaf.scope, {})[leaf.path[-1]] = value
    rates = {scope: rate_of(values, where=": ".join([where, *scope])) for scope, values in stated.items()}
    return {scope: rate for scope, rate in rates.items() if rate > 0}


def _stated_rates(leaves: Iterable[Leaf], names: Iterable[str], where: str) -> dict[str, float]:
    rate = _scalar_rates(leaves, where).get(())
    return dict.fromkeys(names, rate) if rate else {}


def short_names(paths: Sequence[tuple[str, ...]]) -> list[str]:
    """Return for each path its last part, or as many of its last parts as no other path ends with."""
    parts = [1] * len(paths)
    while True:
        names = [".".join(path[-count:]) for path, count in zip(paths, parts, strict=True)]
        doubled = {name for name, count in Counter(names).items() if count > 1}
        longer = [
            count + 1 if name in doubled and count < len(path) else count
            for name, count, path in zip(names, parts, paths, strict=True)
        ]
        if longer == parts:
            return distinct(names)
        parts = longer
