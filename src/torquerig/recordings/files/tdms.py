"""LabVIEW TDMS: the channels of its groups, with the waveform's increment and unit, through npTDMS."""

from __future__ import annotations

import logging
import struct
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.table_pieces import PIECE
from torquerig.recordings.files.timebase import shortest_rate
from torquerig.recordings.recording import Recording

_LEAD_IN = 28  # bytes that every segment begins with
_CUT_SHORT = ("incomplete", "less data", "multiple of the chunk", "Cropping")


def read_tdms(path: Path) -> Table:
    """Read the channels of numbers, scaled as the file states; a name that two groups share becomes ``group/name``.

    Raises
    ------
    RecordingError
        When the file ends before its segments do, or a channel has a scale that npTDMS does not know (it would return
        unscaled numbers).
    """
    from nptdms import TdmsFile

    with nptdms_warnings() as warnings:
        try:
            file = TdmsFile.read(path)
            named = channel_names([channel for group in file.groups() for channel in group.channels()])
            columns = {name: np.asarray(channel[:], dtype=np.float64) for name, channel in named.items()}
            incomplete = file.file_status.incomplete_final_segment
        except (ValueError, EOFError, OSError, KeyError, TypeError, struct.error) as error:
            raise not_whole(path, error) from None
    check_whole(path, warnings, incomplete=incomplete)
    rates, units = stated(named)
    return Table(columns=columns, rates=rates, units=units)


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
    from nptdms import ChannelObject

    file, recording = writer
    file.write_segment(
        [
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
        ]
    )


def channel_names(channels: list[Any]) -> dict[str, Any]:
    """Return the channels of numbers by name; ``group/name`` where two groups share a name."""
    doubled = {name for name, count in Counter(channel.name for channel in channels).items() if count > 1}
    return {
        f"{channel.group_name}/{channel.name}" if channel.name in doubled else channel.name: channel
        for channel in channels
        if channel.dtype.kind in "fiu"
    }


def stated(named: Mapping[str, Any]) -> tuple[dict[str, float], dict[str, str]]:
    """Return the rates [Hz] and the units that the file states, by channel."""
    rates, units = {}, {}
    for name, channel in named.items():
        increment = float(channel.properties.get("wf_increment", 0.0))
        if increment > 0:
            rates[name] = shortest_rate(1 / increment, tolerance=1e-11)
        if channel.properties.get("unit_string"):
            units[name] = str(channel.properties["unit_string"])
    return rates, units


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
    return RecordingError(f"{path}: not a whole TDMS file ({error}); copy it again from its source")


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
