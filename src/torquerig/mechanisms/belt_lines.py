"""Belt lines: the belt's turn, its teeth and pulleys that run out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.part import Part
from torquerig.rig.parts.gear_stage import gear_stage
from torquerig.rig.rig import Rig
from torquerig.rig.terms import Term, Wave

Radians = Annotated[float, Parameter("rad", "zero-to-peak error at the output", low=0)]


@dataclass(frozen=True, kw_only=True)
class BeltLines(Part):
    """``e(theta) = sum A cos(order theta + phi)`` in a belt stage, theta and orders of its output shaft.

    Orders: belt pass ``z_wheel / z_belt`` and multiples (below both shafts: a belt is longer than its wheel's rim),
    teeth ``z_wheel``, output pulley 1, input pulley ``z_wheel / z_pinion``. A pulley whose centre is off by x runs out
    by x / r on its pitch radius r, at the output. Source: signatures.md 3.7; ISO 5296 for belts and pitches. Not true
    where the tension is so low that teeth jump or the strand swings.
    """

    kind: Literal["belt_lines"] = "belt_lines"
    group: Literal["mechanical"] = "mechanical"
    gear: str = "gearbox"
    pinion: int
    wheel: int
    belt_teeth: int
    belt_error: tuple[Radians, ...] = ()
    tooth_error: Radians = 0.0
    wheel_runout: Radians = 0.0
    pinion_runout: Radians = 0.0

    def __post_init__(self) -> None:
        if self.pinion < 1 or self.wheel < 1 or 2 * self.belt_teeth <= self.pinion + self.wheel:
            raise ValueError(
                f"a belt of {self.belt_teeth} teeth does not go round pulleys of {self.pinion} and {self.wheel}; "
                "it needs more than half of both together"
            )

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the stage carries the error; InputError where ``gear`` is none."""
        gear_stage(rig, self.gear, owner=self.name)
        return ()

    def lines(self) -> tuple[tuple[str, float, float], ...]:
        """Return cause, order on the output shaft and amplitude [rad] of each line that is not zero."""
        belt = self.wheel / self.belt_teeth
        named = [
            *((f"belt {k}", k * belt, error) for k, error in enumerate(self.belt_error, start=1)),
            ("teeth", float(self.wheel), self.tooth_error),
            ("wheel", 1.0, self.wheel_runout),
            ("pinion", self.wheel / self.pinion, self.pinion_runout),
        ]
        return tuple(line for line in named if line[2] > 0)

    def kinematic_error(self, gear: str, rig: Rig) -> tuple[Wave, ...]:
        """Return the error waves if ``gear`` is the stage it lives in."""
        if gear != self.gear:
            return ()
        return tuple(
            Wave(order=order, amplitude=error, phase_key=f"{self.name}.{cause}") for cause, order, error in self.lines()
        )
