"""LabVIEW TDMS: the channels of its groups, with the waveform's increment and unit, through npTDMS."""

from __future__ import annotations

import logging
import struct
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from torquerig.errors import RecordingError
from torquerig.signals.files.table import Table
from torquerig.signals.files.timebase import shortest_rate
from torquerig.signals.recording import Recording

_CUT_SHORT = ("incomplete", "less data", "multiple of the chunk", "Cropping")


def read_tdms(path: Path) -> Table:
    """Read the channels of numbers, scaled as the file says; a name that two groups share becomes ``group/name``.

    Raises
    ------
    RecordingError
        When the file ends before its segments do, or a channel has a scale that npTDMS does not know (it would hand
        over unscaled numbers).
    """
    from nptdms import TdmsFile

    with _told() as warnings:
        try:
            file = TdmsFile.read(path)
            channels = [channel for group in file.groups() for channel in group.channels()]
            data = {channel.path: channel[:] for channel in channels if channel.dtype.kind in "fiu"}
            cut_short = file.file_status.incomplete_final_segment
        except (ValueError, EOFError, OSError, KeyError, TypeError, struct.error) as error:
            raise RecordingError(f"{path}: not a whole TDMS file ({error}); copy it again from its source") from None
    if cut_short or any(sign in told for told in warnings for sign in _CUT_SHORT):
        raise RecordingError(
            f"{path}: the TDMS file ends in the middle of its last segment (the writing was cut short); copy it again "
            "from its source, or open it in LabVIEW and save the span that is whole"
        )
    for told in warnings:
        if "scale" in told:
            raise RecordingError(
                f"{path}: a channel has a scale that is not supported ({told.rpartition(': ')[2]}); in LabVIEW, write "
                "the scaled values"
            )
    return _table(channels, data)


def write_tdms(recording: Recording, path: Path) -> None:
    """Write one group ``recording`` with a waveform of float64 for each channel; same recording, same bytes."""
    from nptdms import ChannelObject, TdmsWriter

    objects = [
        ChannelObject(
            "recording",
            name,
            np.asarray(channel.values, dtype=np.float64),
            {
                "wf_increment": 1 / recording.sample_rate,
                "wf_start_offset": 0.0,
                "wf_samples": channel.values.size,
                "unit_string": channel.unit,
            },
        )
        for name, channel in recording.channels.items()
    ]
    with path.open("wb") as file, TdmsWriter(file) as writer:
        writer.write_segment(objects)


def _table(channels: list[Any], data: dict[str, np.ndarray]) -> Table:
    doubled = {name for name, count in Counter(channel.name for channel in channels).items() if count > 1}
    columns, rates, units = {}, {}, {}
    for channel in channels:
        if channel.path not in data:
            continue
        name = f"{channel.group_name}/{channel.name}" if channel.name in doubled else channel.name
        columns[name] = np.asarray(data[channel.path], dtype=np.float64)
        increment = float(channel.properties.get("wf_increment", 0.0))
        if increment > 0:
            rates[name] = shortest_rate(1 / increment, tolerance=1e-11)
        if channel.properties.get("unit_string"):
            units[name] = str(channel.properties["unit_string"])
    return Table(columns=columns, rates=rates, units=units)


class _Collector(logging.Handler):
    """Keeps the texts of the warnings."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.told: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.told.append(record.getMessage())


@contextmanager
def _told() -> Iterator[list[str]]:
    """Collect what npTDMS logs instead of letting it print; its handlers are put back afterwards."""
    from nptdms.log import log_manager

    collector, loggers = _Collector(), list(log_manager.loggers.values())
    before = [(logger, list(logger.handlers), logger.propagate) for logger in loggers]
    for logger in loggers:
        logger.handlers, logger.propagate = [collector], False
    try:
        yield collector.told
    finally:
        for logger, handlers, propagate in before:
            logger.handlers, logger.propagate = handlers, propagate
