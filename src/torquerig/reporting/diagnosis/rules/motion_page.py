"""The page of a diagnosis under measured motion: one self-contained HTML file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from torquerig.diagnosis.motion.diagnose_motion import METRIC, MotionOutcome
from torquerig.diagnosis.motion.level import TOLERANCE
from torquerig.diagnosis.showing.effect_at_sensor import EffectAtSensor
from torquerig.diagnosis.showing.motion_comparison import motion_compared, scale_of
from torquerig.reporting.diagnosis.mismatch_figure import mismatch_picture
from torquerig.reporting.diagnosis.page_answer import diagnosis_answer
from torquerig.reporting.diagnosis.parameter_tables import added_parameters_table, fitted_parameters_table
from torquerig.reporting.diagnosis.rules import motion_tables as tables
from torquerig.reporting.diagnosis.rules.motion_pictures import motion_pictures
from torquerig.reporting.diagnosis.rules.summary import verdict_content
from torquerig.reporting.diagnosis.sentences import MOTION_RESIDUAL
from torquerig.reporting.diagnosis.summary import NO_MISMATCH, first_and_others, rendered
from torquerig.reporting.diagnosis.tables import mismatch_table, rejected_table

LIMITS = (
    "A mechanism that is not in the library is located, but not named.",
    "The comparison ends at a tenth of the sample rate. Above it, noise dominates the acceleration.",
    "The measured motion is imposed on the model. An error of the encoder therefore appears as torque or force.",
    f"A mean residual below {100 * TOLERANCE:.0f} % of the torque or force is not reported.",
    "A line that hardly reduces the residual is not reported.",
    "Held-out data are other stretches of the same runs. They show overfitting, but they do not validate other rigs.",
)


def motion_page(
    outcome: MotionOutcome, *, title: str, command: str, model: str | None, seed: int,
    effect: EffectAtSensor | None = None,
) -> str:  # fmt: skip
    """Return the HTML of a diagnosis under measured motion: pictures and scripts inside, no request to anywhere.

    Parameters
    ----------
    title : str
        Title of the scenario.
    command : str
        Command that reproduces the page.
    model : str or None
        Path of the completed scenario.
    effect : EffectAtSensor or None
        How much the findings change the reading, for the first screen.
    """
    content = {
        "limits": LIMITS, "metric": METRIC,
        "answer": diagnosis_answer(outcome.as_json(), effect, percent=True),
        **verdict_content(
            outcome.diagnosis, outcome.left, measure=MOTION_RESIDUAL,
            alternatives=tables.alternatives_tables(outcome),
        ),
        **_shown(outcome),
    }  # fmt: skip
    return rendered(content, title=title, command=command, model=model, seed=seed)


def _shown(outcome: MotionOutcome) -> Mapping[str, Any]:
    runs, scale = motion_compared(outcome), scale_of(outcome)
    drawn, omitted = motion_pictures(outcome, runs)
    remaining = outcome.left if outcome.steps else ()
    rejected, before = outcome.diagnosis.set_aside, outcome.before
    notes = {"sizes": tables.SIZES, "correction": tables.CORRECTION}
    return {
        "mismatch": mismatch_table(outcome.missed, **notes) if outcome.missed else None,
        "mismatch_picture": mismatch_picture(outcome.missed),
        "no_mismatch": tables.NO_PLACE if outcome.steps else NO_MISMATCH,
        "remaining": mismatch_table(remaining, **notes) if remaining else None,
        "held_out": tables.held_out_table(runs, scale=scale),
        **first_and_others(drawn),
        "omitted_pictures": omitted,
        "rejected": rejected_table(rejected, note=tables.REJECTED) if rejected else None,
        "fitted": fitted_parameters_table(outcome.nominal, before, outcome.after, unit_names=scale.called)
        if before.knobs
        else None,
        "added": added_parameters_table(before, outcome.after, unit_names=scale.called),
        "recordings": tables.runs_table(outcome, scale=scale),
    }
