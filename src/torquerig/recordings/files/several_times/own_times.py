"""Tables with several columns of times: each column gets the rate and the start of its times."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.several_times.clocks import Clock, clocks_of, is_rising
from torquerig.recordings.files.starts import late_starts
from torquerig.recordings.files.table_pieces import Columns, TablePieces, pieces_of
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.time_column import TimeColumn, time_column, time_columns
from torquerig.recordings.names.time_pairs import named_pairs, paired_times


@dataclass(frozen=True, kw_only=True)
class OwnTimes:
    """What several columns of times mean for a table.

    Parameters
    ----------
    names : tuple of str
        The columns that are kept, in the order of the file.
    lengths : mapping of str to int
        Samples of those that end before the table does.
    rates, starts, skipped, notes
        As in :class:`Table`; in addition to, or instead of, those of the file.
    renamed : mapping of str to str
        The new name of the one column of times, where its name does not show that it is one.
    """

    names: tuple[str, ...]
    lengths: Mapping[str, int] = field(default_factory=dict)
    rates: Mapping[str, float] = field(default_factory=dict)
    starts: Mapping[str, float] = field(default_factory=dict)
    skipped: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    renamed: Mapping[str, str] = field(default_factory=dict)


def with_own_times(table: Table, *, kept: Collection[str] = ()) -> Table:
    """Return the table in which several columns of times have become rates and starts of the other columns.

    Equal times are read once. The columns in ``kept`` (those that a sidecar names) are never times.
    """
    found = own_times(pieces_of(table, reason=""), kept=kept)
    if found is None:
        return table
    return replace(
        table,
        columns={_new(found, name): table.columns[name][: found.lengths.get(name)] for name in found.names},
        rates=_of_kept(found, table.rates, found.rates),
        starts=_of_kept(found, table.starts, found.starts),
        units=_units(found, table.units),
        skipped={**table.skipped, **found.skipped},
        notes=(*table.notes, *found.notes),
    )


def pieces_with_own_times(table: TablePieces, *, kept: Collection[str] = ()) -> TablePieces:
    """Return the same for a table that is read piece by piece."""
    found = own_times(table, kept=kept)
    if found is None:
        return table
    written = {_new(found, name): name for name in found.names}

    def pieces(wanted: Sequence[str]) -> Iterator[Columns]:
        first = 0
        for piece in table.pieces([written[name] for name in wanted]):
            yield {name: _until(piece[written[name]], first, found.lengths.get(written[name])) for name in wanted}
            first += max((values.size for values in piece.values()), default=0)

    lengths = {**table.lengths, **found.lengths}
    return replace(
        table,
        names=tuple(written),
        pieces=pieces,
        lengths={new: lengths[name] for new, name in written.items() if name in lengths},
        rates=_of_kept(found, table.rates, found.rates),
        starts=_of_kept(found, table.starts, found.starts),
        units=_units(found, table.units),
        skipped={**table.skipped, **found.skipped},
        notes=(*table.notes, *found.notes),
    )


@np.errstate(all="ignore")  # damaged times are refused by what they show
def own_times(table: TablePieces, *, kept: Collection[str] = ()) -> OwnTimes | None:
    """Return what the columns of times mean for the others; None where there is at most the usual one."""
    times = _times(table, kept)
    if len(times) < 2:
        return None
    first = next(iter(table.pieces([one.name for one in times])), {})
    head = {one.name: first.get(one.name, np.empty(0)) for one in times}
    named = set(named_pairs(table.names, [one.name for one in times]).values())
    # times that belong to a column by name are times even where they are faulty
    times = [one for one in times if one.name in named or is_rising(head[one.name])]
    if len(times) < 2:
        return None
    clocks, leaders = clocks_of(table, times, head)
    by_name = {one.name: one for one in clocks}
    signals = [name for name in table.names if name not in by_name]
    pairs = paired_times(table.names, [one.name for one in times], table.lengths)
    main = time_column([one.name for one in times], table.units)
    if not pairs and _is_one_rate(clocks):
        pairs = dict.fromkeys(signals, main.name if main else clocks[0].name)
    used = {leaders[pairs[name]] for name in signals if name in pairs}
    if len(used) == 1 or len(set(leaders.values())) == 1:
        leader = next(iter(used or leaders.values()))
        same = [one for one in clocks if leaders[one.name] == leader]
        return _one_time(table, signals, [one.name for one in _soundest(same)], by_name)
    if not pairs:
        return _unpaired(signals, by_name)
    return _several(table, signals, pairs, by_name)


def _times(table: TablePieces, kept: Collection[str]) -> list[TimeColumn]:
    found = time_columns(table.names, table.units)
    return [one for one in found if one.name not in kept and split_header(one.name)[0] not in kept]


def _is_one_rate(clocks: Sequence[Clock]) -> bool:
    lengths = {one.samples for one in clocks}
    return len(lengths) == 1 and all(one.has_rate_of(clocks[0]) for one in clocks)


def _soundest(same: Sequence[Clock]) -> list[Clock]:
    """Return the same times with the finest and most even ones first."""
    return sorted(same, key=lambda one: (bool(one.timing.problem), one.grain, one.timing.scatter))


def _one_time(table: TablePieces, signals: Sequence[str], same: Sequence[str], clocks: Mapping[str, Clock]) -> OwnTimes:
    """Return the table with one column of times: the plainest of the soundest of those that are the ``same``."""
    first = clocks[same[0]]
    alike = [
        name
        for name in same
        if (clocks[name].grain, clocks[name].timing.problem) == (first.grain, first.timing.problem)
    ]
    main = time_column(alike, table.units)
    kept = main.name if main else same[0]
    renamed = {} if main or "time_s" in table.names else {kept: "time_s"}
    others = [name for name in clocks if name not in same]
    notes = (
        [f"{', '.join(name for name in clocks if name in same)} hold the times of the same samples; {kept} is read"]
        if len(same) > 1
        else []
    )
    notes += [f"{kept} is called time_s"] if renamed else []
    return OwnTimes(
        names=tuple(name for name in table.names if name == kept or name in signals),
        skipped=dict.fromkeys(others, f"times; the columns of numbers belong to {kept}"),
        notes=tuple(notes),
        renamed=renamed,
    )


def _unpaired(signals: Sequence[str], clocks: Mapping[str, Clock]) -> OwnTimes:
    """Return the columns without a time, because nothing shows which of the times is theirs."""
    rates = ", ".join(f"{one.name} ({one.timing.rate:.6g} Hz)" for one in clocks.values())
    note = (
        f"there are several columns of times, {rates}, and neither names nor places show whose they are; name each "
        "after its column (time_torque and torque), or put it in front of its columns"
    )
    skipped = dict.fromkeys(clocks, "times; it is not known of which columns")
    return OwnTimes(names=tuple(signals), skipped=skipped, notes=(note,))


def _several(
    table: TablePieces, signals: Sequence[str], pairs: Mapping[str, str], clocks: Mapping[str, Clock]
) -> OwnTimes:
    """Return each column with the rate and the start of its times; those of unknown or uneven times are skipped."""
    skipped = dict.fromkeys(clocks, "times of other columns")
    rates: dict[str, float] = {}
    notes = [f"{_listed(signals, pairs, name)} at the times of {name}" for name in clocks if name in pairs.values()]
    for name in signals:
        clock = clocks.get(pairs.get(name, ""))
        if clock is None:
            skipped[name] = f"which times are its own is not known ({', '.join(clocks)})"
        elif clock.timing.problem:
            skipped[name] = f"its times {clock.name}: {clock.timing.problem}; save it to a file of its own"
        else:
            rates[name] = clock.timing.rate
            notes += [clock.timing.note] if clock.timing.note else []
            notes += _other_rate(table, name, clock)
    if not rates and pairs:
        return _first_time(table, pairs, clocks)
    starts = {name: clocks[pairs[name]].start for name in rates}
    return OwnTimes(
        names=tuple(rates),
        lengths={name: clocks[pairs[name]].samples for name in rates},
        rates=rates,
        starts=starts,
        skipped=skipped,
        notes=(*dict.fromkeys(notes), *late_starts(starts, rates)),
    )


def _first_time(table: TablePieces, pairs: Mapping[str, str], clocks: Mapping[str, Clock]) -> OwnTimes:
    """Return the columns of the first times, where none are even; what is uneven is then found as in other tables."""
    used = next(iter(pairs.values()))
    found = _one_time(table, [name for name in pairs if pairs[name] == used], [used], clocks)
    others = {
        name: f"its times {time} are not even; save it to a file of its own"
        for name, time in pairs.items()
        if time != used
    }
    return replace(found, skipped={**found.skipped, **others})


def _listed(signals: Sequence[str], pairs: Mapping[str, str], time: str) -> str:
    names = [name for name in signals if pairs.get(name) == time]
    more = f" and {len(names) - 3} more are" if len(names) > 3 else " are" if len(names) > 1 else " is"
    return ", ".join(names[:3]) + more


def _other_rate(table: TablePieces, name: str, clock: Clock) -> list[str]:
    stated = table.rates.get(name)
    if stated is None or abs(stated / clock.timing.rate - 1) <= max(1e-3, clock.timing.uncertainty):
        return []
    step = f"{1 / clock.timing.rate:.6g} s"
    return [f"{name}: its times {clock.name} rise by {step}, which is used instead of the file's {stated:.6g} Hz"]


def _of_kept(found: OwnTimes, stated: Mapping[str, float], own: Mapping[str, float]) -> dict[str, float]:
    """Return what the file states and what the times show, of the columns that are kept."""
    return {_new(found, name): value for name, value in {**stated, **own}.items() if name in found.names}


def _units(found: OwnTimes, stated: Mapping[str, str]) -> dict[str, str]:
    return {_new(found, name): unit for name, unit in stated.items() if name in found.names}


def _new(found: OwnTimes, name: str) -> str:
    return found.renamed.get(name, name)


def _until(values: NDArray[np.float64], first: int, length: int | None) -> NDArray[np.float64]:
    return values if length is None else values[: max(length - first, 0)]
