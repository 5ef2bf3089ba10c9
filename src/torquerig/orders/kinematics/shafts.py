"""The shafts of a drive: how fast each turns, which lines start on it, and which gears on it have unknown teeth."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.orders.kinematics.line_families import Family
    from torquerig.orders.kinematics.teeth import Teeth

# a pinion of fewer teeth is undercut even with profile shift (ISO 53 rack, 20 degrees); lower whole orders are turns
LEAST_TEETH = 7


@dataclass(frozen=True, kw_only=True)
class LineSource:
    """A fundamental line that starts on a shaft.

    Parameters
    ----------
    family : Family
        The kind of its cause.
    order : float
        Periods per turn of its shaft [1/rev].
    motor_order, output_order : float
        The same per turn of the motor and of the output shaft [1/rev].
    name : str
        Its cause in a label, such as ``belt mesh``.
    cause : str
        Its cause in a sentence.
    stage : Teeth or None
        Of a gear mesh: the stage, which determines the harmonics that planets cancel.
    at : str
        Of a motor's line: the motor; else empty.
    """

    family: Family
    order: float
    motor_order: float
    output_order: float
    name: str
    cause: str
    stage: Teeth | None = None
    at: str = ""


@dataclass(frozen=True, kw_only=True)
class Shaft:
    """What turns at one speed.

    Parameters
    ----------
    name : str
        ``motor``, the part whose motion is imposed, or the gear whose output it is.
    ratio : float
        Motor turns per turn of the shaft [1], > 0; without a motor those of the part whose motion is imposed.
    parts : tuple of str
        What is fixed to it, in order.
    sources : tuple of LineSource
        Lines that start on it, but for those of its own turn and of the driving motor's poles and slots.
    open_gears : tuple of str
        Gears that mesh on it and whose teeth are not known.
    missing : mapping of Family to str
        Lines of further motors on it that unknown poles or slots leave out, each with the reason.
    """

    name: str
    ratio: float
    parts: tuple[str, ...] = ()
    sources: tuple[LineSource, ...] = ()
    open_gears: tuple[str, ...] = ()
    missing: Mapping[Family, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class OpenMesh:
    """A gear whose teeth are not known, seen from one of its shafts.

    Parameters
    ----------
    shaft : str
    turns : float
        Turns of the shaft per turn of the output shaft [1].
    teeth : tuple of float
        The mesh orders that are possible on the shaft [1/rev]; empty where any whole number is.
    """

    shaft: str
    turns: float
    teeth: tuple[float, ...] = ()

    def teeth_at(self, output_order: float, *, width: float) -> int | None:
        """Return the teeth whose mesh is at an order of the output shaft, or None where no mesh can be there.

        Parameters
        ----------
        output_order : float
            [1/rev].
        width : float
            Distance [1/rev] of the output shaft within which two lines count as the same.
        """
        order = output_order / self.turns
        if self.teeth:
            near = min(self.teeth, key=lambda one: abs(one - order))
            return round(near) if abs(near - order) * self.turns <= width else None
        whole = round(order)
        return whole if whole >= LEAST_TEETH and abs(whole - order) * self.turns <= width else None
