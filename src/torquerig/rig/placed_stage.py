"""A stage of the measuring chain with its position."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from torquerig.recordings.stage import Stage


@dataclass(frozen=True, kw_only=True)
class PlacedStage:
    """A stage of the measuring chain and its position, counted from the shaft to the file.

    MECHANICAL is the measuring body and its bridge, AMPLIFIER its low-pass, CABLE what the amplifier's output picks up
    on its way, NOISE the noise floor, INPUT the range that the converter's input can follow, CONVERTER the converter,
    FILE what happens to its numbers.
    """

    MECHANICAL: ClassVar[int] = 0
    AMPLIFIER: ClassVar[int] = 1
    CABLE: ClassVar[int] = 2
    NOISE: ClassVar[int] = 3
    INPUT: ClassVar[int] = 4
    CONVERTER: ClassVar[int] = 5
    FILE: ClassVar[int] = 6

    position: int
    stage: Stage
