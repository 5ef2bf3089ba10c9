"""The gap that a scenario itself states in a gear: no missing physics, but of a width that recordings tell anew."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi
from typing import TYPE_CHECKING

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Gear
from torquerig.scenario.kinematics import gears_to_sensor

if TYPE_CHECKING:
    from torquerig.mechanisms import Backlash

_ARCMIN = pi / 180 / 60


@dataclass(frozen=True)
class OwnGap:
    """The gap of the last gear before the sensor.

    Parameters
    ----------
    gear : str
    stated : float
        At the gear's output [rad].
    part : Backlash or None
        The part of the scenario that holds it, where the gear itself does not.
    """

    gear: str
    stated: float
    part: Backlash | None = None

    def told(self, rig: Rig) -> float | None:
        """Return the width that a search found in a rig [rad], or None where it found none."""
        found = self._found(rig)
        return None if found is None else found.gap

    def reopened(self, rig: Rig, *, width: float | None = None) -> Rig:
        """Return a closed rig with its gap where the scenario has it: ``width`` [rad], else as found, or as stated."""
        found = self._found(rig)
        if found is not None:
            rig = rig.without(found.name)
            width = found.gap if width is None else width
        width = self.stated if width is None else width
        if self.part is not None:
            return rig + replace(self.part, gap=width)
        gear = rig.part(self.gear)
        assert isinstance(gear, Gear)
        return rig.changed(replace(gear, backlash=width))

    def sentence(self, rig: Rig) -> str:
        """Say how wide the gap is where a search found it."""
        width = self.told(rig)
        assert width is not None
        said = f"The stated backlash of {self.gear}, {self.stated / _ARCMIN:.1f} arcmin, causes contact loss here."
        if width == self.stated:
            return f"{said} The recordings do not determine another width."
        return f"{said} Its estimated width is about {width / _ARCMIN:.1f} arcmin."

    def _found(self, rig: Rig) -> Backlash | None:
        return next((part for part in rig.of_kind("backlash") if part.gear == self.gear), None)


def closed(rig: Rig) -> tuple[Rig, OwnGap | None]:
    """Return the rig with the gap of its last gear before the sensor closed, and that gap; None where it has none.

    A linear twin has no gap anyway; a search then finds it, where flanks part in the recordings, as it finds any other.
    """
    gears = gears_to_sensor(rig)
    if not gears:
        return rig, None
    gear = gears[-1]
    for part in rig.of_kind("backlash"):
        if part.gear == gear.name and part.gap > 0:
            return rig.without(part.name), OwnGap(gear.name, part.gap, part)
    if not isinstance(gear, Gear) or gear.backlash <= 0:
        return rig, None
    return rig.changed(replace(gear, backlash=0.0)), OwnGap(gear.name, gear.backlash)
