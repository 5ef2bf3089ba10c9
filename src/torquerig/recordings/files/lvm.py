"""LVM, the LabVIEW measurement text: a file header, then segments of columns, each with its own header."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.lvm_parts.text import X_LABEL, Segment, aligned, counts_of, segments_of
from torquerig.recordings.files.lvm_parts.times import Sampling, sampling, seconds_of
from torquerig.recordings.files.number_table import Table, distinct
from torquerig.recordings.files.starts import late_starts
from torquerig.recordings.files.text_tables.cells import Dialect

Numbers = NDArray[np.float64]


def read_lvm(path: Path) -> Table:
    """Read all segments, one after the other; each channel has its own rate.

    ``Delta_X`` and the X values give the rate (see :func:`sampling`). The X values are kept as ``time_s`` where they
    are uneven, where no rate is stated, and between segments, so that a gap is detected. X values that begin anew in
    each segment are continued by the segments' Date and Time. Units are passed on as written.

    Raises
    ------
    RecordingError
        With the line: no LVM header, a faulty row, segments that differ in channels, units or Delta_X.

    Source: National Instruments, "Specification for the LabVIEW Measurement File (.lvm)": tags Separator,
    Decimal_Separator, X_Columns, Delta_X, Samples, Y_Unit_Label, X_Unit_Label, X_Dimension; special blocks are skipped.
    """
    segments = segments_of(path)
    first = segments[0]
    headers = [aligned(segment.tags, segment.labels) for segment in segments]
    _refuse_different(path, segments, headers)
    skipped: dict[str, str] = {"Comment": "remarks"} if any(segment.has_remarks for segment in segments) else {}
    notes = [f"{len(segments)} segments are joined in the order of the file"] if len(segments) > 1 else []
    notes += [f"segment {number}: {one.note}" if len(segments) > 1 else one.note
              for number, one in enumerate(segments, 1) if one.note]  # fmt: skip
    offsets = _segment_starts(segments, headers)
    remarks: dict[str, list[str]] = {}
    signals = [index for index, label in enumerate(first.labels) if label != X_LABEL]
    columns: dict[str, Numbers] = {}
    rates, units, times, starts = {}, {}, {}, {}
    for name, index in zip(distinct(first.labels[index] for index in signals), signals, strict=True):
        header = {tag: cells.get(index, "") for tag, cells in headers[0].items()}
        reason = _unreadable(segments, headers, index)
        if reason:
            skipped[name] = reason
            continue
        columns[name], x_values = _joined(segments, index, offsets)
        if not _has_own_x(first, headers[0], index):
            x_values = None
        found, x_values = _sampling(x_values, header, decimals=first.decimals)
        if found.note:
            remarks.setdefault(found.note, []).append(name)
        if found.rate > 0:
            rates[name] = found.rate
        starts[name] = _start(header, x_values)
        if x_values is not None and (found.keep_times or found.rate == 0 or len(segments) > 1):
            times[name] = x_values
        if header.get("Y_Unit_Label"):
            units[name] = header["Y_Unit_Label"]
    columns, skipped = _with_times(columns, times, rates, skipped)
    notes += [f"{', '.join(names[:3])}{', ...' if len(names) > 3 else ''}: {note}" for note, names in remarks.items()]
    notes += late_starts(starts, rates)
    return Table(columns=columns, rates=rates, units=units, skipped=skipped, notes=tuple(notes), starts=starts)


def _has_own_x(segment: Segment, header: Mapping[str, dict[int, str]], index: int) -> bool:
    """Return whether the X column to the left of a channel is its own.

    One X column for several channels holds the times of the first; LabVIEW notes "X values guaranteed valid only for"
    it. They are those of another channel too where its Delta_X is the same.
    """
    owner = max(place for place in range(index) if segment.labels[place] == X_LABEL) + 1
    steps = {column: _number(cell) for column, cell in header.get("Delta_X", {}).items()}
    return index == owner or steps.get(index, 0.0) == steps.get(owner, 0.0)


@np.errstate(all="ignore")
def _sampling(x_values: Numbers | None, header: Mapping[str, str], *, decimals: int) -> tuple[Sampling, Numbers | None]:
    """Return the sampling of a channel and its X values in seconds."""
    unit = seconds_of(header.get("X_Unit_Label", "")) or 1.0
    times = None if x_values is None else x_values * unit
    increment = _number(header.get("Delta_X", "")) * unit
    # a digit of a minute or an hour is more than one of a second
    printed = decimals - round(np.log10(unit))
    return sampling(times, increment, decimals=printed), times


def _refuse_different(path: Path, segments: list[Segment], headers: list[dict[str, dict[int, str]]]) -> None:
    if any(segment.labels != segments[0].labels for segment in segments):
        raise RecordingError(f"{path}: its segments hold different channels; save each segment to a separate file")
    for tag in ("Delta_X", "Y_Unit_Label", "X_Unit_Label"):
        # a segment without a header, or without samples of the channel, states nothing
        stated = [header[tag] for header in headers if tag in header]
        for index, label in enumerate(segments[0].labels):
            found = list(dict.fromkeys(cells[index] for cells in stated if cells.get(index)))
            if len({_number(cell) for cell in found} if tag == "Delta_X" else found) > 1:
                raise RecordingError(
                    f"{path}: {label}: its segments state different {tag} ({found[0]} and {found[1]}); save each "
                    "segment to a separate file"
                )


def _unreadable(segments: list[Segment], headers: list[dict[str, dict[int, str]]], index: int) -> str:
    """Return why a column is no recording over time, or nothing."""
    first = {tag: cells.get(index, "") for tag, cells in headers[0].items()}
    if first.get("X_Dimension", "").lower() not in ("", "time", "zeit"):
        return f"its X dimension is {first['X_Dimension']}, not time"
    if seconds_of(first.get("X_Unit_Label", "")) is None:
        return f"its X unit {first['X_Unit_Label']!r} is no unit of time"
    if all(bool(segment.blank[index].all()) for segment in segments):
        return "it has no samples"
    for segment, header in zip(segments, headers, strict=True):
        counts = counts_of(header.get("Samples", {}))
        blank = segment.blank[index]
        if _cut(blank).any() and counts.get(index, 0) < max(counts.values(), default=0):
            return (
                f"it has values in only {int(np.count_nonzero(~blank))} of {blank.size} rows; save it to its own file"
            )
    return ""


def _joined(segments: list[Segment], index: int, offsets: list[float]) -> tuple[Numbers, Numbers | None]:
    """Return the samples of a column and its X values, without the blank cells at the end of each segment."""
    x_index = max(place for place in range(index) if segments[0].labels[place] == X_LABEL)
    values, x_values = [], []
    for segment, offset in zip(segments, offsets, strict=True):
        count = _cut(segment.blank[index]).size
        values.append(segment.columns[index][:count])
        x_values.append(segment.columns[x_index][:count] + offset)
    samples, x_joined = np.concatenate(values), np.concatenate(x_values)
    without_x = all(bool(segment.blank[x_index].all()) for segment in segments)
    return samples, None if without_x else x_joined


def _cut(blank: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the mask without the blank cells at its end."""
    filled = np.flatnonzero(~blank)
    return blank[: filled[-1] + 1 if filled.size else 0]


def _segment_starts(segments: list[Segment], headers: list[dict[str, dict[int, str]]]) -> list[float]:
    """Return what is added to the X values of each segment [X units]: 0, unless they begin anew in each."""
    starts = [float(segment.columns[0][0]) if segment.columns[0].size else np.nan for segment in segments]
    moments = [
        _moment({tag: next(iter(header.get(tag, {}).values()), "") for tag in ("Date", "Time")}) for header in headers
    ]
    if len(segments) == 1 or len(set(starts)) > 1 or any(moment is None for moment in moments):
        return [0.0] * len(segments)
    return [(moment - moments[0]).total_seconds() for moment in moments if moment and moments[0]]


def _start(header: Mapping[str, str], x_values: Numbers | None) -> float:
    """Return when a channel starts [s]: its Date and Time, and its first X value or X0."""
    moment = _moment(header)
    whole = 0.0 if moment is None else (moment - datetime(2000, 1, 1)).total_seconds()
    unit = seconds_of(header.get("X_Unit_Label", "")) or 1.0
    first = x_values[0] if x_values is not None and x_values.size else _number(header.get("X0", "")) * unit
    return whole + (float(first) if np.isfinite(first) else 0.0)


def _moment(header: Mapping[str, str]) -> datetime | None:
    date, time = header.get("Date", ""), header.get("Time", "")
    whole, _, fraction = time.replace(",", ".").partition(".")
    try:
        return datetime.strptime(f"{date} {whole}.{(fraction or '0')[:6]}", "%Y/%m/%d %H:%M:%S.%f")
    except ValueError:
        return None


def _with_times(
    columns: dict[str, Numbers], times: dict[str, Numbers], rates: Mapping[str, float], skipped: dict[str, str]
) -> tuple[dict[str, Numbers], dict[str, str]]:
    """Return the columns after the times of the first; one with other uneven times is skipped."""
    if not times:
        return columns, skipped
    kept = next(iter(times.values()))
    for name, own in times.items():
        if name not in rates and not np.array_equal(own, kept, equal_nan=True):
            columns.pop(name)
            skipped[name] = (
                "its X values are uneven and differ from those of the first channel; save it to its own file"
            )
    return {"time_s": kept, **columns}, skipped


def _number(cell: str) -> float:
    number = Dialect("\t", ".").number(cell.replace(",", "."))
    return 0.0 if number is None or not np.isfinite(number) else number
