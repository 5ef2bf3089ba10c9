"""What every page of a diagnosis says, whatever the rig: the verdict, its figures, the findings; and its HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from torquerig.diagnosis.outcome import Diagnosis, Finding, HeldOut, Mismatch
from torquerig.reporting.diagnosis.sentences import WORDS, Yardstick, mechanism_text, verdict_sentence
from torquerig.reporting.diagnosis.tables import parameters_table
from torquerig.reporting.html import html
from torquerig.reporting.layout import Table, plain

NOWHERE = "Nowhere by more than chance leaves, so there is no picture of it."


def rendered(content: Mapping[str, Any], *, title: str, command: str, model: str | None, seed: int) -> str:
    """Return the HTML of a diagnosis: pictures inline, no script, no request to anywhere."""
    made = {
        "title": title.replace("_", " "), "command": command, "model": model, "seed": seed,
    }  # fmt: skip
    return html("diagnosis.html", {**made, **content})


def told(
    diagnosis: Diagnosis, left: Sequence[Mismatch], *, yardstick: Yardstick, rivals: Sequence[Table | None]
) -> Mapping[str, Any]:
    """Return the verdict and the findings, each with the table of its rivals; ``left`` is what still stands out."""
    return {
        "verdict": WORDS[diagnosis.verdict],
        "sentence": verdict_sentence(diagnosis, left, yardstick=yardstick),
        "figures": _figures(diagnosis.fit, found=bool(diagnosis.findings), yardstick=yardstick),
        "findings": tuple(_finding(*each) for each in zip(diagnosis.findings, rivals, strict=True)),
        "next_experiment": diagnosis.next_experiment,
        "remarks": diagnosis.remarks,
    }


def _figures(fit: HeldOut, *, found: bool, yardstick: Yardstick) -> tuple[tuple[str, str], ...]:
    word = yardstick.name.split()[0]
    nominal, calibrated = yardstick.said(fit.nominal), yardstick.said(fit.before)
    first = ((f"{word} on held-out data: nominal", nominal), ("calibrated", calibrated))
    if not found:
        return first
    return (*first, ("with what was found", yardstick.said(fit.after)), ("improvement", _improvement(fit)))


def _improvement(fit: HeldOut) -> str:
    value, low, high = (100 * each for each in fit.improvement)
    return f"{plain(value)} % (95 %: {plain(low)} to {plain(high)} %)"


def _finding(finding: Finding, rivals: Table | None) -> Mapping[str, Any]:
    variant = f" ({mechanism_text(finding.variant)})" if finding.variant else ""
    return {
        "name": mechanism_text(finding.mechanism) + variant,
        "explanation": finding.explanation,
        "confidence": f"{100 * finding.confidence:.0f} %",
        "parameters": parameters_table(finding),
        "rivals": rivals,
        "equivalents": tuple(mechanism_text(name) for name in finding.equivalent_to),
        "next_experiment": finding.next_experiment,
    }
