"""Names of a detected line: the causes of its order, or a multiple of the mains."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
    from torquerig.orders.kinematics.shafts import OpenMesh

_ORDER_TOLERANCE = 2e-4  # relative error of the angle's scale [1]
_MAINS_TOLERANCE = 1e-3  # relative deviation of the mains from its nominal frequency [1]
HIGHEST_MAINS_MULTIPLE = 40
_TURNS = ("shaft", "motor", "intermediate")  # families of a shaft's own turn
_BY_ACCIDENT = 0.1  # [1] largest share of all orders that may count as whole: more would name nearly everything


@dataclass(frozen=True, kw_only=True)
class LineNames:
    """Names the orders and frequencies of one recording.

    Parameters
    ----------
    kinematics : Kinematics
        The shafts of the rig.
    lines : tuple of KinematicLine
        The lines that the rig can have.
    turned : float
        Turns of the output shaft in the recording, which determine the width of a bin.
    mains : float
        Frequency of the grid [Hz].
    """

    kinematics: Kinematics
    lines: tuple[KinematicLine, ...]
    turned: float
    mains: float

    @property
    def width(self) -> float:
        """Distance within which two orders of the output shaft count as the same [1/rev]."""
        return 1.5 / self.turned

    def causes(self, order: float) -> tuple[KinematicLine, ...]:
        """Return the kinematic lines at an order of the output shaft [1/rev]."""
        return causes_of(order, self.lines, width=self.width)

    def is_an_order(self, order: float) -> bool:
        """Return whether an order of the output shaft [1/rev] is that of a known line, or whole on a shaft."""
        return bool(self.causes(order)) or bool(self.whole_on(order))

    def whole_on(self, order: float) -> tuple[tuple[str, int], ...]:
        """Return the shafts on which an order of the output shaft [1/rev] is a whole number, and this number."""
        near = self.width + _ORDER_TOLERANCE * order
        found = []
        for name, turns in self.kinematics.shaft_turns.items():
            whole = round(order / turns)
            if whole >= 1 and 2 * near <= _BY_ACCIDENT * turns and abs(whole * turns - order) <= near:
                found.append((name, whole))
        return tuple(found)

    def of_order(self, order: float, causes: Sequence[KinematicLine]) -> str:
        """Return the causes of an order of the output shaft [1/rev], and the mesh that it may be; empty for none.

        A line without a known cause keeps none: any whole order could be a mesh of unknown teeth. The lowest turns of
        a shaft are no mesh: their whole orders are fewer than a gear's teeth on the faster shafts.
        """
        is_turn = all(one.family in _TURNS for one in causes)
        mesh = "" if is_turn else possible_mesh(order, self.kinematics.open_meshes, width=self.width)
        return " or ".join(word for word in (label_of(causes), mesh) if word)

    def of_mains(self, frequency: float, *, width: float) -> str:
        """Return the multiple of the mains that a frequency [Hz] is; empty for none."""
        multiple = mains_multiple(frequency, mains=self.mains, width=width)
        return f"{multiple} x mains" if multiple else ""


def causes_of(order: float, lines: Sequence[KinematicLine], *, width: float) -> tuple[KinematicLine, ...]:
    """Return the kinematic lines at an order of the output shaft, the lowest harmonics first.

    Parameters
    ----------
    order : float
        [1/rev] of the output shaft.
    width : float
        Bin width [1/rev], within which two lines count as the same.
    """
    near = [line for line in lines if abs(line.output_order - order) <= width + _ORDER_TOLERANCE * order]
    return tuple(sorted(near, key=lambda line: (line.harmonic, line.family)))


def mains_multiple(frequency: float, *, mains: float, width: float) -> int | None:
    """Return the multiple of the mains that a frequency [Hz] is, or None where it is none."""
    multiple = round(frequency / mains)
    if not 1 <= multiple <= HIGHEST_MAINS_MULTIPLE:
        return None
    return multiple if abs(frequency - multiple * mains) <= width + _MAINS_TOLERANCE * frequency else None


def label_of(causes: Sequence[KinematicLine]) -> str:
    """Return the names of causes for a table or a picture: ``gear mesh x1 = cogging x2``; empty for none."""
    return " = ".join(dict.fromkeys(f"{one.label} x{one.harmonic}" for one in causes))


def possible_mesh(order: float, meshes: Sequence[OpenMesh], *, width: float) -> str:
    """Return the mesh that a line may be where the teeth of a gear are not known; empty where none is possible.

    Parameters
    ----------
    order : float
        [1/rev] of the output shaft.
    meshes : sequence of OpenMesh
        The gears with unknown teeth.
    width : float
        Bin width [1/rev], within which two lines count as the same.
    """
    near = width + _ORDER_TOLERANCE * order
    found = (mesh.teeth_at(order, width=near) for mesh in meshes)
    teeth = sorted({one for one in found if one is not None})
    return f"mesh with {' or '.join(map(str, teeth))} teeth" if teeth else ""
