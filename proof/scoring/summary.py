"""Summary of all trials: shares with exact bounds, errors, improvement and calibration."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from proof.scoring.bounds import lower_bound, upper_bound
from proof.scoring.calibration import Calibration, calibration_of
from proof.scoring.outcome import Outcome
from proof.scoring.parameters import ErrorFigures, ParameterError, errors_of, figures
from proof.scoring.trial import Trial

SIZES = ((1.0 / 3.0, "just visible to small"), (2.0 / 3.0, "as in handbooks"), (1.01, "far larger"))


@dataclass(frozen=True)
class Share:
    """A counted share with one-sided exact 95 % bounds."""

    hits: int
    trials: int

    @property
    def lower(self) -> float:
        """Lower 95 % confidence bound."""
        return lower_bound(self.hits, self.trials)

    @property
    def upper(self) -> float:
        """Upper 95 % confidence bound."""
        return upper_bound(self.hits, self.trials)


@dataclass(frozen=True)
class Summary:
    """All scores of a set of trials.

    ``groups`` holds (exact, exact or within the class) by what groups them; ``oracles`` counts the rigs behind
    ``of_oracle``.
    """

    outcomes: dict[str, int]
    groups: dict[str, dict[str, tuple[Share, Share]]]
    false_on_blank: Share
    false_names: Share
    unexplained_where_due: Share
    first_named: ErrorFigures | None
    every_parameter: ErrorFigures | None
    by_parameter: dict[str, ErrorFigures]
    improvement: float | None
    of_oracle: float | None
    oracles: int
    harmed: Share
    class_size: float | None
    hedged_with_advice: Share
    calibration: Calibration | None


def summarise(trials: list[Trial]) -> Summary:
    """Return the scores of a set of trials."""
    matches = [match for trial in trials for match in trial.matches]
    errors = [error for match in matches for error in errors_of(match)]
    blank = [trial for trial in trials if trial.due == "adequate"]
    outside = [trial for trial in trials if trial.due == "unexplained"]
    gains = [trial.improvement for trial in trials if trial.improvement is not None and trial.matches]
    # all rigs with an oracle, also those without findings, which have no improvement
    each = [trial.improvement.of_oracle for trial in trials if trial.improvement is not None]
    oracle = [share for share in each if share is not None]
    hedged = [match.finding for match in matches if match.finding.equivalent_to]
    return Summary(
        outcomes={outcome.value: sum(trial.outcome is outcome for trial in trials) for outcome in Outcome},
        groups={
            "all": _grouped(trials, lambda _: "all"),
            "hidden effects": _grouped(trials, lambda trial: trial.kind),
            "size": _grouped((trial for trial in trials if trial.effects), size_name),
            "mechanism": _grouped(
                (trial for trial in trials if len(trial.effects) == 1), lambda trial: trial.effects[0].mechanism
            ),
            "plan": _grouped(trials, lambda trial: trial.plan),
        },
        false_on_blank=_share(blank, lambda trial: trial.outcome is Outcome.FALSE_NAME),
        false_names=_share(trials, lambda trial: trial.outcome is Outcome.FALSE_NAME),
        unexplained_where_due=_share(outside, called_unexplained),
        first_named=figures(error for error in errors if error.first_named),
        every_parameter=figures(errors),
        by_parameter=_by_parameter(errors),
        improvement=float(np.median([gain.share for gain in gains])) if gains else None,
        of_oracle=float(np.median(oracle)) if oracle else None,
        oracles=len(oracle),
        harmed=Share(sum(gain.harmed for gain in gains), len(gains)),
        class_size=float(np.mean([1 + len(match.finding.equivalent_to) for match in matches])) if matches else None,
        hedged_with_advice=Share(sum(finding.next_experiment is not None for finding in hedged), len(hedged)),
        calibration=calibration_of((match.finding.confidence, match.effect is not None) for match in matches),
    )


def called_unexplained(trial: Trial) -> bool:
    """Return whether a case has the verdict unexplained and no false name."""
    return trial.claim is not None and trial.claim.verdict == "unexplained" and trial.outcome is not Outcome.FALSE_NAME


def size_name(trial: Trial) -> str:
    """Return the size class of a case's smallest effect."""
    smallest = min(effect.size for effect in trial.effects)
    return next(name for top, name in SIZES if smallest <= top)


def _share(trials: Iterable[Trial], right: Callable[[Trial], bool]) -> Share:
    """Return the share of right trials."""
    answers = [right(trial) for trial in trials]
    return Share(sum(answers), len(answers))


def _grouped(trials: Iterable[Trial], key: Callable[[Trial], str]) -> dict[str, tuple[Share, Share]]:
    """Return the shares exactly right, and exactly or within the class, for each group."""
    groups: dict[str, list[Trial]] = {}
    for trial in trials:
        groups.setdefault(key(trial), []).append(trial)
    return {
        name: (
            _share(rows, lambda trial: trial.outcome is Outcome.EXACT),
            _share(rows, lambda trial: trial.outcome in (Outcome.EXACT, Outcome.IN_CLASS)),
        )
        for name, rows in sorted(groups.items())
    }


def _by_parameter(errors: list[ParameterError]) -> dict[str, ErrorFigures]:
    """Return the statistics of each parameter of each mechanism."""
    names = sorted({(error.mechanism, error.name) for error in errors})
    rows = {
        f"{mechanism}.{name}": figures(e for e in errors if (e.mechanism, e.name) == (mechanism, name))
        for mechanism, name in names
    }
    return {name: row for name, row in rows.items() if row is not None}
