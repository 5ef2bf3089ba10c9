"""The pairs of counts that give the ratios of a rig: teeth of gears, pulleys and worms."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from torquerig.orders.kinematics.teeth import Spur
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts.belt import BeltStage
from torquerig.rig.parts.gear import Gear
from torquerig.rig.parts.worm_gear import WormGear

Pair = tuple[int, int]


@dataclass(frozen=True)
class ToothedStage:
    """A stage with the counts of its input and of its output."""

    name: str
    pair: Pair


def toothed_stages(rig: Rig) -> Iterator[ToothedStage]:
    """Yield the stages of one pair: fixed-axis gears, worms, toothed belts. A planetary set has three counts."""
    for part in rig.parts:
        pair = _pair(part)
        if pair is not None:
            yield ToothedStage(part.name, pair)


def _pair(part: Part) -> Pair | None:
    if isinstance(part, Gear) and len(part.teeth) == 1 and isinstance(part.teeth[0], Spur):
        return part.teeth[0].pinion, part.teeth[0].wheel
    if isinstance(part, WormGear):
        return part.starts, part.wheel_teeth
    if isinstance(part, BeltStage) and part.pinion_teeth is not None and part.wheel_teeth is not None:
        return part.pinion_teeth, part.wheel_teeth
    return None


def with_pair(rig: Rig, stage: ToothedStage, pair: Pair) -> Rig:
    """Return the rig with another pair in a stage; a mesh line that is stated at its output teeth moves with them.

    Raises
    ------
    InputError, ValueError
        Where such a stage cannot be.
    """
    part = rig.part(stage.name)
    if isinstance(part, Gear) and isinstance(part.teeth[0], Spur):
        ratio = abs(pair[1] / pair[0]) * (1 if part.ratio > 0 else -1)
        rig = rig.changed(replace(part, ratio=ratio, teeth=(replace(part.teeth[0], pinion=pair[0], wheel=pair[1]),)))
    elif isinstance(part, WormGear):
        rig = rig.changed(replace(part, starts=pair[0], wheel_teeth=pair[1]))
    elif isinstance(part, BeltStage):
        rig = rig.changed(replace(part, pinion_teeth=pair[0], wheel_teeth=pair[1]))
    for mesh in rig.parts:
        if getattr(mesh, "gear", None) == stage.name and getattr(mesh, "order_output", None) == stage.pair[1]:
            moved: dict[str, Any] = {"order_output": float(pair[1])}
            rig = rig.changed(replace(mesh, **moved))
    return rig
