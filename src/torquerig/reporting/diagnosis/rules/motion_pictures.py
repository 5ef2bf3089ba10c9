"""The pictures of a diagnosis under measured motion with captions, and reasons for omitted ones."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.showing.motion_comparison import (
    MotionCompared,
    Scale,
    most_gained,
    scale_of,
    speed_matters,
)
from torquerig.diagnosis.showing.motion_curves import level_over_speed
from torquerig.diagnosis.showing.motion_lines import lines_compared
from torquerig.reporting.diagnosis.rules.motion_lines_figure import motion_lines_figure
from torquerig.reporting.diagnosis.rules.motion_panels import effort_name
from torquerig.reporting.diagnosis.rules.motion_position_figure import motion_position_figure
from torquerig.reporting.diagnosis.rules.motion_residual_figure import MOST, motion_residual_figure
from torquerig.reporting.diagnosis.rules.motion_speed_figure import motion_speed_figure
from torquerig.reporting.diagnosis.rules.motion_window_figure import motion_window_figure
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture

_FEW = (
    "No spectrum of the residual. The held-out motion at constant speed is too short in time or travel to resolve "
    "spectral lines."
)


def motion_pictures(
    outcome: MotionOutcome, runs: Sequence[MotionCompared]
) -> tuple[tuple[Picture, ...], tuple[str, ...]]:
    """Return all pictures, and a sentence for each omitted picture."""
    if not runs:
        return (), ("No pictures: no recording has held-out data.",)
    scale, shown = scale_of(outcome), most_gained(runs)
    drawn = [_window(shown, scale), _position(shown, scale)]
    omitted = []
    if speed_matters(outcome):
        drawn.append(_speed(runs, shown, scale))
    else:
        omitted.append("No figure over speed: no finding and no residual depends on the speed.")
    lines = lines_compared(outcome)
    if lines:
        drawn.append(
            picture(
                motion_lines_figure(lines, scale=scale),
                caption="Spectral lines in the held-out residuals at constant speed, over position and in frequency. "
                "Stems: significant lines, zero to peak. Curve: spectrum without these lines.",
                alt_text="stems of lines in the residuals of the models, before and after, over position and frequency",
            )
        )
    else:
        omitted.append(_FEW)
    return (*drawn, _residuals(runs, scale)), tuple(omitted)


def _window(shown: MotionCompared, scale: Scale) -> Picture:
    return picture(
        motion_window_figure(shown, scale=scale),
        caption=f"Held-out part of {shown.run.name}, sample by sample. Top: {effort_name(scale)} measured and "
        "predicted for the same motion. Bottom: residuals.",
        alt_text=f"{effort_name(scale)} over time, recording and model before and after, and the residuals",
    )


def _position(shown: MotionCompared, scale: Scale) -> Picture:
    return picture(
        motion_position_figure(shown, scale=scale),
        caption=f"All held-out stretches of {shown.run.name} over the position. Top: {effort_name(scale)}. Bottom: "
        "residuals.",
        alt_text=f"{effort_name(scale)} and residuals over the position, recording and model before and after",
    )


def _speed(runs: Sequence[MotionCompared], shown: MotionCompared, scale: Scale) -> Picture:
    found = "" if shown.alone else " and the effect of the findings"
    return picture(
        motion_speed_figure(shown, level_over_speed(runs), scale=scale),
        caption=f"Held-out {effort_name(scale)} over the speed. Left: residual of the calibrated model in "
        f"{shown.run.name}{found}. Right: mean residuals of all runs, in bins of equal sample count. Grey: tolerance "
        f"of 3 % of the {effort_name(scale)}.",
        alt_text="residuals over speed with the effect of the findings, and mean residuals by speed before and after",
    )


def _residuals(runs: Sequence[MotionCompared], scale: Scale) -> Picture:
    which = "" if len(runs) <= MOST else f" of the first {MOST} runs of {len(runs)}"
    return picture(
        motion_residual_figure(runs, scale=scale),
        caption=f"Residuals over time{which}. Shaded: held-out stretches. Background: measured {effort_name(scale)}.",
        alt_text="residuals over time of each run, before and after",
    )
