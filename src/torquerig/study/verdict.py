"""The combination to buy, its confidence, and the most useful missing values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from torquerig.decide.eliminate import Decision
from torquerig.decide.value_of_information import MissingFact
from torquerig.decide.verdict import DECIDED, Certainty, MatrixVerdict, verdict_of
from torquerig.study.drawn_motors import best_new_motor_text, is_drawn, ranking_of_draws
from torquerig.study.rated_drives import feasible_combinations, rated_drives
from torquerig.study.results import DriveResult
from torquerig.study.scoring import Decided


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """The result of a study.

    Parameters
    ----------
    winner : str
        Name of the best combination; empty where no drive meets the requirements.
    sentence : str
        The verdict as text.
    certainty : Certainty
        Of the drives, each with its best filter; see :func:`torquerig.decide.verdict.verdict_of`.
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
    sentence: str
    certainty: Certainty
    p_best: float
    best_shares: Mapping[str, float]
    shares: Mapping[str, float]
    facts: tuple[MissingFact, ...]

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
            sentence="No drive meets the requirements. The elimination lists the requirements that each one misses.",
        )  # fmt: skip
    rated = rated_drives(decided, names)
    made, together = rated.verdict, rated.combinations["together"]
    return Verdict(
        winner=made.winners[0], certainty=made.certainty, p_best=together.best_share(made.winners[0]),
        best_shares=made.best_shares,
        shares=dict(zip(together.alternatives, together.p_best.tolist(), strict=True)),
        sentence=_sentence(decided, made), facts=rated.facts,
    )  # fmt: skip


def _sentence(decided: Decided, made: MatrixVerdict) -> str:
    winner = decided.alternatives[made.winners[0]]
    now = decided.alternatives[decided.baseline]
    error, today = (one.drive.chains[one.chain].truth_error for one in (winner, now))
    unit, width = error.unit.replace("*", " "), ".3f" if error.unit == "N*m" else ".3g"
    reading = (
        f"Its reading error is {error.value:{width}} {unit} rms; that of {now.drive.candidate.name} with the filter "
        f"{now.chain} "
        f"is {today.value:{width}} {unit}."
    )
    return (
        f"{ranking_of_draws(decided)}{_action(decided, made)} the filter {winner.chain}. "
        f"{reading}{_next_best(decided, made)} The verdict is "
        f"{made.certainty}. This drive is best in {made.best_shares['together']:.0%} of the Monte Carlo samples "
        f"of data, "
        f"points and weights, and in {made.best_shares['intervals']:.0%} of those of the data alone."
    )


def _action(decided: Decided, made: MatrixVerdict) -> str:
    winner, now = (decided.alternatives[name].drive for name in (made.winners[0], decided.baseline))
    action = "keep {} as it is, with" if made.winners[0] == decided.baseline else _change(winner, now)
    action = action.format(winner.candidate.name)
    opened = ", ".join(dict.fromkeys(one.partition(": ")[2] for one in made.conditions))
    if made.best_shares["intervals"] < DECIDED and made.certainty is Certainty.OPEN:
        open_text = f" (open requirements: {opened})" if opened else ""
        return f"No drive is clearly best{open_text}; first is {winner.candidate.name} with"
    if opened:
        return f"If the open requirements are met ({opened}), {action}"
    return action[0].upper() + action[1:]


def _change(chosen: DriveResult, now: DriveResult) -> str:
    if chosen.margins["new_parts"].value == 0:
        return "keep {} and add"
    if chosen.candidate.motor == now.candidate.motor:
        stage = f"a gearbox of {chosen.candidate.ratio_text}"
        if chosen.candidate.parts.stage != "gearbox":
            stage = f"{chosen.candidate.gearbox} as {chosen.candidate.parts.stage} ({chosen.candidate.ratio_text})"
        return f"keep the motor {now.candidate.motor}, use {stage} and add"
    return "buy {} with"


def _next_best(decided: Decided, made: MatrixVerdict) -> str:
    """Return the sentence on the next best: an equal one, the new motors if the draws part them, or the runner-up."""
    if len(made.winners) > 1:
        return f" Equally good is {made.winners[1].replace(' | ', ' with ')}."
    now = decided.alternatives[decided.baseline].drive
    new = [name for name in decided.ranked() if _bought(decided, name, now)]
    if new and (new[0] != made.winners[0] or is_drawn(decided.alternatives[new[0]].drive)):
        return best_new_motor_text(decided, new)
    return f" The next is {made.runner_up.replace(' | ', ' with ')}." if made.runner_up else ""


def _bought(decided: Decided, name: str, now: DriveResult) -> bool:
    drive = decided.alternatives[name].drive
    out = decided.chart.with_decision(Decision.ELIMINATE)
    return drive.candidate.motor != now.candidate.motor and drive.candidate.name not in out
