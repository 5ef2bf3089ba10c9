"""LabVIEW TDMS: the channels of its groups, with the waveform's increment and unit, through npTDMS."""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.lvm_parts.times import seconds_of
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.sidecar_text import SIDECAR_KEY, sidecar_text
from torquerig.recordings.files.starts import late_starts
from torquerig.recordings.files.table_pieces import PIECE
from torquerig.recordings.files.timing import shortest_rate
from torquerig.recordings.names.time_column import time_column
from torquerig.recordings.recording import Recording

_LEAD_IN = 28  # bytes that every segment begins with
_EPOCH = np.datetime64("2000-01-01")
_CUT_SHORT = ("incomplete", "less data", "multiple of the chunk", "Cropping")


def read_tdms(path: Path) -> Table:
    """Read the channels of numbers, scaled as the file states; a name that two groups share becomes ``group/name``.

    Texts, channels without samples and channels over another axis than time are skipped by name. Each channel has the
    rate of its waveform, so that groups of several rates can be read. Time stamps are the times where no channel
    states its increment.

    Raises
    ------
    RecordingError
        When the file ends before its segments do, or a channel has a scale that npTDMS does not know (it would return
        unscaled numbers).
    """
    from nptdms import TdmsFile

    with nptdms_warnings() as warnings, path.open("rb") as raw:
        # npTDMS raises errors of many kinds for a damaged file
        try:
            file = TdmsFile.read(raw)
            found = channels_in(file)
            columns = {name: numbers_of(channel[:]) for name, channel in found.channels.items()}
            incomplete = file.file_status.incomplete_final_segment
        except Exception as error:
            raise not_whole(path, error) from None
    check_whole(path, warnings, incomplete=incomplete)
    return Table(
        columns=columns, rates=found.rates, units=found.units, skipped=found.skipped, notes=found.notes,
        sidecar=found.sidecar, starts=found.starts,
    )  # fmt: skip


def numbers_of(samples: Any) -> NDArray[np.float64]:
    """Return samples as float64, time stamps in seconds since 2000; a damaged float may be a signalling NaN."""
    array = np.asarray(samples)
    with np.errstate(invalid="ignore"):
        if array.dtype.kind == "M":
            seconds = (array - _EPOCH) / np.timedelta64(1, "us") * 1e-6
            return np.where(np.isnat(array), np.nan, seconds)
        return np.asarray(array, dtype=np.float64)


def write_tdms(recording: Recording, path: Path) -> None:
    """Write one group ``recording`` with a waveform of float64 for each channel; same recording, same bytes.

    The samples are written in segments of ``PIECE`` samples, so that a reader holds no more than that at a time.
    """
    with path.open("wb") as file:
        writer = tdms_writer(file, recording)
        for first in range(0, recording.samples, PIECE):
            append_tdms(writer, {name: one.values[first : first + PIECE] for name, one in recording.channels.items()})
        writer[0].close()


def tdms_writer(file: BinaryIO, recording: Recording) -> tuple[Any, Recording]:
    """Return a writer of consecutive blocks of the channels of ``recording``."""
    from nptdms import TdmsWriter

    writer = TdmsWriter(file)
    writer.open()
    return writer, recording


def append_tdms(writer: tuple[Any, Recording], columns: Mapping[str, NDArray[np.float64]]) -> None:
    """Write one more segment."""
    from nptdms import ChannelObject, RootObject

    file, recording = writer
    file.write_segment(
        [
            RootObject({SIDECAR_KEY: sidecar_text(recording)}),
            *(
                ChannelObject(
                    "recording",
                    name,
                    np.asarray(values, dtype=np.float64),
                    {
                        "wf_increment": 1 / recording.sample_rate,
                        "wf_start_offset": 0.0,
                        "wf_samples": values.size,
                        "unit_string": recording.channels[name].unit,
                    },
                )
                for name, values in columns.items()
            ),
        ]
    )


@dataclass(frozen=True, kw_only=True)
class TdmsChannels:
    """The channels of numbers of a file by name, their rates [Hz] and units, and what is skipped."""

    channels: Mapping[str, Any]
    rates: Mapping[str, float]
    units: Mapping[str, str]
    skipped: Mapping[str, str]
    notes: tuple[str, ...]
    sidecar: str
    starts: Mapping[str, float]


def channels_in(file: Any) -> TdmsChannels:
    """Return the channels of an open file; ``group/name`` where two groups share a name."""
    every = [channel for group in file.groups() for channel in group.channels()]
    doubled = {name for name, count in Counter(channel.name for channel in every).items() if count > 1}
    channels, rates, skipped, starts = {}, {}, {}, {}
    units: dict[str, str] = {}
    stamps = _stamps(every)
    for channel in every:
        name = f"{channel.group_name}/{channel.name}" if channel.name in doubled else channel.name
        if channel in stamps:
            name = name if time_column([name], {name: "s"}) else "time_s"
            channels[name], units[name] = channel, "s"
            continue
        reason = _reason(channel)
        if reason:
            skipped[name] = reason
            continue
        channels[name] = channel
        increment = _number(channel, "wf_increment") * (seconds_of(_text(channel, "wf_xunit_string")) or 1.0)
        if increment > 0:
            rates[name] = shortest_rate(1 / increment, tolerance=1e-11)
        starts[name] = _start(channel)
        # of DIAdem, and of DAQmx where it logs to the file
        unit = _text(channel, "unit_string") or _text(channel, "NI_UnitDescription")
        units |= {name: unit} if unit else {}
    return TdmsChannels(
        channels=channels, rates=rates, units=units, skipped=skipped, notes=late_starts(starts, rates),
        sidecar=str(file.properties.get(SIDECAR_KEY, "")), starts=starts,
    )  # fmt: skip


def _stamps(every: list[Any]) -> list[Any]:
    """Return the channels of time stamps that are times: where no channel states its increment.

    Where their names do not show it, only one of them can be the time.
    """
    if any(_number(channel, "wf_increment") > 0 for channel in every):
        return []
    stamps = [channel for channel in every if len(channel) > 1 and channel.dtype.kind == "M"]
    named = [channel for channel in stamps if time_column([channel.name], {channel.name: "s"})]
    return named or (stamps if len(stamps) == 1 else [])


def _reason(channel: Any) -> str:
    """Return why a channel is no recording over time, or nothing."""
    if not len(channel):
        return "it has no samples"
    kind = channel.dtype.kind
    if kind not in "fiub":
        return {"O": "texts", "U": "texts", "M": "time stamps", "c": "complex numbers"}.get(kind, "no numbers")
    axis = _text(channel, "wf_xname")
    if seconds_of(_text(channel, "wf_xunit_string")) is None:
        return f"its X unit is {_text(channel, 'wf_xunit_string')}, not one of time"
    return f"its X axis is {axis}, not time" if axis.lower() not in ("", "time", "zeit") else ""


def _start(channel: Any) -> float:
    """Return when the waveform starts [s]."""
    moment = channel.properties.get("wf_start_time")
    whole = 0.0
    if isinstance(moment, np.datetime64):
        whole = float((moment - _EPOCH) / np.timedelta64(1, "us")) * 1e-6
    return whole + _number(channel, "wf_start_offset")


def _number(channel: Any, key: str) -> float:
    value = channel.properties.get(key, 0.0)
    return float(value) if isinstance(value, int | float | np.number) and np.isfinite(value) else 0.0


def _text(channel: Any, key: str) -> str:
    value = channel.properties.get(key, "")
    return value.strip() if isinstance(value, str) else ""


def check_whole(path: Path, warnings: list[str], *, incomplete: bool) -> None:
    """Raise RecordingError where npTDMS warned of an incomplete file or of a scale that it does not know."""
    size = path.stat().st_size
    if size < _LEAD_IN:
        raise RecordingError(
            f"{path}: the file ends after {size} bytes, which is shorter than the header of a TDMS file; copy it again "
            "from its source"
        )
    if incomplete or any(sign in message for message in warnings for sign in _CUT_SHORT):
        raise RecordingError(
            f"{path}: the TDMS file ends in the middle of its last segment (the writing was cut short); copy it again "
            "from its source, or open it in LabVIEW and save the complete part"
        )
    for message in warnings:
        if "scale" in message:
            raise RecordingError(
                f"{path}: a channel has a scale that is not supported ({message.rpartition(': ')[2]}); in LabVIEW, "
                "write the scaled values"
            )


def not_whole(path: Path, error: Exception) -> RecordingError:
    """Return the error for a file that npTDMS cannot read."""
    reason = " ".join(str(error).split())
    return RecordingError(f"{path}: not a whole TDMS file ({reason}); copy it again from its source")


class _Collector(logging.Handler):
    """Log handler that collects the texts of the warnings."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.messages: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.messages.append(record.getMessage())


@contextmanager
def nptdms_warnings() -> Iterator[list[str]]:
    """Collect the warnings that npTDMS logs instead of printing them; its handlers are restored afterwards."""
    from nptdms.log import log_manager

    collector, loggers = _Collector(), list(log_manager.loggers.values())
    before = [(logger, list(logger.handlers), logger.propagate) for logger in loggers]
    for logger in loggers:
        logger.handlers, logger.propagate = [collector], False
    try:
        yield collector.messages
    finally:
        for logger, handlers, propagate in before:
            logger.handlers, logger.propagate = handlers, propagate
