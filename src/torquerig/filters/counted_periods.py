"""Which lines have enough periods in a recording to be separated from its load and its mean."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from torquerig.errors import RecordingError
from torquerig.orders.analysis.line_fit import FEWEST_PERIODS

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine


def separable_lines(lines: Sequence[KinematicLine], motor_turns: float, *, name: str) -> tuple[KinematicLine, ...]:
    """Return the lines with two periods or more in ``motor_turns`` [rev] of the recording ``name``.

    A sine of fewer periods has no mean of zero over the recording, and a fit of it takes slow load and mean along.

    Raises
    ------
    RecordingError
        Where no line has two periods; it states the turns that the recording needs.
    """
    kept = tuple(line for line in lines if line.motor_order * motor_turns >= FEWEST_PERIODS)
    if lines and not kept:
        highest = max(line.motor_order for line in lines)
        raise RecordingError(
            f"{name}: the motor turns {motor_turns:.3g} times, and a line needs {FEWEST_PERIODS:g} periods to be "
            f"separated from the load: {FEWEST_PERIODS / highest:.3g} motor turns or more for the highest of these "
            "lines; take a longer recording"
        )
    return kept


def few_periods_text(lines: Sequence[KinematicLine], motor_turns: float | None, *, ratio: float) -> str:
    """Return a sentence that names the lines with fewer than two periods; empty where there are none.

    Parameters
    ----------
    lines : sequence of KinematicLine
        Those of a filter chain.
    motor_turns : float or None
        Turns of the motor in the recording [rev]; None where they are not known.
    ratio : float
        Motor turns per output turn [1].
    """
    if motor_turns is None:
        return ""
    few = [line for line in lines if line.motor_order * motor_turns < FEWEST_PERIODS]
    if not few:
        return ""
    slowest = min(line.motor_order for line in few)
    named = ", ".join(dict.fromkeys(f"{line.label} x{line.harmonic}" for line in few))
    return (
        f"in {motor_turns:.3g} turns of the motor ({motor_turns / ratio:.3g} of the output shaft) these lines have "
        f"fewer than {FEWEST_PERIODS:g} periods and cannot be separated from the load: {named}; a recording of "
        f"{FEWEST_PERIODS / slowest:.3g} motor turns would do"
    )
