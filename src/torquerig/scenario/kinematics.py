"""The kinematics of a rig: poles, slots, ratio and teeth, from which its lines follow."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isclose, pi, prod

from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.stage_kinds import ChainStage, DrivenBackwards, Untoothed
from torquerig.orders.kinematics.teeth import Teeth
from torquerig.rig.assembly import Rig
from torquerig.rig.leading_part import leading_motor, leading_part
from torquerig.rig.parts.gear_stage import GearStage
from torquerig.rig.parts.worm_gear import WormGear
from torquerig.rig.reading_place import reading_place
from torquerig.scenario.shafts import shafts_of


@dataclass(frozen=True)
class CrossedStage:
    """A stage on the way from the driving shaft to a part.

    Parameters
    ----------
    part : GearStage
        The gear or belt.
    backwards : bool
        Whether the way enters at its output, as where the scenario lists the parts from the load to the motor.
    """

    part: GearStage
    backwards: bool = False

    @property
    def turns(self) -> float:
        """Turns of the shaft before it per turn of the shaft behind it, with sign [1].

        Of a linear drive the angle per travel [rad/m].
        """
        return 1 / self.part.ratio if self.backwards else self.part.ratio

    @property
    def is_between_shafts(self) -> bool:
        """Whether both its ends turn; what moves in a line has no orders."""
        return not self.part.in_a_line

    @property
    def efficiency(self) -> float:
        """Share of the power that arrives behind it [1]."""
        if isinstance(self.part, WormGear) and self.backwards:
            return self.part.backward_efficiency
        return self.part.efficiency

    def teeth(self) -> tuple[ChainStage, ...]:
        """Return its sets of teeth in the order of the way; its ratio alone where none is known."""
        stated: tuple[Teeth, ...] = self.part.teeth
        if not stated:
            return (Untoothed(abs(self.turns)),)
        return tuple(map(DrivenBackwards, reversed(stated))) if self.backwards else stated


def kinematics_of(rig: Rig) -> Kinematics:
    """Return poles and slots of the rig's driven or first motor, ratio and teeth up to the measured part, all shafts.

    A stage without known teeth counts by its ratio, so that the mesh orders of the other stages are right. On a rig
    without a motor the part whose motion is imposed takes the motor's place. Where what is measured moves in a line,
    the shaft of the linear drive takes the place of the output shaft. Further motors, and one that does not turn with
    the part whose motion is imposed, have their lines in the shafts.
    """
    motor, read = leading_motor(rig), reading_place(rig)
    crossed = tuple(stage for stage in stages_to(rig, read) if stage.is_between_shafts)
    known = any(stage.part.teeth for stage in crossed)
    leader, ratio = leading_part(rig), abs(prod(stage.turns for stage in crossed))
    motor = motor if motor is not None and turns_with_leader(rig, motor.name) else None
    return Kinematics(
        pole_pairs=None if motor is None else motor.pole_pairs,
        slots=None if motor is None else motor.slots,
        ratio=ratio,
        teeth=tuple(teeth for stage in crossed for teeth in stage.teeth()) if known else (),
        shafts=shafts_of(rig, turns=lambda name: turns_to(rig, name), to_output=ratio),
        input_name="motor" if motor is not None or leader is None else leader,
        has_motor=motor is not None,
    )


def turns_with_leader(rig: Rig, name: str) -> bool:
    """Return whether a part turns at the speed of the driving part."""
    return isclose(turns_to(rig, name), 1.0, rel_tol=1e-9)


def gears_to_sensor(rig: Rig) -> tuple[GearStage, ...]:
    """Return the gears between the driving shaft and the measured part; those of other branches do not count."""
    return gears_to(rig, reading_place(rig))


def gears_to(rig: Rig, last: str) -> tuple[GearStage, ...]:
    """Return the gears between the driving shaft and the part called ``last``, which may be one of them."""
    return tuple(stage.part for stage in stages_to(rig, last))


def stages_to(rig: Rig, last: str) -> tuple[CrossedStage, ...]:
    """Return the stages from the driving shaft to the output of the part ``last``, in this order.

    From the start of the shaft where no shaft leads from the driving part to ``last``.
    """
    leader = leading_part(rig)
    known = {part.name for part in rig.parts}
    first = list(_ancestors(rig, leader)) if leader in known else []
    then = list(_ancestors(rig, last))
    meeting = next((name for name in then if name in first), None)
    if meeting is None:
        first = []
    else:
        first, then = first[: first.index(meeting)], then[: then.index(meeting)]
    back = [CrossedStage(part, backwards=True) for name in first if isinstance(part := rig.part(name), GearStage)]
    forth = [CrossedStage(part) for name in reversed(then) if isinstance(part := rig.part(name), GearStage)]
    return (*back, *forth)


def turns_to(rig: Rig, last: str) -> float:
    """Return the turns of the motor per turn of the output of ``last`` [1], without sign.

    Where ``last`` moves in a line, the motor's angle per travel [rad/m].
    """
    return abs(prod(stage.turns for stage in stages_to(rig, last)))


def shaft_turns_to(rig: Rig, last: str) -> float:
    """Return the turns of the motor per turn of the last shaft on the way to ``last`` [1], without sign."""
    return abs(prod(stage.turns for stage in stages_to(rig, last) if stage.is_between_shafts))


def ratio_text(rig: Rig) -> str:
    """Return the ratio from the driving shaft to the measured place in words: ``5:1``, or ``10 mm per turn``."""
    crossed = stages_to(rig, reading_place(rig))
    if all(stage.is_between_shafts for stage in crossed):
        return f"{rig.run.gear_ratio or 1.0:g}:1"
    return travel_text(abs(prod(stage.turns for stage in crossed)))


def travel_text(turns: float) -> str:
    """Return the travel of a linear drive in words, ``10 mm per turn``, from its angle per travel [rad/m]."""
    return f"{1e3 * 2 * pi / turns:.5g} mm per turn"


def torque_gain(rig: Rig) -> float:
    """Return the steady torque at the measured part per torque of the motor: the gears' ratios times efficiencies."""
    return prod(abs(stage.turns) * stage.efficiency for stage in stages_to(rig, reading_place(rig)))


def _ancestors(rig: Rig, name: str | None) -> Iterator[str]:
    """Yield a part, the part that it is fixed to, and so on to the start of the shaft."""
    while name is not None:
        yield name
        name = rig.part(name).after
