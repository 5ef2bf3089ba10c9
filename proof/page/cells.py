"""Shares, scores and names as cells of a table."""

from __future__ import annotations

from proof.scoring.parameters import ErrorFigures
from proof.scoring.summary import Share
from proof.scoring.trial import Trial
from torquerig.reporting.layout import Cell, number

PER_CENT = 100.0


def percent(share: float | None, digits: int = 1) -> str:
    """Return a share in per cent; a dash for None."""
    return "-" if share is None else f"{PER_CENT * share:.{digits}f} %"


def share_cells(share: Share, *, at_least: bool) -> tuple[Cell, ...]:
    """Return count, share and one-sided exact 95 % bound."""
    if share.trials == 0:
        return (number("no case"), number("-"), number("-"))
    bound = f"≥ {percent(share.lower)}" if at_least else f"≤ {percent(share.upper)}"
    return number(f"{share.hits} of {share.trials}"), number(percent(share.hits / share.trials)), number(bound)


def error_cells(figures: ErrorFigures | None) -> tuple[Cell, ...]:
    """Return number, median, 90 % quantile and coverage of relative errors."""
    if figures is None:
        return (number("0"), number("-"), number("-"), number("-"))
    return (
        number(str(figures.count)),
        number(percent(figures.median, 2)),
        number(percent(figures.p90, 2)),
        number(percent(figures.covered, 0)),
    )


def true_effects_text(trial: Trial) -> str:
    """Return the true effects of a case, with sizes from 0 (just visible) to 1 (far larger than in handbooks)."""
    if not trial.effects:
        return "parameters far from nominal" if trial.wrong_parameters else "no effect"
    return ", ".join(f"{effect.mechanism} ({effect.size:.2f})" for effect in trial.effects)


def diagnosis_text(trial: Trial) -> str:
    """Return verdict and findings of a case."""
    if trial.claim is None:
        return "no diagnosis"
    parts = [trial.claim.verdict.replace("_", " ")]
    for finding in trial.claim.findings:
        others = f" or {' or '.join(finding.equivalent_to)}" if finding.equivalent_to else ""
        parts.append(f"{finding.mechanism}{others} ({finding.confidence:.2f})")
    return ", ".join(parts)
