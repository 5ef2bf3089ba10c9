"""Reductions from the highest partial frequency downwards, until none is left above a limit."""

from __future__ import annotations

from torquerig.simulation.condensation.partial_systems import (
    ShaftLine,
    small_masses,
    stiff_springs,
    without_mass,
    without_spring,
)


def reduced(line: ShaftLine, limit: float) -> ShaftLine:
    """Return the line without the small masses and stiff springs whose partial frequency is above ``limit`` [rad/s].

    A partial system of high frequency follows the others without delay (Rivin 1999, section 6). Small masses go first,
    which keeps the static flexibility exactly; a stiff spring only where no small mass next to it may go.
    """
    while True:
        if small := [step for step in small_masses(line) if step.frequency > limit]:
            line = without_mass(line, max(small))
        elif stiff := [step for step in stiff_springs(line) if step.frequency > limit]:
            line = without_spring(line, max(stiff))
        else:
            return line
