"""Which combination to buy, how sure that is, and what to ask the makers first."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from torquerig.decide.eliminate import Decision
from torquerig.decide.value_of_information import MissingFact
from torquerig.decide.verdict import DECIDED, Certainty, MatrixVerdict, verdict_of
from torquerig.study.rated_drives import left_over, rated_drives
from torquerig.study.results import DriveResult
from torquerig.study.scoring import Decided


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """The answer of a study.

    Parameters
    ----------
    winner : str
        Name of the alternative; empty where nothing survives.
    sentence : str
        One sentence for the reader.
    word : Certainty
        Of the drives, each with its best filter; as :func:`torquerig.decide.verdict.verdict_of` counts.
    p_best : float
        How often the combination is best in joint draws of data, points and weights [1].
    chances : mapping of str to float
        How often its drive is best with any filter, by what is drawn: ``intervals``, ``scores``, ``weights``,
        ``together`` [1].
    shares : mapping of str to float
        How often each combination that no demand eliminates is best in these joint draws [1].
    facts : tuple of MissingFact
        Every open datum of the drives that somebody can be asked for, those first that improve the choice most; what
        only differs between simulated copies is none.
    """

    winner: str
    sentence: str
    word: Certainty
    p_best: float
    chances: Mapping[str, float]
    shares: Mapping[str, float]
    facts: tuple[MissingFact, ...]

    @property
    def open_facts(self) -> tuple[str, ...]:
        """What to ask for, as sentences: the data that alone can change the winner, the best first."""
        return tuple(fact.sentence() for fact in self.facts if fact.decisive)

    @property
    def open_besides(self) -> tuple[str, ...]:
        """What is open too, and cannot change the winner alone; each datum once."""
        listed = (fact.fact.split(", ") for fact in self.facts if not fact.decisive)
        each = (data if all(" of " in one for one in data) else [", ".join(data)] for data in listed)
        return tuple(dict.fromkeys(one for data in each for one in data))


def verdict(decided: Decided) -> Verdict:
    """Return the answer to the study's question."""
    names = left_over(decided)
    if not names:
        nobody = verdict_of(decided.chart, None, {})
        return Verdict(
            winner="", word=nobody.certainty, p_best=0.0, chances={}, shares={}, facts=(),
            sentence="No drive meets the demands; the elimination says which demand each one misses.",
        )  # fmt: skip
    rated = rated_drives(decided, names)
    made, together = rated.verdict, rated.combinations["together"]
    return Verdict(
        winner=made.winners[0], word=made.certainty, p_best=together.best_share(made.winners[0]),
        chances=made.best_shares,
        shares=dict(zip(together.alternatives, together.p_best.tolist(), strict=True)),
        sentence=_sentence(decided, made), facts=rated.facts,
    )  # fmt: skip


def _sentence(decided: Decided, made: MatrixVerdict) -> str:
    winner = decided.alternatives[made.winners[0]]
    now = decided.alternatives[decided.datum]
    error, today = (one.drive.chains[one.chain].truth_error for one in (winner, now))
    reading = (
        f"it reads the load to {error.value:.3f} N m rms, where {now.drive.candidate.name} with the filter {now.chain} "
        f"is off by {today.value:.3f}"
    )
    return (
        f"{_action(decided, made)} the filter {winner.chain}: {reading}{_beside(decided, made)}. The verdict "
        f"is {made.certainty}: this drive is best in {made.best_shares['together']:.0%} of joint draws over open data, "
        f"points and weights ({made.best_shares['intervals']:.0%} over the data alone)."
    )


def _action(decided: Decided, made: MatrixVerdict) -> str:
    winner, now = (decided.alternatives[name].drive for name in (made.winners[0], decided.datum))
    action = "keep {} as it is, with" if made.winners[0] == decided.datum else _change(winner, now)
    action = action.format(winner.candidate.name)
    opened = ", ".join(dict.fromkeys(told.partition(": ")[2] for told in made.conditions))
    if made.best_shares["intervals"] < DECIDED and made.certainty is Certainty.OPEN:
        still = f" (still open besides: {opened})" if opened else ""
        return f"Nothing can be called best yet{still}; in front is {winner.candidate.name} with"
    if opened:
        return f"If what a demand still asks is answered well ({opened}), {action}"
    return action[0].upper() + action[1:]


def _change(chosen: DriveResult, now: DriveResult) -> str:
    if chosen.margins["new_parts"].value == 0:
        return "keep {} and add"
    if chosen.candidate.motor == now.candidate.motor:
        return f"keep the motor {now.candidate.motor}, put it on a gearbox of {chosen.candidate.ratio:g}:1 and add"
    return "buy {} with"


def _beside(decided: Decided, made: MatrixVerdict) -> str:
    """Return who stands beside or behind the winner: the best new motor, else the next."""
    if len(made.winners) > 1:
        return f"; as good is {made.winners[1].replace(' | ', ' with ')}"
    now = decided.alternatives[decided.datum].drive
    newest = next((name for name in decided.ranked() if _bought(decided, name, now)), "")
    if newest and newest != made.winners[0]:
        return f"; the best new motor is {newest.replace(' | ', ' with ')}"
    return f"; next is {made.runner_up.replace(' | ', ' with ')}" if made.runner_up else ""


def _bought(decided: Decided, name: str, now: DriveResult) -> bool:
    drive = decided.alternatives[name].drive
    out = decided.chart.with_decision(Decision.ELIMINATE)
    return drive.candidate.motor != now.candidate.motor and drive.candidate.name not in out
