"""Shares, figures and names as cells of a table."""

from __future__ import annotations

from proof.scoring.parameters import ErrorFigures
from proof.scoring.summary import Share
from proof.scoring.trial import Trial
from torquerig.reporting.layout import Cell, number

PER_CENT = 100.0


def percent(share: float | None, digits: int = 1) -> str:
    """Write a share in per cent; a dash where there is none."""
    return "-" if share is None else f"{PER_CENT * share:.{digits}f} %"


def share_cells(share: Share, *, at_least: bool) -> tuple[Cell, ...]:
    """Give counted, share and the one-sided exact 95 % bound that matters."""
    if share.trials == 0:
        return (number("none due"), number("-"), number("-"))
    bound = f"≥ {percent(share.lower)}" if at_least else f"≤ {percent(share.upper)}"
    return number(f"{share.hits} of {share.trials}"), number(percent(share.hits / share.trials)), number(bound)


def error_cells(figures: ErrorFigures | None) -> tuple[Cell, ...]:
    """Give number, median, 90 % quantile and coverage of relative errors."""
    if figures is None:
        return (number("0"), number("-"), number("-"), number("-"))
    return (
        number(str(figures.count)),
        number(percent(figures.median, 2)),
        number(percent(figures.p90, 2)),
        number(percent(figures.covered, 0)),
    )


def had(trial: Trial) -> str:
    """Say what a case truly had, with its size between 0 (just visible) and 1 (far larger than in handbooks)."""
    if not trial.effects:
        return "parameters far from nominal" if trial.wrong_parameters else "nothing"
    return ", ".join(f"{effect.mechanism} ({effect.size:.2f})" for effect in trial.effects)


def said(trial: Trial) -> str:
    """Say what the diagnosis said of a case."""
    if trial.claim is None:
        return "no diagnosis"
    told = [trial.claim.verdict.replace("_", " ")]
    for finding in trial.claim.findings:
        rivals = f" or {' or '.join(finding.equivalent_to)}" if finding.equivalent_to else ""
        told.append(f"{finding.mechanism}{rivals} ({finding.confidence:.2f})")
    return ", ".join(told)
