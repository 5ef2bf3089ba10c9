"""The pictures of a diagnosis under measured motion with their captions, and words for what is not drawn."""

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
from torquerig.reporting.diagnosis.motion_course_figure import MOST, motion_course_figure
from torquerig.reporting.diagnosis.motion_lines_figure import motion_lines_figure
from torquerig.reporting.diagnosis.motion_place_figure import motion_place_figure
from torquerig.reporting.diagnosis.motion_speed_figure import motion_speed_figure
from torquerig.reporting.diagnosis.motion_window_figure import motion_window_figure
from torquerig.reporting.figures.picture import Picture, picture

_FEW = (
    "No spectrum of what is left: too little of the held-out part moves at even speed, or too short a way, for lines "
    "to be told apart."
)


def motion_pictures(
    outcome: MotionOutcome, runs: Sequence[MotionCompared]
) -> tuple[tuple[Picture, ...], tuple[str, ...]]:
    """Return all pictures, and a sentence for each that would show nothing."""
    if not runs:
        return (), ("No pictures: none of the recordings was held out.",)
    scale, shown = scale_of(outcome), most_gained(runs)
    drawn = [_window(shown, scale), _place(shown, scale)]
    not_drawn = []
    if speed_matters(outcome):
        drawn.append(_speed(runs, shown, scale))
    else:
        not_drawn.append("No effort over speed: nothing that was found, or is left, goes with the speed.")
    lines = lines_compared(outcome)
    if lines:
        drawn.append(
            picture(
                motion_lines_figure(lines, scale=scale),
                caption="Lines in what the models leave of the held-out part at even speed, over the place and in "
                "frequency: each stem is a line that chance would not make, zero to peak; the curve is the spectrum "
                "with these taken out.",
                told="stems of the lines left by the models, before and after, over place and frequency",
            )
        )
    else:
        not_drawn.append(_FEW)
    return (*drawn, _course(runs, scale)), tuple(not_drawn)


def _window(shown: MotionCompared, scale: Scale) -> Picture:
    return picture(
        motion_window_figure(shown, scale=scale),
        caption=f"Part of {shown.run.name} that no fit has seen, sample by sample: the measured effort and what the "
        "models take for the same motion; below, what they leave of it.",
        told="effort over time, recording and model before and after, and the residuals",
    )


def _place(shown: MotionCompared, scale: Scale) -> Picture:
    return picture(
        motion_place_figure(shown, scale=scale),
        caption=f"All held-out stretches of {shown.run.name} over the place: above the effort, below what the models "
        "leave of it.",
        told="effort and residuals over the place, recording and model before and after",
    )


def _speed(runs: Sequence[MotionCompared], shown: MotionCompared, scale: Scale) -> Picture:
    found = "" if shown.alone else ", and what was found puts in its place"
    return picture(
        motion_speed_figure(shown, level_over_speed(runs), scale=scale),
        caption=f"Held-out effort over the speed. Left, what the calibrated model leaves of {shown.run.name}{found}; "
        "right, what the models leave on average over all runs, in bins of equally many samples. Grey: 3 % of the "
        "effort, which nobody models.",
        told="residual effort over speed with what was found, and mean residuals by speed before and after",
    )


def _course(runs: Sequence[MotionCompared], scale: Scale) -> Picture:
    which = "" if len(runs) <= MOST else f" of the first {MOST} runs of {len(runs)}"
    return picture(
        motion_course_figure(runs, scale=scale),
        caption=f"What the models leave over time{which}, on the shaded stretches, which no fit has seen; behind, the "
        "measured effort.",
        told="residuals over time of each run, before and after",
    )
