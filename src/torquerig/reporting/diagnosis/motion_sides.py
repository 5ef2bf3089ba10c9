"""Both models of a run under measured motion, as each picture draws them, and what their panels have in common."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.reporting.diagnosis.spectrum_figure import AFTER, BEFORE

Floats = NDArray[np.float64]

MEASURED, GRID, HELD = "#6b7885", "#e3e7eb", "#fff4d6"
BEFORE_LABEL, AFTER_LABEL = "calibrated model", "with what was found"


@dataclass(frozen=True, eq=False)
class DrawnSide:
    """One model: what it foretells of the effort, and how it is drawn."""

    effort: Floats
    colour: str
    label: str


def sides(one: MotionCompared) -> tuple[DrawnSide, ...]:
    """Return the calibrated model, and the one with what was found where something was."""
    before = DrawnSide(one.before, BEFORE, BEFORE_LABEL)
    return (before,) if one.alone else (before, DrawnSide(one.after, AFTER, AFTER_LABEL))


def finished(above: Axes, below: Axes, *, across: str, scale: Scale) -> None:
    """Label a pair of panels, the effort above and what is left of it below."""
    above.set_ylabel(f"effort [{scale.effort}]")
    below.set_ylabel(f"left of it [{scale.effort}]")
    below.set_xlabel(across)
    below.axhline(0, color=MEASURED, linewidth=0.8, zorder=0)
    above.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    for axes in (above, below):
        axes.grid(color=GRID, linewidth=0.6)
