"""LabVIEW TDMS piece by piece, also where one chunk of the file holds an hour."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any, BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.table_pieces import PIECE, Columns, TablePieces, pieces_of
from torquerig.recordings.files.tdms import channels_in, check_whole, not_whole, nptdms_warnings, numbers_of, read_tdms

# npTDMS reads a chunk at once; the values of chunks with more samples are read here
_LARGEST_CHUNK = PIECE

PRIVATE = {
    "nptdms.tdms.TdmsFile": ("_reader",),
    "nptdms.tdms.TdmsChannel": ("_scale_data",),
    "nptdms.reader.TdmsReader": ("_segments",),
    "nptdms.tdms_segment.TdmsSegment": (
        "get_segment_object", "_get_data_objects", "_have_daqmx_objects", "_have_interleaved_data",
        "data_position", "num_chunks", "toc_mask",
    ),
    "nptdms.base_segment.BaseSegmentObject": ("path", "number_values", "has_data", "data_type"),
    "nptdms.base_segment.RawChannelDataChunk": ("channel_data",),
}  # fmt: skip
"""What is used of npTDMS beyond its documented interface, by class; a test reads each of them."""


def tdms_pieces(path: Path) -> TablePieces:
    """Return the channels of numbers in pieces, scaled as the file states.

    Raises
    ------
    RecordingError
        As :func:`read_tdms`: a file that is cut short, a scale that is not known.
    """
    from nptdms import TdmsFile

    with nptdms_warnings() as warnings, path.open("rb") as raw:
        try:
            with TdmsFile.open(raw) as file:
                found = channels_in(file)
                lengths = {name: len(channel) for name, channel in found.channels.items()}
                incomplete = file.file_status.incomplete_final_segment
                is_raw = any(segment._have_daqmx_objects() for segment in file._reader._segments)
                largest = max((_largest_chunk(file, one.path) for one in found.channels.values()), default=0)
        except Exception as error:
            raise not_whole(path, error) from None
    check_whole(path, warnings, incomplete=incomplete)
    if is_raw and largest > _LARGEST_CHUNK:
        reason = f"raw DAQmx data in chunks of {largest} samples are read whole; write scaled values in LabVIEW"
        return pieces_of(read_tdms(path), reason=reason)

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        yield from _pieces(path, names)

    return TablePieces(
        names=tuple(found.channels),
        lengths=lengths,
        pieces=pieces,
        rates=found.rates,
        units=found.units,
        skipped=found.skipped,
        notes=found.notes,
        sidecar=found.sidecar,
        starts=found.starts,
    )


def _pieces(path: Path, names: Sequence[str]) -> Iterator[Columns]:
    from nptdms import TdmsFile

    with ExitStack() as opened:
        opened.enter_context(nptdms_warnings())
        raw = opened.enter_context(path.open("rb"))
        again = opened.enter_context(path.open("rb"))
        try:
            file = opened.enter_context(TdmsFile.open(again))
            every = channels_in(file).channels
            named = {name: every[name] for name in names}
            spans = {
                name: _spans(file, channel.path)
                if channel.dtype.kind != "M" and _largest_chunk(file, channel.path) > _LARGEST_CHUNK
                else None
                for name, channel in named.items()
            }
            starts = range(0, max((len(channel) for channel in named.values()), default=0), PIECE)
        except Exception as error:
            raise not_whole(path, error) from None
        for first in starts:
            try:
                piece = {name: _read(one, raw, spans[name], first=first, count=PIECE) for name, one in named.items()}
            except Exception as error:
                raise not_whole(path, error) from None
            yield piece


Spans = list[tuple[int, int, int, np.dtype[Any]]]


def _read(channel: Any, raw: BinaryIO, spans: Spans | None, *, first: int, count: int) -> NDArray[np.float64]:
    if spans is None:
        return numbers_of(channel.read_data(first, count))
    from nptdms.base_segment import RawChannelDataChunk

    parts, start = [], 0
    for size, position, stride, kind in spans:
        low, high = max(first - start, 0), min(first + count - start, size)
        start += size
        if low < high:
            raw.seek(position + low * stride)
            parts.append(_column(raw, high - low, stride=stride, kind=kind))
    chunk = RawChannelDataChunk.channel_data(np.concatenate(parts) if parts else np.empty(0))
    return numbers_of(channel._scale_data(chunk))


def _column(raw: BinaryIO, count: int, *, stride: int, kind: np.dtype[Any]) -> NDArray[Any]:
    """Read ``count`` values that are ``stride`` bytes apart."""
    if stride == kind.itemsize:
        return np.fromfile(raw, kind, count)
    rows = np.frombuffer(raw.read(stride * (count - 1) + kind.itemsize), dtype=np.uint8)
    return np.ndarray((count,), kind, buffer=rows.data, strides=(stride,)).copy()


def _largest_chunk(file: Any, path: str) -> int:
    objects = (segment.get_segment_object(path) for segment in file._reader._segments)
    return max((int(one.number_values) for one in objects if one is not None and one.has_data), default=0)


def _spans(file: Any, path: str) -> Spans:
    """Return (samples, place in the file, bytes from one value to the next, type) of each chunk of one channel.

    npTDMS has no function that reads part of a chunk, so its private list of segments is used here (see ``PRIVATE``).
    """
    from nptdms.common import toc_properties

    spans: Spans = []
    for segment in file._reader._segments:
        objects = segment._get_data_objects()
        order: Literal[">", "<"] = ">" if segment.toc_mask & toc_properties["kTocBigEndian"] else "<"
        kinds = [_kind(one.data_type).newbyteorder(order) for one in objects]
        widths = [kind.itemsize for kind in kinds]
        interleaved = segment._have_interleaved_data()
        position = segment.data_position
        for _ in range(segment.num_chunks):
            for index, one in enumerate(objects):
                if one.path == path:
                    stride = sum(widths) if interleaved else widths[index]
                    spans.append((int(one.number_values), position, stride, kinds[index]))
                position += widths[index] * (1 if interleaved else int(one.number_values))
            if interleaved:
                position += sum(widths) * (int(objects[0].number_values) - 1)
    return spans


def _kind(data_type: Any) -> np.dtype[Any]:
    """Return the type of the stored values; time stamps, for which npTDMS has none, as bytes."""
    return np.dtype(f"V{data_type.size}") if data_type.nptype is None else data_type.nptype
