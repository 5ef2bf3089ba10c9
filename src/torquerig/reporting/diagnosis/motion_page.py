"""The page of a diagnosis under measured motion: one HTML file that needs nothing beside it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from torquerig.diagnosis.motion.diagnose_motion import METRIC, MotionOutcome
from torquerig.diagnosis.motion.level import TOLERANCE
from torquerig.diagnosis.showing.motion_comparison import motion_compared, scale_of
from torquerig.reporting.diagnosis import motion_tables as tables
from torquerig.reporting.diagnosis.motion_pictures import motion_pictures
from torquerig.reporting.diagnosis.numbers import added_numbers_table, numbers_table
from torquerig.reporting.diagnosis.pictures import places_picture
from torquerig.reporting.diagnosis.sentences import EFFORT
from torquerig.reporting.diagnosis.summary import NOWHERE, rendered, told
from torquerig.reporting.diagnosis.tables import aside_table, mismatch_table

LIMITS = (
    "A mechanism that is not in the library can only be located, never named.",
    "Motion and effort are compared below a tenth of the sample rate; beyond it the acceleration is noise.",
    "The motion is imposed as it was measured: an error of the encoder counts as effort.",
    f"A mean off by less than {TOLERANCE:.0%} of the effort is not told, nor a line that hardly lowers what is left.",
    "Held-out data are other stretches of the same runs: they rule out a fit to chance, and say nothing of other rigs.",
)


def motion_page(outcome: MotionOutcome, *, title: str, command: str, model: str | None, seed: int) -> str:
    """Return the HTML of a diagnosis under measured motion: pictures inline, no script, no request to anywhere.

    Parameters
    ----------
    title : str
        Of the scenario.
    command : str
        That makes the page again.
    model : str or None
        Where the completed scenario was written.
    """
    content = {
        "limits": LIMITS, "metric": f"The error is the {METRIC}.",
        **told(outcome.diagnosis, outcome.left, yardstick=EFFORT, rivals=tables.rivals_tables(outcome)),
        **_shown(outcome),
    }  # fmt: skip
    return rendered(content, title=title, command=command, model=model, seed=seed)


def _shown(outcome: MotionOutcome) -> Mapping[str, Any]:
    runs, scale = motion_compared(outcome), scale_of(outcome)
    drawn, not_drawn = motion_pictures(outcome, runs)
    left = outcome.left if outcome.steps else ()
    aside, before = outcome.diagnosis.set_aside, outcome.before
    told_by = {"sizes": tables.SIZES, "chance": tables.CHANCE}
    return {
        "mismatch": mismatch_table(outcome.missed, **told_by) if outcome.missed else None,
        "places": places_picture(outcome.missed),
        "nowhere": tables.NOWHERE if outcome.steps else NOWHERE,
        "left": mismatch_table(left, **told_by) if left else None,
        "held_out": tables.held_out_table(runs, scale=scale),
        "telling": drawn,
        "not_drawn": not_drawn,
        "aside": aside_table(aside, note=tables.ASIDE) if aside else None,
        "numbers": numbers_table(outcome.nominal, before, outcome.after, called=scale.called) if before.knobs else None,
        "added": added_numbers_table(before, outcome.after, called=scale.called),
        "recordings": tables.runs_table(outcome, scale=scale),
    }
