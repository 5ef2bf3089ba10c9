"""What a found line is: the causes that have its order, or a multiple of the mains."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine

_ORDER_SLACK = 2e-4  # share by which the angle's scale may be off
_MAINS_SLACK = 1e-3  # share by which a grid runs off its frequency
HIGHEST_MAINS_MULTIPLE = 40


def causes_of(order: float, lines: Sequence[KinematicLine], *, width: float) -> tuple[KinematicLine, ...]:
    """Return the kinematic lines at an order of the output shaft, the lowest harmonics first.

    Parameters
    ----------
    order : float
        [1/rev] of the output shaft.
    width : float
        Of a bin [1/rev]; a line counts as the same within it.
    """
    near = [line for line in lines if abs(line.output_order - order) <= width + _ORDER_SLACK * order]
    return tuple(sorted(near, key=lambda line: (line.harmonic, line.family)))


def mains_multiple(frequency: float, *, mains: float, width: float) -> int | None:
    """Return of how many times the mains a frequency [Hz] is, or None where it is none."""
    multiple = round(frequency / mains)
    if not 1 <= multiple <= HIGHEST_MAINS_MULTIPLE:
        return None
    return multiple if abs(frequency - multiple * mains) <= width + _MAINS_SLACK * frequency else None


def label_of(causes: Sequence[KinematicLine]) -> str:
    """Return the names of causes for a table or a picture: ``gear mesh = slots times pole pairs``; empty for none."""
    return " = ".join(dict.fromkeys(f"{one.family.replace('_', ' ')} x{one.harmonic}" for one in causes))
