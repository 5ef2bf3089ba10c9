"""Mains interference: a tone at the frequency of the grid or one of its first multiples."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig.inference.addition import Addition
from torquerig.inference.context import Context
from torquerig.inference.tones import tone

NAMES = ("mains_interference",)

_GRIDS = (50.0, 60.0)  # [Hz]
_MULTIPLES = (
    1,
    2,
    6,
)  # of a ground loop, a single-phase and a three-phase rectifier (Morrison, Grounding and Shielding)
_WITHIN = 0.004  # [1] of the frequency: 0.2 Hz, as grids hold it (EN 50160)
_LOG_ODDS = -3.0


def propose(context: Context) -> Iterator[Addition]:
    """Yield hum for each found tone at a frequency of the grid; a site has one grid, whose multiples are one hum."""
    name = "mains_interference"
    for line in () if context.rig.of_kind(name) else context.lines:
        near = any(abs(line.place.at / (multiple * grid) - 1) < _WITHIN for grid in _GRIDS for multiple in _MULTIPLES)
        if line.place.domain == "frequency" and near:
            yield from tone(context, line.place, name=name, mechanism=name, kind="", log_odds=_LOG_ODDS)
