"""The combination to buy, its confidence, and the most useful missing values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.decide.eliminate import Decision
from torquerig.decide.verdict import Certainty, MatrixVerdict, verdict_of
from torquerig.study.answer.what_to_do import WhatToDo, what_to_do
from torquerig.study.answer.what_would_change import what_would_change
from torquerig.study.drawn_motors import best_new_motor_text, is_drawn, ranking_of_draws
from torquerig.study.rated_drives import feasible_combinations, rated_drives, samples_of

if TYPE_CHECKING:
    from torquerig.decide.best_shares import SampledTotals
    from torquerig.decide.value_of_information import MissingFact
    from torquerig.study.results import DriveResult
    from torquerig.study.scoring import Decided


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """The result of a study.

    Parameters
    ----------
    winner : str
        Name of the best combination; empty where no drive meets the requirements.
    answer : WhatToDo
        What to do, in plain sentences, with the open questions.
    certainty : Certainty
        Of the drives, each with its best filter; see :func:`torquerig.decide.verdict.verdict_of`. Open questions about
        parts that are on the rig do not make it open: ``answer`` has both branches.
    changes : tuple of str
        What would change the answer, a sentence each.
    remarks : tuple of str
        How far the data carries the ranking.
    p_best : float
        Share of Monte Carlo samples of data, points and weights in which the combination is best [1].
    best_shares : mapping of str to float
        Share of samples in which its drive is best with any filter, by what is sampled: ``intervals``, ``scores``,
        ``weights``, ``together`` [1].
    shares : mapping of str to float
        Share of samples in which each combination that no requirement eliminates is best [1].
    facts : tuple of MissingFact
        Every missing value of the drives that a maker can state, those first that improve the choice most; a spread
        between Monte Carlo samples alone is none.
    """

    winner: str
    answer: WhatToDo
    certainty: Certainty
    p_best: float
    best_shares: Mapping[str, float]
    shares: Mapping[str, float]
    facts: tuple[MissingFact, ...]
    changes: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def sentence(self) -> str:
        """The answer in plain sentences."""
        return " ".join(self.answer.sentences)

    @property
    def open_facts(self) -> tuple[str, ...]:
        """Questions to makers: the missing values that alone can change the winner, the most useful first."""
        return tuple(fact.sentence() for fact in self.facts if fact.decisive)

    @property
    def open_minor_facts(self) -> tuple[str, ...]:
        """The other missing values, which cannot change the winner alone; each once."""
        listed = (fact.fact.split(", ") for fact in self.facts if not fact.decisive)
        each = (data if all(" of " in one for one in data) else [", ".join(data)] for data in listed)
        return tuple(dict.fromkeys(one for data in each for one in data))


def verdict(decided: Decided) -> Verdict:
    """Return the best combination of a study and its confidence."""
    names = feasible_combinations(decided)
    if not names:
        empty = verdict_of(decided.chart, None, {})
        return Verdict(
            winner="", certainty=empty.certainty, p_best=0.0, best_shares={}, shares={}, facts=(),
            answer=what_to_do(decided, empty),
        )  # fmt: skip
    samples = samples_of(decided, names)
    rated = rated_drives(decided, names, samples)
    made, together = rated.verdict, rated.combinations["together"]
    answer = what_to_do(decided, made, samples)
    return Verdict(
        winner=made.winners[0], certainty=answer.certainty, p_best=together.best_share(made.winners[0]),
        best_shares=made.best_shares,
        shares=dict(zip(together.alternatives, together.p_best.tolist(), strict=True)),
        answer=answer, facts=rated.facts, changes=what_would_change(rated), remarks=_remarks(decided, made, samples),
    )  # fmt: skip


def _remarks(decided: Decided, made: MatrixVerdict, drawn: SampledTotals) -> tuple[str, ...]:
    """Return how far the data carries the ranking, and the next best."""
    shares = made.best_shares
    samples = (
        f"This drive is best in {100 * shares['together']:.0f} % of the Monte Carlo samples of data, points and "
        f"weights, and in {100 * shares['intervals']:.0f} % of those of the data alone."
    )
    return tuple(one.strip() for one in (samples, ranking_of_draws(decided), _next_best(decided, made, drawn)) if one)


def _next_best(decided: Decided, made: MatrixVerdict, drawn: SampledTotals) -> str:
    """Return the sentence on the next best: an equal one, the new motors if the draws part them, or the runner-up."""
    if len(made.winners) > 1:
        return f" Equally good is {made.winners[1].replace(' | ', ' with ')}."
    now = decided.alternatives[decided.baseline].drive
    new = [name for name in decided.ranked() if _bought(decided, name, now)]
    if new and (new[0] != made.winners[0] or is_drawn(decided.alternatives[new[0]].drive)):
        return best_new_motor_text(decided, new, drawn)
    return f" The next is {made.runner_up.replace(' | ', ' with ')}." if made.runner_up else ""


def _bought(decided: Decided, name: str, now: DriveResult) -> bool:
    drive = decided.alternatives[name].drive
    out = decided.chart.with_decision(Decision.ELIMINATE)
    return drive.candidate.motor != now.candidate.motor and drive.candidate.name not in out
