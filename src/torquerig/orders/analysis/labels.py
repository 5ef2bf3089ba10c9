"""Names of a detected line: the causes of its order, or a multiple of the mains."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine

_ORDER_TOLERANCE = 2e-4  # relative error of the angle's scale [1]
_MAINS_TOLERANCE = 1e-3  # relative deviation of the mains from its nominal frequency [1]
HIGHEST_MAINS_MULTIPLE = 40


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
    return " = ".join(dict.fromkeys(f"{one.family.replace('_', ' ')} x{one.harmonic}" for one in causes))
