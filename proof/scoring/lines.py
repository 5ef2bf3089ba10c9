"""The scores as text for the terminal."""

from __future__ import annotations

from proof.scoring.calibration import Calibration
from proof.scoring.outcome import Outcome
from proof.scoring.parameters import ErrorFigures
from proof.scoring.summary import Share, Summary
from proof.scoring.trial import Trial


def lines_of(summary: Summary) -> list[str]:
    """Return the scores as lines, the main ones first."""
    exact, within = summary.groups["all"]["all"]
    lines = [
        _line("exactly right", exact, at_least=True),
        _line("exactly right or within the class", within, at_least=True),
        _line("false names", summary.false_names, at_least=False),
        _line("false names on rigs without hidden effects", summary.false_on_blank, at_least=False),
        _line("unexplained where true", summary.unexplained_where_due, at_least=True),
        "outcomes: " + ", ".join(f"{count} {name}" for name, count in summary.outcomes.items() if count),
    ]
    lines += _fit_lines(summary)
    for title, rows in summary.groups.items():
        if title != "all":
            lines += ["", f"by {title}: exactly right, exactly or within the class, lower 95 % bound"]
            lines += [
                f"  {name:28s} {a.hits:3d} {b.hits:3d} of {b.trials:3d}  {b.lower:.2f}" for name, (a, b) in rows.items()
            ]
    lines += ["", "relative error of parameters: number, median, 90 % quantile, share of intervals with the true value"]
    errors = {
        "identifying parameters": summary.first_named,
        "all parameters": summary.every_parameter,
        **summary.by_parameter,
    }
    lines += [f"  {name:46s} {_figures(row)}" for name, row in errors.items() if row is not None]
    return lines + _calibration_lines(summary.calibration)


def wrong_lines(trials: list[Trial]) -> list[str]:
    """Return a line for each wrong case: true effects, diagnosis and outcome."""
    lines = []
    for trial in trials:
        if trial.outcome in (Outcome.EXACT, Outcome.IN_CLASS):
            continue
        true = ", ".join(f"{effect.mechanism} ({effect.size:.2f})" for effect in trial.effects) or "none"
        claim = "none"
        if trial.claim is not None:
            claim = ", ".join([trial.claim.verdict, *(f.mechanism for f in trial.claim.findings)])
        lines.append(f"  {trial.name} {trial.plan}: {trial.outcome.value}; true effects: {true}; diagnosis: {claim}")
    return lines


def _line(name: str, share: Share, *, at_least: bool) -> str:
    """Return one share with its bound."""
    if share.trials == 0:
        return f"{name}: no case"
    bound = f"at least {share.lower:.3f}" if at_least else f"at most {share.upper:.3f}"
    return f"{name}: {share.hits} of {share.trials} ({share.hits / share.trials:.3f}; {bound} with 95 % confidence)"


def _fit_lines(summary: Summary) -> list[str]:
    """Return lines on improvement and equivalent mechanisms."""
    lines = []
    if summary.improvement is not None:
        lines.append(f"held-out residual removed: median {summary.improvement:.3f}")
        lines.append(_line("held-out residual worse by more than 1 %", summary.harmed, at_least=False))
    if summary.of_oracle is not None:
        lines.append(f"share of the oracle's improvement: median {summary.of_oracle:.3f} ({summary.oracles} rigs)")
    if summary.class_size is not None:
        lines.append(f"mean number of equivalent mechanisms per finding: {summary.class_size:.2f}")
        lines.append(
            _line(
                "findings with equivalent mechanisms and a next experiment", summary.hedged_with_advice, at_least=True
            )
        )
    return lines


def _figures(row: ErrorFigures) -> str:
    """Return one row of errors."""
    covered = "" if row.covered is None else f"  {row.covered:.2f}"
    return f"{row.count:4d}  {row.median:8.4f}  {row.p90:8.4f}{covered}"


def _calibration_lines(calibration: Calibration | None) -> list[str]:
    """Return lines on the calibration of the confidence."""
    if calibration is None:
        return []
    lines = ["", f"confidence: expected calibration error {calibration.expected_error:.3f}"]
    lines[-1] += (
        f", Brier score {calibration.brier:.3f}, {calibration.count} findings; mean confidence, share right, number"
    )
    return lines + [
        f"  {row.low:.1f}-{row.high:.1f}  {row.said:.3f}  {row.right:.3f}  {row.count:3d}" for row in calibration.table
    ]
