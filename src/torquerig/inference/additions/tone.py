"""A nameless tone: a fixed frequency in the signal, and its multiples."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig.inference.addition import Addition
from torquerig.inference.context import Context
from torquerig.inference.tones import tone

_LOG_ODDS = -9.0  # anywhere on the search grid
_CLEAREST = 8  # lines; others follow when these are explained


def propose(context: Context) -> Iterator[Addition]:
    """Yield a tone for each found frequency."""
    for line in context.lines[:_CLEAREST]:
        if line.place.domain == "frequency":
            yield from tone(context, line.place, name="unnamed_tone", mechanism="", kind="tone", log_odds=_LOG_ODDS)
