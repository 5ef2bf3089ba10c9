"""The page of a diagnosis: one HTML file that needs nothing beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import METRIC
from torquerig.diagnosis.showing.comparison import Compared, compared
from torquerig.reporting.diagnosis import pictures, tables
from torquerig.reporting.diagnosis.numbers import numbers_table
from torquerig.reporting.diagnosis.sentences import FEATURES
from torquerig.reporting.diagnosis.summary import NOWHERE, rendered, told

LIMITS = (
    "A mechanism that is not in the library can only be located, never named.",
    "An effect below the tolerances (4 % of a line, 5 % of a band, 1 % of a level) is not seen, which is not absent.",
    "Random load is compared in its spectrum and level, never sample by sample.",
    "Held-out data are other stretches of the same runs: they rule out a fit to chance, and say nothing of other rigs.",
)


def diagnosis_page(outcome: Outcome, *, title: str, command: str, model: str | None, seed: int) -> str:
    """Return the HTML of a diagnosis: pictures inline, no script, no request to anywhere.

    Parameters
    ----------
    title : str
        Of the scenario.
    command : str
        That makes the page again.
    model : str or None
        Where the completed scenario was written.
    """
    diagnosis = outcome.diagnosis
    rivals = [tables.rivals_table(each) if each.rivals else None for each in diagnosis.findings]
    content = {
        "limits": LIMITS, "metric": f"The misfit is the {METRIC}.",
        **told(diagnosis, outcome.left, yardstick=FEATURES, rivals=rivals), **_shown(outcome, compared(outcome)),
    }  # fmt: skip
    return rendered(content, title=title, command=command, model=model, seed=seed)


def _shown(outcome: Outcome, runs: Sequence[Compared]) -> Mapping[str, Any]:
    diagnosis, left = outcome.diagnosis, outcome.left if outcome.diagnosis.findings else ()
    before, after = outcome.before.model, outcome.after.model
    return {
        "mismatch": tables.mismatch_table(diagnosis.mismatch) if diagnosis.mismatch else None,
        "places": pictures.places_picture(diagnosis.mismatch),
        "nowhere": NOWHERE,
        "left": tables.mismatch_table(left) if left else None,
        "held_out": tables.held_out_table(runs),
        "telling": (*pictures.telling_pictures(outcome, runs), pictures.course_picture(runs)),
        "not_drawn": (),
        "aside": tables.aside_table(diagnosis.set_aside) if diagnosis.set_aside else None,
        "numbers": numbers_table(outcome.before.nominal, before, after) if before.knobs else None,
        "added": None,
        "recordings": tables.runs_table(outcome),
    }
