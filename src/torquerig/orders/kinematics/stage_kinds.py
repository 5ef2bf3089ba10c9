"""Stages of a chain beyond sets of teeth: one without known teeth, and one that is driven from its output."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.orders.kinematics.teeth import Teeth


@dataclass(frozen=True)
class Untoothed:
    """A stage that has a ratio and no known teeth: a gearbox without tooth counts, a smooth belt.

    Parameters
    ----------
    ratio : float
        Turns of the input per turn of the output, without sign [1], > 0.
    """

    ratio: float


@dataclass(frozen=True)
class DrivenBackwards:
    """A set of teeth whose stated output turns first on the way from the motor, as in a speed-increasing gear.

    Parameters
    ----------
    stage : Planetary, Spur, Belt or Worm
        The set as the part states it.
    """

    stage: Teeth

    @property
    def ratio(self) -> float:
        """Turns of the first shaft per turn of the second, without sign [1]."""
        return 1 / self.stage.ratio

    @property
    def mesh_order_in(self) -> float:
        """Mesh periods per turn of the first shaft [1/rev]."""
        return self.stage.mesh_order_out

    @property
    def mesh_order_out(self) -> float:
        """Mesh periods per turn of the second shaft [1/rev]."""
        return self.stage.mesh_order_in

    @property
    def spoken(self) -> str:
        """The stage in words."""
        return f"{self.stage.spoken}, driven from its output"


Toothed = Teeth | DrivenBackwards
ChainStage = Toothed | Untoothed
"""One stage on the way from the motor to the output."""


def set_of_teeth(stage: Toothed) -> Teeth:
    """Return the set of teeth as its part states it."""
    return stage.stage if isinstance(stage, DrivenBackwards) else stage


def untoothed(stages: tuple[ChainStage, ...]) -> tuple[Untoothed, ...]:
    """Return the stages without known teeth."""
    return tuple(stage for stage in stages if isinstance(stage, Untoothed))
