"""Overlapping blocks of a long recording."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files.checks import check_counts, check_finite
from torquerig.recordings.files.gaps import gaps_in, refuse_gaps
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.files.timebase import EVENLY
from torquerig.recordings.files.timing import timing_of
from torquerig.recordings.recording import Recording

# times from which coarse and late ones are judged together [1]
_JUDGED = 400
# largest difference of two rates that are the same [1]
_SAME_RATE = 1e-3


@dataclass(frozen=True, kw_only=True)
class Block:
    """A block of samples with an overlap on either side.

    Parameters
    ----------
    recording : Recording
        The samples of the block with the overlap.
    first : int
        The number of the first sample without the overlap, in the whole recording.
    kept : slice
        The samples without the overlap, as a slice of ``recording``.
    times : ndarray or None
        Times of the samples without the overlap [s], where the file has a column of times.
    """

    recording: Recording
    first: int
    kept: slice
    times: NDArray[np.float64] | None = None

    def without_overlap(self, processed: Recording | None = None) -> Recording:
        """Return the samples without the overlap: of ``processed`` (the block after a stage), else of the block."""
        trimmed = processed or self.recording
        for name, channel in trimmed.channels.items():
            # a copy, so that the memory of the overlap is released
            trimmed = trimmed.with_values(name, channel.values[self.kept].copy())
        return trimmed


@dataclass(frozen=True, kw_only=True)
class Blocking:
    """Blocks of ``samples``, each with ``overlap`` samples on either side where the recording has them.

    The last block has between 0.5 and 1.5 times ``samples``, so that no block is too short for a stage. Each block
    reaches up to ``unit`` samples further back, so that its length is a multiple of ``unit``: transforms of a length
    with large prime factors are slow and need several times the memory.
    """

    samples: int
    overlap: int = 0
    unit: int = 1

    def __post_init__(self) -> None:
        if self.samples < 2 or self.overlap < 0:
            raise InputError(
                f"blocks of {self.samples} samples that overlap by {self.overlap} are not possible; write at least 2 "
                "and 0"
            )

    def cut(self, stream: RecordingStream) -> Iterator[Block]:
        """Yield the blocks of the recording as it is in the file: it may hold NaN and gaps."""
        held = _Held(self.samples + self.samples // 2 + 2 * self.overlap + self.unit)
        start = 0
        for piece in stream.columns():
            held.append(piece)
            while held.stop - start >= self.samples + self.samples // 2 + self.overlap:
                yield self._block(stream, held, start=start, stop=start + self.samples)
                start += self.samples
                held.forget(start - self.overlap - self.unit + 1)
        check_counts({"the table": held.stop}, str(stream.path))
        yield self._block(stream, held, start=start, stop=held.stop)

    def _block(self, stream: RecordingStream, held: _Held, *, start: int, stop: int) -> Block:
        low, high = max(start - self.overlap, 0), min(stop + self.overlap, held.stop)
        back = -(high - low) % self.unit
        low -= back if low - back >= held.start else 0
        cut = held.copied(low, high)
        kept = slice(start - low, stop - low)
        time = stream.table.time_name()
        times = cut[time][kept] if time is not None else None
        return Block(recording=stream.of(cut), first=start, kept=kept, times=times)


def sound_blocks(stream: RecordingStream, blocking: Blocking) -> Iterator[Block]:
    """Yield the blocks of a recording without gaps, all of whose samples are finite.

    Raises
    ------
    RecordingError
        At the first sample that is not a finite number, or the first jump of time, with the number of the sample.
    """
    before = None
    for block in blocking.cut(stream):
        if block.times is not None:
            _refuse_uneven(stream, block, before)
            before = float(block.times[-1])
        check_finite(block.recording, first=block.first - block.kept.start)
        yield block


def _refuse_uneven(stream: RecordingStream, block: Block, before: float | None) -> None:
    """Raise RecordingError for a jump of time; coarse and late times are judged over the whole block."""
    if block.times is None:
        return
    name, where = str(stream.table.time_name()), str(stream.path)
    if not stream.time_scatter or block.times.size < _JUDGED:
        gaps = gaps_in(block.times, stream.sample_rate, first=block.first, before=before, scatter=stream.time_scatter)
        refuse_gaps(gaps, name=name, rate=stream.sample_rate, where=where)
    if block.times.size < _JUDGED:
        return
    problem = uneven_times(block.times, stream, first=block.first, before=before)
    if problem:
        raise RecordingError(f"{where}: {problem}; {EVENLY}")


def uneven_times(
    times: NDArray[np.float64], stream: RecordingStream, *, first: int, before: float | None = None
) -> str:
    """Return why the times of a block are not those of even samples at the stream's rate; empty where they are.

    Parameters
    ----------
    times : ndarray, shape (samples,)
        [s].
    stream : RecordingStream
    first : int
        The number of the block's first sample in the recording.
    before : float, optional
        The time of the sample before the block [s].
    """
    name = str(stream.table.time_name())
    name = f"from sample {first} on, {name}" if first else name
    whole = times if before is None else np.concatenate([[before], times])
    timing = timing_of(whole, name=name, stated=stream.sample_rate)
    if timing.problem:
        return f"{name} {timing.problem}"
    if abs(timing.rate / stream.sample_rate - 1) > max(_SAME_RATE, 2 * timing.uncertainty):
        return f"{name} shows {timing.rate:.6g} Hz instead of {stream.sample_rate:.6g} Hz"
    return ""


class _Held:
    """A buffer of the samples that blocks still need: appended at the end, dropped at the start, arrays reused."""

    def __init__(self, expected: int) -> None:
        self.start = self.stop = 0
        self._expected = expected
        self._arrays: dict[str, NDArray[np.float64]] = {}

    def append(self, piece: Mapping[str, NDArray[np.float64]]) -> None:
        """Append samples of each column."""
        size = next((values.size for values in piece.values()), 0)
        used = self.stop - self.start
        for name, values in piece.items():
            array = self._arrays.get(name, values[:0])
            if array.size < used + size:
                # pages of np.empty that are never written take no memory
                larger = np.empty(max(self._expected + size, used + size))
                larger[:used] = array[:used]
                array = self._arrays[name] = larger
            array[used : used + size] = values
        self.stop += size

    def forget(self, before: int) -> None:
        """Drop the samples before the number ``before``."""
        lost = max(before - self.start, 0)
        used = self.stop - self.start
        for array in self._arrays.values():
            array[: used - lost] = array[lost:used]
        self.start += lost

    def copied(self, low: int, high: int) -> dict[str, NDArray[np.float64]]:
        """Return the samples from number ``low`` up to ``high``, of every column."""
        part = slice(low - self.start, high - self.start)
        return {name: array[part].copy() for name, array in self._arrays.items()}
