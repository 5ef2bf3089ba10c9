"""``torquerig filter`` on a recording that does not fit into memory: block by block."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import ceil
from pathlib import Path

import click
import numpy as np

from torquerig.cli.progress import drive_progress
from torquerig.errors import RecordingError
from torquerig.filters.block_filtering import FilteredBlock, blocking_for, filtered_blocks
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.filter_effect import FilterEffect
from torquerig.filters.joined_effect import joined_effect
from torquerig.metrics.truth_error import true_load, truth_error
from torquerig.recordings.files.block_writing import write_blocks
from torquerig.recordings.files.blocks import Blocking
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.recording import Recording

_LONG = 16_000_000
"""Samples of all channels together above which a recording is filtered in blocks: 128 MB."""


@dataclass(frozen=True, kw_only=True)
class LongResult:
    """Result of a long recording: effect and error to the true load of each chain, and a section for the figure."""

    effects: tuple[FilterEffect, ...]
    errors: tuple[float, ...] | None
    section: FilteredBlock
    samples: int
    written: Sequence[Path] = ()


def blocks_for(stream: RecordingStream, chains: Sequence[Chain], *, block: float | None) -> Blocking | None:
    """Return the blocks of the recording, or None to filter it as a whole; print why a long one is not cut.

    ``block`` [s] sets the length of the blocks, whatever the length of the recording.
    """
    if block is not None:
        return blocking_for(chains, stream, block=block)
    if stream.samples is not None and stream.samples * len(stream.entries) <= _LONG:
        return None
    if stream.table.read_whole:
        click.echo(f"filtered as a whole: {stream.table.read_whole}")
        return None
    try:
        return blocking_for(chains, stream)
    except RecordingError as error:
        click.echo(f"filtered as a whole: {error}")
        return None


def filter_long(
    stream: RecordingStream, chains: Sequence[Chain], blocking: Blocking, *, ratio: float, out: Path | None, force: bool
) -> LongResult:
    """Filter block by block, write the output of the first chain to ``out`` if given, and return the result."""
    collected = _BlockResults()
    blocks = collected.collecting(filtered_blocks(chains, stream, blocking, ratio=ratio), stream)
    written: Sequence[Path] = ()
    with drive_progress(f"filter {stream.path.name}") as progress:
        shown = _showing(blocks, stream, progress)
        if out is not None:
            written = write_blocks((block.after[0] for block in shown), out, overwrite=force)
            click.echo(f"wrote {' and '.join(str(path) for path in written)}")
        for _ in shown:
            pass
    return replace(collected.result(), written=written)


def _showing(
    blocks: Iterator[FilteredBlock], stream: RecordingStream, progress: Callable[[int, int, str], None]
) -> Iterator[FilteredBlock]:
    """Yield the blocks and show how many seconds of the recording are done, where its length is known."""
    total = None if stream.samples is None else ceil(stream.samples / stream.sample_rate)
    for block in blocks:
        yield block
        if total is not None:
            done = (block.first + block.before.samples) / stream.sample_rate
            progress(min(round(done), total), total, "s of the recording")


class _BlockResults:
    """Collects the effects of the blocks while they are read."""

    def __init__(self) -> None:
        self.samples: list[int] = []
        self.effects: list[tuple[FilterEffect, ...]] = []
        self.errors: list[list[float]] = []
        self.section: FilteredBlock | None = None

    def collecting(self, blocks: Iterator[FilteredBlock], stream: RecordingStream) -> Iterator[FilteredBlock]:
        for block in blocks:
            self.samples.append(block.before.samples)
            self.effects.append(block.effects)
            if true_load(block.before) is not None:
                self.errors.append([truth_error(after, block.before) for after in block.after])
            # the drawn section is the middle block, or the first where the length is unknown
            if self.section is None or block.first <= (stream.samples or 0) // 2:
                self.section = block
            yield block

    def result(self) -> LongResult:
        if self.section is None:
            raise RecordingError("the recording has no samples; record it again")
        errors = None
        if self.errors:
            weights = np.array(self.samples) / sum(self.samples)
            errors = tuple(float(one) for one in np.sqrt(weights @ np.array(self.errors) ** 2))
        effects = tuple(joined_effect(each, self.samples) for each in zip(*self.effects, strict=True))
        return LongResult(effects=effects, errors=errors, section=self.section, samples=sum(self.samples))


def described(stream: RecordingStream) -> Recording:
    """Return the recording without samples: its sidecar, run and name."""
    return stream.of(dict.fromkeys(stream.entries, np.empty(0)))
