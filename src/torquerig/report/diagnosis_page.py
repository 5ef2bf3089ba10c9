"""The page of a diagnosis: one HTML file that needs nothing beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from torquerig import __version__
from torquerig.diagnose.diagnose import Outcome
from torquerig.diagnose.diagnosis import METRIC, Finding
from torquerig.diagnose.showing.comparison import Compared, compared
from torquerig.report import diagnosis_pictures as pictures
from torquerig.report import diagnosis_tables as tables
from torquerig.report.diagnosis_words import WORDS, mechanism_text, verdict_sentence

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
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("torquerig.report"), autoescape=True, undefined=StrictUndefined, trim_blocks=True,
        lstrip_blocks=True, keep_trailing_newline=True,
    )  # fmt: skip
    runs = compared(outcome)
    content = {
        "title": title.replace("_", " "), "command": command, "model": model, "seed": seed, "version": __version__,
        "limits": LIMITS, "metric": METRIC, **_said(outcome), **_shown(outcome, runs),
    }  # fmt: skip
    return environment.get_template("diagnosis.html").render(content)


def _said(outcome: Outcome) -> Mapping[str, Any]:
    diagnosis = outcome.diagnosis
    return {
        "verdict": WORDS[diagnosis.verdict],
        "sentence": verdict_sentence(diagnosis, outcome.left),
        "fit": diagnosis.fit,
        "improvement": pictures.improvement_text(diagnosis.fit) if diagnosis.findings else None,
        "findings": tuple(_finding(each) for each in diagnosis.findings),
        "next_experiment": diagnosis.next_experiment,
        "remarks": diagnosis.remarks,
    }


def _finding(finding: Finding) -> Mapping[str, Any]:
    return {
        "name": mechanism_text(finding.mechanism) + (f" ({finding.variant})" if finding.variant else ""),
        "explanation": finding.explanation,
        "confidence": f"{100 * finding.confidence:.0f} %",
        "parameters": tables.parameters_table(finding),
        "rivals": tables.rivals_table(finding) if finding.rivals else None,
        "equivalents": tuple(mechanism_text(name) for name in finding.equivalent_to),
        "next_experiment": finding.next_experiment,
    }


def _shown(outcome: Outcome, runs: Sequence[Compared]) -> Mapping[str, Any]:
    left = outcome.left if outcome.diagnosis.findings else ()
    return {
        "mismatch": tables.mismatch_table(outcome.diagnosis.mismatch) if outcome.diagnosis.mismatch else None,
        "places": pictures.places_picture(outcome.diagnosis.mismatch),
        "left": tables.mismatch_table(left) if left else None,
        "held_out": tables.held_out_table(runs),
        "course": pictures.course_picture(runs),
        "telling": pictures.telling_pictures(outcome, runs),
        "aside": tables.aside_table(outcome) if outcome.diagnosis.set_aside else None,
        "numbers": tables.numbers_table(outcome) if outcome.before.model.knobs else None,
        "recordings": tables.runs_table(outcome),
    }
