"""Filter chains on a recording that is too long to be held: block by block, overlapping by what the stages look at."""

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
from torquerig.filters.effect import FilterEffect, chain_effects
from torquerig.filters.reach import reach_of
from torquerig.recordings.files.blocks import Block, Blocking, sound_blocks
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.recording import Recording

BLOCK = 20.0
"""What a block answers for [s], where its samples are not too many and the overlap is not larger."""

_MOST_SAMPLES, _MOST_TOGETHER = 2**19, 5 * 2**18
# large blocks are worked on one at a time, because memory counts more than speed
_WORKERS, _LARGE = 2, 2**20

Given = TypeVar("Given")
Made = TypeVar("Made")
_Worked = tuple[int, Recording, tuple[Recording, ...]]


@dataclass(frozen=True, kw_only=True)
class FilteredBlock:
    """A stretch of a recording before and after each of some chains, without overlap, and what each chain did."""

    first: int
    before: Recording
    after: tuple[Recording, ...]
    effects: tuple[FilterEffect, ...]


def blocking_for(chains: Sequence[Chain], stream: RecordingStream, *, block: float = BLOCK) -> Blocking:
    """Return how a recording is to be cut for some chains.

    Parameters
    ----------
    chains : sequence of Chain
        Each works on the same blocks; the farthest reach counts.
    stream : RecordingStream
    block : float
        What each block answers for [s]; made longer where it would be less than the overlap on both sides together,
        as far as memory goes: what is worked on twice counts more than short blocks.

    Raises
    ------
    RecordingError
        For a stage that needs the whole recording, or a run whose set-point changes over the recording: its blocks
        would not know where in the profile they stand.
    """
    if stream.run.profile != "steady":
        raise RecordingError(
            f"{stream.path.name}: a {stream.run.profile} cannot be filtered block by block, because a block does not "
            "know where in the profile it stands; cut the recording, or take one that fits into memory"
        )
    rate = stream.sample_rate
    head = next(Blocking(samples=max(round(rate), 2)).cut(stream)).recording
    reach = ceil(max((reach_of(chain, head) for chain in chains), default=0.0) * rate)
    # whole multiples of a power of two, so that transforms of a block are fast
    unit = 2 ** int(log2(max(reach, 16) / 8))
    overlap = -(-reach // unit) * unit
    least = min(2 * overlap, max(_MOST_TOGETHER - 2 * overlap, overlap))
    samples = max(min(round(block * rate), _MOST_SAMPLES), least)
    return Blocking(samples=-(-samples // unit) * unit, overlap=overlap, unit=unit)


def filtered_blocks(
    chains: Sequence[Chain], stream: RecordingStream, blocking: Blocking, *, ratio: float
) -> Iterator[FilteredBlock]:
    """Go through a recording with its chains applied, in order and without overlap.

    Each stage sees the overlap on either side and its answer there is thrown away. Two blocks are worked on at a
    time, unless they are large.
    ``ratio``, motor turns per output turn [1], serves the energies (:func:`chain_effect`).

    Raises
    ------
    RecordingError
        Where samples are no numbers or time jumps, and what the stages raise.
    """

    def work(block: Block) -> _Worked:
        before = block.without_overlap()
        return block.first, before, tuple(_answer(block, chain.apply(block.recording), before) for chain in chains)

    workers = _WORKERS if blocking.samples + 2 * blocking.overlap <= _LARGE else 1
    for first, before, after in _side_by_side(work, sound_blocks(stream, blocking), workers=workers):
        effects = chain_effects(before, after, ratio=ratio, lines=[chain.lines for chain in chains])
        yield FilteredBlock(first=first, before=before, after=after, effects=effects)


def _answer(block: Block, made: Recording, before: Recording) -> Recording:
    """Return what the block answers for; channels that the chain left alone are those of ``before``, not copies."""
    given, answer = block.recording.channels, before
    for name, channel in made.channels.items():
        if name not in given or channel.values is not given[name].values:
            kept = replace(channel, values=channel.values[block.kept].copy())
            answer = answer.with_channel(name, kept)
    return answer


def _side_by_side(work: Callable[[Given], Made], given: Iterable[Given], *, workers: int) -> Iterator[Made]:
    """Give ``work(each)`` in order, one ahead; numpy and kernels let go of the interpreter, so that threads help."""
    waiting: deque[Future[Made]] = deque()
    # the threads of linear algebra would spin against the workers
    with threadpool_limits(limits=1, user_api="blas"), ThreadPoolExecutor(workers) as pool:
        for each in given:
            waiting.append(pool.submit(work, each))
            if len(waiting) >= _WORKERS:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
