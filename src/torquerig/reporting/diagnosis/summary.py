"""The content that the pages of both kinds of rig share: verdict, key figures, findings, HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from torquerig.diagnosis.outcome import Diagnosis, Finding, HeldOut, Mismatch
from torquerig.reporting.diagnosis.sentences import WORDS, ResidualMeasure, mechanism_text, verdict_sentence
from torquerig.reporting.diagnosis.tables import parameters_table
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.html import html
from torquerig.reporting.layout import Table, plain
from torquerig.reporting.moving.page_scripts import page_scripts

NO_MISMATCH = "No difference is significant, so there is no figure of it."


def rendered(content: Mapping[str, Any], *, title: str, command: str, model: str | None, seed: int) -> str:
    """Return the HTML of a diagnosis: pictures and scripts inside, no request to anywhere."""
    made = {
        "title": title.replace("_", " "), "command": command, "model": model, "seed": seed,
        "scripts": page_scripts(with_plots=False, with_matrices=False),
    }  # fmt: skip
    return html("diagnosis.html", {**made, **content})


def first_and_others(drawn: Sequence[Picture]) -> Mapping[str, Any]:
    """Return the picture of the first screen, of recording and models, and the others; each named for its files."""
    named = [replace(one, name=f"picture_{number}") for number, one in enumerate(drawn, start=1)]
    return {"first_picture": named[0] if named else None, "pictures": tuple(named[1:])}


def verdict_content(
    diagnosis: Diagnosis, left: Sequence[Mismatch], *, measure: ResidualMeasure, alternatives: Sequence[Table | None]
) -> Mapping[str, Any]:
    """Return verdict, key figures and findings, each finding with the table of its alternative hypotheses.

    ``left`` holds the significant residuals of the completed model.
    """
    return {
        "verdict": WORDS[diagnosis.verdict],
        "sentence": verdict_sentence(diagnosis, left, measure=measure),
        "figures": _figures(diagnosis.fit, found=bool(diagnosis.findings), measure=measure),
        "findings": tuple(_finding(*each) for each in zip(diagnosis.findings, alternatives, strict=True)),
        "next_experiment": diagnosis.next_experiment,
        "remarks": diagnosis.remarks,
    }


def _figures(fit: HeldOut, *, found: bool, measure: ResidualMeasure) -> tuple[tuple[str, str], ...]:
    nominal, calibrated = measure.formatted(fit.nominal), measure.formatted(fit.before)
    first = (("held-out residual: nominal", nominal), ("calibrated", calibrated))
    if not found:
        return first
    return (*first, ("with findings", measure.formatted(fit.after)), ("improvement", _improvement(fit)))


def _improvement(fit: HeldOut) -> str:
    value, low, high = (100 * each for each in fit.improvement)
    return f"{plain(value)} % (95 %: {plain(low)} to {plain(high)} %)"


def _finding(finding: Finding, alternatives: Table | None) -> Mapping[str, Any]:
    variant = f" ({mechanism_text(finding.variant)})" if finding.variant else ""
    return {
        "name": mechanism_text(finding.mechanism) + variant,
        "explanation": finding.explanation,
        "confidence": f"{100 * finding.confidence:.0f} %",
        "parameters": parameters_table(finding),
        "alternatives": alternatives,
        "equivalents": tuple(mechanism_text(name) for name in finding.equivalent_to),
        "next_experiment": finding.next_experiment,
    }
