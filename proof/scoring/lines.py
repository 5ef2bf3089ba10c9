"""How the figures are told at the terminal."""

from __future__ import annotations

from proof.scoring.calibration import Calibration
from proof.scoring.outcome import Outcome
from proof.scoring.parameters import ErrorFigures
from proof.scoring.summary import Share, Summary
from proof.scoring.trial import Trial


def lines_of(summary: Summary) -> list[str]:
    """Give the figures as lines, the ones that matter most first."""
    exact, within = summary.groups["all"]["all"]
    lines = [
        _line("exactly right", exact, at_least=True),
        _line("exactly right or within the class", within, at_least=True),
        _line("false names", summary.false_names, at_least=False),
        _line("false names on rigs with nothing hidden", summary.false_on_blank, at_least=False),
        _line("unexplained where due", summary.unexplained_where_due, at_least=True),
        "outcomes: " + ", ".join(f"{count} {name}" for name, count in summary.outcomes.items() if count),
    ]
    lines += _fit_lines(summary)
    for title, rows in summary.groups.items():
        if title != "all":
            lines += ["", f"by {title}: exact, exact or within the class, lower 95 % bound"]
            lines += [
                f"  {name:28s} {a.hits:3d} {b.hits:3d} of {b.trials:3d}  {b.lower:.2f}" for name, (a, b) in rows.items()
            ]
    lines += ["", "relative error of parameters: number, median, 90 % quantile, intervals that cover"]
    errors = {"first-named": summary.first_named, "every one": summary.every_parameter, **summary.by_parameter}
    lines += [f"  {name:46s} {_figures(row)}" for name, row in errors.items() if row is not None]
    return lines + _calibration_lines(summary.calibration)


def wrong_lines(trials: list[Trial]) -> list[str]:
    """Tell each case that was not right: what it had and what was said."""
    lines = []
    for trial in trials:
        if trial.outcome in (Outcome.EXACT, Outcome.IN_CLASS):
            continue
        had = ", ".join(f"{effect.mechanism} ({effect.size:.2f})" for effect in trial.effects) or "nothing"
        said = "no diagnosis"
        if trial.claim is not None:
            said = ", ".join([trial.claim.verdict, *(f.mechanism for f in trial.claim.findings)])
        lines.append(f"  {trial.name} {trial.plan}: had {had}; said {said}: {trial.outcome.value}")
    return lines


def _line(name: str, share: Share, *, at_least: bool) -> str:
    """Tell one share with the bound that matters."""
    if share.trials == 0:
        return f"{name}: none due"
    bound = f"at least {share.lower:.3f}" if at_least else f"at most {share.upper:.3f}"
    return f"{name}: {share.hits} of {share.trials} ({share.hits / share.trials:.3f}; {bound} with 95 % confidence)"


def _fit_lines(summary: Summary) -> list[str]:
    """Tell improvement and hedging."""
    lines = []
    if summary.improvement is not None:
        lines.append(f"held-out misfit removed: median {summary.improvement:.3f}")
        lines.append(_line("held-out misfit worse by more than 1 %", summary.harmed, at_least=False))
    if summary.of_oracle is not None:
        lines.append(f"of what the true mechanism removes: median {summary.of_oracle:.3f} ({summary.oracles} rigs)")
    if summary.class_size is not None:
        lines.append(f"mean size of the class of a finding: {summary.class_size:.2f}")
        lines.append(
            _line("findings with rivals that say which run would tell", summary.hedged_with_advice, at_least=True)
        )
    return lines


def _figures(row: ErrorFigures) -> str:
    """Tell one row of errors."""
    covered = "" if row.covered is None else f"  {row.covered:.2f}"
    return f"{row.count:4d}  {row.median:8.4f}  {row.p90:8.4f}{covered}"


def _calibration_lines(calibration: Calibration | None) -> list[str]:
    """Tell how far confidences can be believed."""
    if calibration is None:
        return []
    lines = ["", f"confidence: expected calibration error {calibration.expected_error:.3f}"]
    lines[-1] += f", Brier score {calibration.brier:.3f}, {calibration.count} findings; said, right, number"
    return lines + [
        f"  {row.low:.1f}-{row.high:.1f}  {row.said:.3f}  {row.right:.3f}  {row.count:3d}" for row in calibration.table
    ]
