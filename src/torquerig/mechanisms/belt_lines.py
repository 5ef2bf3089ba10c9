"""Belt lines: the belt's turn, its teeth and pulleys that run out."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.orders.kinematics.belt import Belt
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import HostChange, KinematicError
from torquerig.rig.parts import BeltStage
from torquerig.rig.parts.gear_stage import gear_stage
from torquerig.rig.terms import Term, Wave

Radians = Annotated[float, Parameter("rad", "zero-to-peak error at the output", low=0)]


@dataclass(frozen=True, kw_only=True)
class BeltLines(Part):
    """``e(theta) = sum A cos(order theta + phi)`` in a belt stage, theta and orders of its output shaft.

    Orders: belt pass ``z_wheel / z_belt`` and multiples (below both shafts: a belt is longer than its wheel's rim),
    teeth ``z_wheel``, output pulley 1, input pulley ``z_wheel / z_pinion``. The counts are those of a belt stage; state
    them where ``gear`` is a plain gear. A pulley whose centre is off by x (``wheel_eccentricity``,
    ``pinion_eccentricity``, in a belt stage) runs out by x / r, r the radius of the output pulley; the other errors
    are measured ones. Source: signatures.md 3.7; ISO 5296 for belts and pitches. Not valid where the tension is so low
    that teeth jump or the strand swings.
    """

    kind: Literal["belt_lines"] = "belt_lines"
    group: Literal["mechanical"] = "mechanical"
    gear: str = "gearbox"
    pinion: int | None = None
    wheel: int | None = None
    belt_teeth: int | None = None
    belt_error: tuple[Radians, ...] = ()
    tooth_error: Radians = 0.0
    wheel_runout: Radians = 0.0
    pinion_runout: Radians = 0.0
    wheel_eccentricity: Annotated[float, Parameter("m", "output pulley's centre off its axis", low=0)] = 0.0
    pinion_eccentricity: Annotated[float, Parameter("m", "input pulley's centre off its axis", low=0)] = 0.0

    def __post_init__(self) -> None:
        stated = (self.pinion, self.wheel, self.belt_teeth)
        if any(count is not None for count in stated) and None in stated:
            raise ValueError("pinion, wheel and belt_teeth belong together; write all three, or none for a belt stage")
        try:
            self._stated()
        except InputError as error:
            raise ValueError(str(error)) from None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the stage carries the error; InputError where the stage cannot have it."""
        stage = gear_stage(rig, self.gear, owner=self.name)
        belt = self.belt(rig)
        if self.tooth_error and not belt.toothed:
            raise InputError(f"{self.name}: {self.gear} is a smooth belt; leave tooth_error out")
        if (self.wheel_eccentricity or self.pinion_eccentricity) and not isinstance(stage, BeltStage):
            raise InputError(f"{self.name}: {self.gear} states no radius; write a runout in rad, or make it a belt")
        return ()

    def belt(self, rig: Rig) -> Belt:
        """Return pulleys and belt: as stated here, else those of the belt stage."""
        stage = gear_stage(rig, self.gear, owner=self.name)
        stated = self._stated()
        if not isinstance(stage, BeltStage):
            if stated is None:
                raise InputError(f"{self.name}: {self.gear} is no belt; write pinion, wheel and belt_teeth")
            return stated
        if stated is not None and stated != stage.geometry():
            raise InputError(
                f"{self.name}: {stated.spoken} is not the {stage.geometry().spoken} of {self.gear}; keep one"
            )
        return stage.geometry()

    def lines(self, belt: Belt, radius: float = inf) -> tuple[tuple[str, float, float], ...]:
        """Return cause, order on the output shaft and amplitude [rad] of each line that is not zero.

        Parameters
        ----------
        belt : Belt
        radius : float
            Of the output pulley [m], for eccentricities.
        """
        named = [
            *((f"belt {k}", k * belt.belt_order_out, error) for k, error in enumerate(self.belt_error, start=1)),
            ("teeth", belt.mesh_order_out, self.tooth_error),
            ("wheel", 1.0, self.wheel_runout + self.wheel_eccentricity / radius),
            ("pinion", belt.ratio, self.pinion_runout + self.pinion_eccentricity / radius),
        ]
        return tuple(line for line in named if line[2] > 0)

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the kinematic error of the stage."""
        stage = gear_stage(rig, self.gear, owner=self.name)
        radius = stage.wheel_radius if isinstance(stage, BeltStage) else inf
        waves = (
            Wave(order=order, amplitude=error, phase_key=f"{self.name}.{cause}")
            for cause, order, error in self.lines(self.belt(rig), radius)
        )
        return (KinematicError(tuple(waves)),)

    def _stated(self) -> Belt | None:
        if self.pinion is None or self.wheel is None or self.belt_teeth is None:
            return None
        return Belt(self.pinion, self.wheel, self.belt_teeth)
