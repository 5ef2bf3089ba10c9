"""Lines of a rig above half the sample rate, and where they appear below it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine


def appears_at(frequency: float, rate: float) -> float:
    """Return the frequency [Hz] at which a line appears when it is sampled at ``rate`` [Hz]."""
    return abs(frequency - rate * round(frequency / rate))


def alias_of(
    frequency: float, lines: Sequence[KinematicLine], *, turns_per_second: float, rate: float, width: float
) -> KinematicLine | None:
    """Return the rig's line above half the rate that would appear at ``frequency``, or None.

    Parameters
    ----------
    frequency : float
        Of the line in the recording [Hz].
    lines : sequence of KinematicLine
        The lines that the rig can have.
    turns_per_second : float
        Of the output shaft [1/s].
    rate : float
        [Hz].
    width : float
        Largest distance [Hz] at which two frequencies count as the same.

    Such a line is in the recording only if no low-pass kept it out; the recording cannot decide. Of several lines the
    lowest harmonic is returned.
    """
    above = [line for line in lines if line.output_order * turns_per_second > rate / 2 and not line.cancelled]
    near = [one for one in above if abs(appears_at(one.output_order * turns_per_second, rate) - frequency) <= width]
    return min(near, key=lambda line: (line.harmonic, line.output_order), default=None)
