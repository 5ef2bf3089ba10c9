"""The page of a diagnosis: one self-contained HTML file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import METRIC, as_json
from torquerig.diagnosis.showing.comparison import Compared, compared
from torquerig.diagnosis.showing.effect_at_sensor import EffectAtSensor
from torquerig.reporting.diagnosis.mismatch_figure import mismatch_picture
from torquerig.reporting.diagnosis.page_answer import diagnosis_answer
from torquerig.reporting.diagnosis.parameter_tables import fitted_parameters_table
from torquerig.reporting.diagnosis.rules import pictures, tables
from torquerig.reporting.diagnosis.rules.summary import verdict_content
from torquerig.reporting.diagnosis.sentences import FEATURE_RESIDUAL
from torquerig.reporting.diagnosis.summary import NO_MISMATCH, first_and_others, rendered
from torquerig.reporting.diagnosis.tables import mismatch_table, rejected_table

LIMITS = (
    "A mechanism that is not in the library is located, but not named.",
    "Effects below the tolerances can exist unseen: 4 % of a line, 5 % of a frequency band, 1 % of a level.",
    "The random load is compared in its spectrum and level, not sample by sample.",
    "Held-out data are other stretches of the same runs. They show overfitting, but they do not validate other rigs.",
)


def diagnosis_page(
    outcome: Outcome, *, title: str, command: str, model: str | None, seed: int, effect: EffectAtSensor | None = None
) -> str:
    """Return the HTML of a diagnosis: pictures, data and scripts inside, no request to anywhere.

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
    diagnosis = outcome.diagnosis
    alternatives = [tables.alternatives_table(each) if each.alternatives else None for each in diagnosis.findings]
    content = {
        "limits": LIMITS, "metric": METRIC,
        "answer": diagnosis_answer(as_json(diagnosis), effect, percent=False),
        **verdict_content(diagnosis, outcome.left, measure=FEATURE_RESIDUAL, alternatives=alternatives),
        **_shown(outcome, compared(outcome)),
    }  # fmt: skip
    return rendered(content, title=title, command=command, model=model, seed=seed)


def _shown(outcome: Outcome, runs: Sequence[Compared]) -> Mapping[str, Any]:
    diagnosis, remaining = outcome.diagnosis, outcome.left if outcome.diagnosis.findings else ()
    before, after = outcome.before.model, outcome.after.model
    return {
        "mismatch": mismatch_table(diagnosis.mismatch) if diagnosis.mismatch else None,
        "mismatch_picture": mismatch_picture(diagnosis.mismatch),
        "no_mismatch": NO_MISMATCH,
        "remaining": mismatch_table(remaining) if remaining else None,
        "held_out": tables.held_out_table(runs),
        **first_and_others((*pictures.comparison_pictures(outcome, runs), pictures.slow_torque_picture(runs))),
        "omitted_pictures": (),
        "rejected": rejected_table(diagnosis.set_aside) if diagnosis.set_aside else None,
        "fitted": fitted_parameters_table(outcome.before.nominal, before, after) if before.knobs else None,
        "added": None,
        "recordings": tables.runs_table(outcome),
    }
