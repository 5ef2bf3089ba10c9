"""Filter chains on a recording that is too long to be held: block by block, overlapping by what the stages look at."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from math import ceil, log2
from typing import TypeVar

from threadpoolctl import threadpool_limits

from torquerig.errors import RecordingError
from torquerig.signals.chain import Chain
from torquerig.signals.effect import FilterEffect, chain_effect
from torquerig.signals.files.blocks import Block, Blocking, sound_blocks
from torquerig.signals.files.stream import RecordingStream
from torquerig.signals.reach import reach_of
from torquerig.signals.recording import Recording

BLOCK = 20.0
"""What a block answers for [s], where its samples are not too many and the overlap is not larger."""

_MOST_SAMPLES = 2**19
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
        What each block answers for [s]; made longer where it would be less than the overlap.

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
    unit = 2 ** int(log2(max(reach, 16) / 16))
    overlap = -(-reach // unit) * unit
    samples = max(min(round(block * rate), _MOST_SAMPLES), overlap)
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
        return block.first, block.answer(), tuple(block.answer(chain.apply(block.recording)) for chain in chains)

    workers = _WORKERS if blocking.samples + 2 * blocking.overlap <= _LARGE else 1
    for first, before, after in _side_by_side(work, sound_blocks(stream, blocking), workers=workers):
        effects = tuple(
            chain_effect(before, made, ratio=ratio, lines=chain.lines)
            for chain, made in zip(chains, after, strict=True)
        )
        yield FilteredBlock(first=first, before=before, after=after, effects=effects)


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
