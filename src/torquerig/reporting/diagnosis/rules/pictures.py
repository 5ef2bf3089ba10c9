"""The pictures of a diagnosis with their captions and alternative texts."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.showing.comparison import Compared, most_telling
from torquerig.reporting.diagnosis.rules.line_labels import line_labels
from torquerig.reporting.diagnosis.rules.residual_figure import diagnosis_residual_figure, has_residuals
from torquerig.reporting.diagnosis.rules.slow_torque_figure import slow_torque_figure
from torquerig.reporting.diagnosis.rules.spectrum_figure import diagnosis_spectrum_figure
from torquerig.reporting.diagnosis.rules.window_figure import diagnosis_window_figure
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.scenario.kinematics import kinematics_of


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
