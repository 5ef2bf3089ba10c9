"""Several chains on one recording; what they begin with in common is computed once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage


def filtered_by(chains: Mapping[str, Chain], recording: Recording) -> Iterator[tuple[str, Recording]]:
    """Yield the name of each chain and ``recording`` after it, as ``chain.apply`` returns it.

    Equal stages at the start of several chains are applied once; their results are held until the last chain.
    """
    starts = [chain.stages for chain in chains.values()]
    held: list[tuple[tuple[Stage, ...], Recording]] = []
    for name, chain in chains.items():
        made = recording
        for count, stage in enumerate(chain.stages, start=1):
            done = chain.stages[:count]
            known = next((after for stages, after in held if stages == done), None)
            made = stage.apply(made) if known is None else known
            if known is None and sum(stages[:count] == done for stages in starts) > 1:
                held.append((done, made))
        yield name, made
