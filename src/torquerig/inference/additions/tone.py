"""A nameless tone: a fixed frequency in the signal, and its multiples."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import Addition, free_name
from torquerig.inference.context import Context
from torquerig.inference.one_size import one_size
from torquerig.inference.places import Place
from torquerig.inference.tones import tone

_LOG_ODDS = -9.0  # anywhere on the search grid
_CLEAREST = 8  # lines; others follow when these are explained
_NAME = "unnamed_tone"


def propose(context: Context) -> Iterator[Addition]:
    """Yield a tone for each found frequency."""
    for line in context.lines[:_CLEAREST]:
        if line.place.domain != "frequency":
            continue
        if hasattr(mechanisms, "MainsInterference"):
            yield from tone(context, line.place, name=_NAME, mechanism="", kind="tone", log_odds=_LOG_ODDS)
        else:
            yield from _single(context, line.place)


def _single(context: Context, place: Place) -> Iterator[Addition]:
    """Yield a tone without multiples, for a library that lacks the part with them."""
    name = free_name(context.rig, _NAME)

    def volts(size: float) -> mechanisms.PwmAliasing:
        return mechanisms.PwmAliasing(name=name, frequency=place.at, amplitude=size)

    yield from one_size(
        context, volts, field="amplitude", place=place, kind="tone", log_odds=_LOG_ODDS,
        label=f"a tone at {place.at:.5g} Hz", fixed={"frequency_Hz": (place.at, context.resolution, "Hz")},
    )  # fmt: skip
