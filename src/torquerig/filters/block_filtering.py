"""Filter chains on a long recording, block by block; the blocks overlap by the reach of the stages."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from math import ceil, log2
from typing import TypeVar

from threadpoolctl import threadpool_limits

from torquerig.errors import RecordingError
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.filter_effect import FilterEffect, chain_effects
from torquerig.filters.reach import reach_of
from torquerig.recordings.files.blocks import Block, Blocking, sound_blocks
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.recording import Recording

BLOCK = 20.0
"""Length of a block without overlap [s], where it has not too many samples and the overlap is not larger."""

_MOST_SAMPLES, _MOST_TOGETHER = 2**19, 5 * 2**18
# large blocks are processed one at a time, to save memory
_WORKERS, _LARGE = 2, 2**20

Given = TypeVar("Given")
Made = TypeVar("Made")
_Worked = tuple[int, Recording, tuple[Recording, ...]]


@dataclass(frozen=True, kw_only=True)
class FilteredBlock:
    """A block of a recording before and after each of some filter chains, without overlap, and their effects."""

    first: int
    before: Recording
    after: tuple[Recording, ...]
    effects: tuple[FilterEffect, ...]


def blocking_for(chains: Sequence[Chain], stream: RecordingStream, *, block: float = BLOCK) -> Blocking:
    """Return the length and overlap of blocks for some filter chains.

    Parameters
    ----------
    chains : sequence of Chain
        All work on the same blocks; the largest reach determines the overlap.
    stream : RecordingStream
    block : float
        Length of each block without overlap [s]; made longer where it would be less than the overlap on both sides
        together, within the limit of memory, because the overlap is processed twice.

    Raises
    ------
    RecordingError
        For a stage that needs the whole recording, or a run whose set-point changes over the recording: its profile is
        not defined for a single block.
    """
    if stream.run.profile != "steady":
        raise RecordingError(
            f"{stream.path.name}: a {stream.run.profile} cannot be filtered block by block, because its profile is "
            "defined over the whole recording; cut the recording, or take one that fits into memory"
        )
    rate = stream.sample_rate
    head = next(Blocking(samples=max(round(rate), 2)).cut(stream)).recording
    reach = ceil(max((reach_of(chain, head) for chain in chains), default=0.0) * rate)
    # multiples of a power of two, so that transforms of a block are fast
    unit = 2 ** int(log2(max(reach, 16) / 8))
    overlap = -(-reach // unit) * unit
    least = min(2 * overlap, max(_MOST_TOGETHER - 2 * overlap, overlap))
    samples = max(min(round(block * rate), _MOST_SAMPLES), least)
    return Blocking(samples=-(-samples // unit) * unit, overlap=overlap, unit=unit)


def filtered_blocks(
    chains: Sequence[Chain], stream: RecordingStream, blocking: Blocking, *, ratio: float
) -> Iterator[FilteredBlock]:
    """Yield the filtered blocks of a recording, in order and without overlap.

    Each stage is applied to the block with its overlap, which is then discarded. Two blocks are processed at a time,
    unless they are large. ``ratio``, motor turns per output turn [1], is used for the energies (:func:`chain_effect`).

    Raises
    ------
    RecordingError
        Where samples are not numbers or time jumps, and the errors of the stages.
    """

    def work(block: Block) -> _Worked:
        before = block.without_overlap()
        return block.first, before, tuple(_trimmed(block, chain.apply(block.recording), before) for chain in chains)

    workers = _WORKERS if blocking.samples + 2 * blocking.overlap <= _LARGE else 1
    for first, before, after in _parallel_map(work, sound_blocks(stream, blocking), workers=workers):
        effects = chain_effects(before, after, ratio=ratio, lines=[chain.lines for chain in chains])
        yield FilteredBlock(first=first, before=before, after=after, effects=effects)


def _trimmed(block: Block, made: Recording, before: Recording) -> Recording:
    """Return ``made`` without the overlap; unchanged channels are those of ``before``, not copied."""
    given, trimmed = block.recording.channels, before
    for name, channel in made.channels.items():
        if name not in given or channel.values is not given[name].values:
            kept = replace(channel, values=channel.values[block.kept].copy())
            trimmed = trimmed.with_channel(name, kept)
    return trimmed


def _parallel_map(work: Callable[[Given], Made], given: Iterable[Given], *, workers: int) -> Iterator[Made]:
    """Yield ``work(each)`` in order, computed in threads; numpy and the kernels release the interpreter lock."""
    waiting: deque[Future[Made]] = deque()
    # threads of the linear algebra library would compete with the workers
    with threadpool_limits(limits=1, user_api="blas"), ThreadPoolExecutor(workers) as pool:
        for each in given:
            waiting.append(pool.submit(work, each))
            if len(waiting) >= _WORKERS:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
