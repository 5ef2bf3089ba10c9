"""The content that the pages of both kinds of rig share by the first engine: verdict, key figures, findings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from torquerig.diagnosis.outcome import Diagnosis, Finding, HeldOut
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.rules.sentences import verdict_sentence
from torquerig.reporting.diagnosis.rules.tables import parameters_table
from torquerig.reporting.diagnosis.sentences import WORDS, ResidualMeasure, mechanism_text
from torquerig.reporting.layout import Table, plain


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
