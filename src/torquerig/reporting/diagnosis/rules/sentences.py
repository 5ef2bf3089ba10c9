"""The verdict of the first engine in sentences."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.diagnosis.outcome import Diagnosis, Finding
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.reporting.diagnosis.sentences import FEATURE_RESIDUAL, ResidualMeasure, mechanism_text, place_text


def verdict_sentence(
    diagnosis: Diagnosis, left: Sequence[Mismatch], *, measure: ResidualMeasure = FEATURE_RESIDUAL
) -> str:
    """Return the verdict in sentences of one statement each.

    Parameters
    ----------
    diagnosis : Diagnosis
    left : sequence of Mismatch
        Where the completed model still differs from the recordings, largest share first.
    measure : ResidualMeasure
    """
    fit, name = diagnosis.fit, measure.name
    before, after = measure.formatted(fit.before), measure.formatted(fit.after)
    if diagnosis.verdict == "adequate":
        return (
            f"No physics is missing that these recordings can show. With the scenario's parameters fitted, the {name} "
            f"is {before}{measure.of}.{measure.true_model}"
        )
    remaining = _remaining(left) or measure.without_place
    if not diagnosis.findings:
        return f"Something is missing that no mechanism of the library explains. {remaining}"
    named = " and ".join(_named(finding) for finding in diagnosis.findings)
    them = "it" if len(diagnosis.findings) == 1 else "them"
    # faults of samples are excluded from fits and residuals, so that they change neither
    change = f"stays at {after}" if before == after else f"falls from {before} to {after}"
    lacks = f"The model lacks {named}. With {them}, the {name} {change}{measure.of}."
    if diagnosis.verdict == "missing_physics":
        return lacks + measure.true_model
    return f"{lacks} No mechanism of the library explains the rest. {remaining}"


def _remaining(left: Sequence[Mismatch]) -> str:
    if not left:
        return ""
    more = f", and at {len(left) - 1} other places" if len(left) > 2 else ", and at one other place"
    return f"The largest remaining residual is {place_text(left[0])}{more if len(left) > 1 else ''}."


def _named(finding: Finding) -> str:
    named = mechanism_text(finding.mechanism)
    if finding.equivalent_to:
        named += (
            f" (or {' or '.join(map(mechanism_text, finding.equivalent_to))}; these recordings do not distinguish them)"
        )
    return named
