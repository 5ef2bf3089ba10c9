"""The pictures of a diagnosis with their captions, and what they show in words."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import Mismatch
from torquerig.diagnosis.showing.comparison import Compared, most_telling
from torquerig.reporting.diagnosis.causes import causes
from torquerig.reporting.diagnosis.course_figure import diagnosis_course_figure
from torquerig.reporting.diagnosis.places_figure import MOST, diagnosis_places_figure, to_be_seen
from torquerig.reporting.diagnosis.residual_figure import diagnosis_residual_figure, residuals_to_show
from torquerig.reporting.diagnosis.spectrum_figure import diagnosis_spectrum_figure
from torquerig.reporting.diagnosis.window_figure import diagnosis_window_figure
from torquerig.reporting.figures.picture import Picture, picture
from torquerig.scenario.kinematics import kinematics_of


def places_picture(listed: Sequence[Mismatch]) -> Picture | None:
    """Return where the misfit is, or None where there is no mismatch, or none that has a share of the misfit."""
    if not to_be_seen(listed):
        return None
    which = "Each place" if len(listed) <= MOST else f"The {MOST} largest of {len(listed)} places"
    return picture(
        diagnosis_places_figure(listed),
        caption=f"{which} where recordings and calibrated model differ, by its share of the misfit.",
        told="bars of the shares of the misfit by place, largest first",
    )


def course_picture(runs: Sequence[Compared]) -> Picture:
    """Return the slow torque of the runs."""
    return picture(
        diagnosis_course_figure(runs),
        caption="Slow torque over time. Only the shaded stretches count here: no fit has seen them. Where a run turns "
        "back, the models are simulated; elsewhere their level is drawn, for the load's own wander is random.",
        told="torque over time of each run, with the level that the model expects before and after",
    )


def telling_pictures(outcome: Outcome, runs: Sequence[Compared]) -> tuple[Picture, ...]:
    """Return window, order spectrum and residuals: of the run that shows most, and of a run that turns back."""
    shown, turning = most_telling(runs), [one for one in runs if one.held.turning is not None]
    ratio = kinematics_of(outcome.completed).ratio
    pictures = []
    if shown is not None:
        name = shown.held.observed.name
        pictures.append(
            picture(
                diagnosis_window_figure(shown, ratio=ratio),
                caption=f"A window of {name} that no fit has seen. The models' lines have the recording's phases, "
                "which only say where the rig happened to start; their sizes are predicted.",
                told="recording and the lines of the model before and after over a short time",
            )
        )
        marked = causes(outcome, shown)
        pictures.append(
            picture(
                diagnosis_spectrum_figure(shown, marked, ratio=ratio),
                caption=f"Held-out part of {name} over the orders of the output shaft, beside simulations of the model "
                "before and after. Grey labels: lines that the model had; red: found missing; brown: unexplained.",
                told="amplitude over order, recording and model, lines labelled by cause",
            )
        )
    if residuals_to_show(shown, turning):
        pictures.append(
            picture(
                diagnosis_residual_figure(shown, turning),
                caption="What the models leave of the held-out part: the spectrum beside the lines, each line, and the "
                "slow torque of a run that turns back. Grey is what chance leaves of a true model.",
                told="residuals of the model before and after",
            )
        )
    return tuple(pictures)
