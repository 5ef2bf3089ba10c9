"""The pictures of a diagnosis with their captions and alternative texts."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import Mismatch
from torquerig.diagnosis.showing.comparison import Compared, most_telling
from torquerig.reporting.diagnosis.line_labels import line_labels
from torquerig.reporting.diagnosis.mismatch_figure import MOST, has_visible_share, mismatch_figure
from torquerig.reporting.diagnosis.residual_figure import diagnosis_residual_figure, has_residuals
from torquerig.reporting.diagnosis.slow_torque_figure import slow_torque_figure
from torquerig.reporting.diagnosis.spectrum_figure import diagnosis_spectrum_figure
from torquerig.reporting.diagnosis.window_figure import diagnosis_window_figure
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.scenario.kinematics import kinematics_of


def mismatch_picture(listed: Sequence[Mismatch]) -> Picture | None:
    """Return the shares of the squared residual by place, or None where no place has a visible share."""
    if not has_visible_share(listed):
        return None
    which = "Each place" if len(listed) <= MOST else f"The {MOST} largest of {len(listed)} places"
    return picture(
        mismatch_figure(listed),
        caption=f"{which} where recordings and calibrated model differ, by share of the squared residual.",
        alt_text="bars of the shares of the squared residual by place, largest first",
        name="differences_by_place",
    )


def slow_torque_picture(runs: Sequence[Compared]) -> Picture:
    """Return the slow torque of the runs over time."""
    return picture(
        slow_torque_figure(runs),
        caption="Slow torque over time. Shaded: held-out stretches. Runs that reverse: simulation of the models. "
        "Other runs: mean level of the models, because the variation of the load is random.",
        alt_text="torque over time of each run, with the level that the model predicts before and after",
    )


def comparison_pictures(outcome: Outcome, runs: Sequence[Compared]) -> tuple[Picture, ...]:
    """Return window, order spectrum and residuals: of the run that improves most, and of a run that reverses."""
    shown, turning = most_telling(runs), [one for one in runs if one.held.turning is not None]
    ratio = kinematics_of(outcome.completed).ratio
    pictures = []
    if shown is not None:
        name = shown.held.observed.name
        pictures.append(
            picture(
                diagnosis_window_figure(shown, ratio=ratio),
                caption=f"A held-out window of {name}. The models predict the amplitudes of the lines. Their phases "
                "are taken from the recording, because they depend on the start position.",
                alt_text="recording and the lines of the model before and after over a short time",
            )
        )
        labels = line_labels(outcome, shown)
        pictures.append(
            picture(
                diagnosis_spectrum_figure(shown, labels, ratio=ratio),
                caption=f"Held-out part of {name} over the orders of the output shaft, with simulations of the model "
                "before and after. Grey labels: lines of the nominal model. Red: found missing. Brown: unexplained.",
                alt_text="amplitude over order, recording and model, lines labelled by cause",
            )
        )
    if has_residuals(shown, turning):
        pictures.append(
            picture(
                diagnosis_residual_figure(shown, turning),
                caption="Held-out residuals of the models: spectrum between the lines, each line, and the slow torque "
                "of a run that reverses. Grey: 95 % range of a true model.",
                alt_text="residuals of the model before and after",
            )
        )
    return tuple(pictures)
