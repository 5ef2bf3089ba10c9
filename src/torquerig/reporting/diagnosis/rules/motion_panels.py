"""Colours, labels and axes that the figures of a rig under measured motion share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE

Floats = NDArray[np.float64]

MEASURED, GRID, HELD_OUT = "#6b7885", "#e3e7eb", "#fff4d6"
BEFORE_LABEL, AFTER_LABEL = "calibrated model", "with findings"


@dataclass(frozen=True, eq=False)
class DrawnModel:
    """One model: the torque or force that it predicts [N m] or [N], with colour and label."""

    effort: Floats
    colour: str
    label: str


def drawn_models(one: MotionCompared) -> tuple[DrawnModel, ...]:
    """Return the calibrated model and, if there are findings, the model with them."""
    before = DrawnModel(one.before, BEFORE, BEFORE_LABEL)
    return (before,) if one.alone else (before, DrawnModel(one.after, AFTER, AFTER_LABEL))


def effort_name(scale: Scale) -> str:
    """Return ``force`` for a rig that moves in a line, else ``torque``."""
    return "force" if scale.effort == "N" else "torque"


def label_panels(above: Axes, below: Axes, *, across: str, scale: Scale) -> None:
    """Label a pair of panels: torque or force above, residual below."""
    above.set_ylabel(f"{effort_name(scale)} [{scale.effort}]")
    below.set_ylabel(f"residual [{scale.effort}]")
    below.set_xlabel(across)
    below.axhline(0, color=MEASURED, linewidth=0.8, zorder=0)
    above.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    for axes in (above, below):
        axes.grid(color=GRID, linewidth=0.6)
