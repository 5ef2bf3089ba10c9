"""What to do, from the results of a study: plain sentences of at most 25 words, and three large figures."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from torquerig.decide.verdict import DECIDED, Certainty, MatrixVerdict
from torquerig.study.answer.equally_good import BestMotors, best_motors
from torquerig.study.answer.open_questions import OpenQuestion, open_questions
from torquerig.study.rated_drives import feasible_combinations

if TYPE_CHECKING:
    from torquerig.decide.best_shares import SampledTotals
    from torquerig.metrics.figure import Figure
    from torquerig.study.results import DriveResult
    from torquerig.study.scoring import Alternative, Decided

NAMED = 3  # motors that a sentence names; more become "and N others"
NOBODY = (
    "No drive meets the requirements.",
    "The table Elimination lists the requirement that each drive misses.",
)


@dataclass(frozen=True, kw_only=True)
class LargeFigure:
    """One of the three figures of the first screen: ``0.071 N m`` with its name and a short note."""

    name: str
    value: str
    note: str


@dataclass(frozen=True, kw_only=True)
class WhatToDo:
    """The answer of a study.

    Parameters
    ----------
    sentences : tuple of str
        What to do; then each open question with both of its branches; how sure at the end.
    certainty : Certainty
        Of the first sentence; questions about parts that are on the rig do not make it open.
    questions : tuple of OpenQuestion
    figures : tuple of LargeFigure
        Reading error, price and confidence; empty where no drive meets the requirements.
    """

    sentences: tuple[str, ...]
    certainty: Certainty
    questions: tuple[OpenQuestion, ...] = ()
    figures: tuple[LargeFigure, ...] = ()

    @property
    def certainty_text(self) -> str:
        """The certainty in words, with the conditions that the present parts must meet."""
        conditions = [one.condition() for one in self.questions if one.is_of_present_parts]
        if not conditions or self.certainty is Certainty.OPEN:
            return str(self.certainty)
        return f"{self.certainty}, if {' and '.join(conditions)}"


def what_to_do(decided: Decided, made: MatrixVerdict, samples: SampledTotals | None = None) -> WhatToDo:
    """Return the answer of a study from the verdict on its drives, and the samples of the feasible combinations."""
    if not made.winners:
        return WhatToDo(sentences=NOBODY, certainty=made.certainty)
    winner = made.winners[0]
    questions, certainty = open_questions(decided, winner), _certainty(decided, made)
    if made.best_shares["intervals"] < DECIDED and certainty is Certainty.OPEN:
        among = best_motors(decided, feasible_combinations(decided), samples)
        assert among is not None
        sentences: tuple[str, ...] = _not_clear(decided, among)
    else:
        sentences = (_action(decided, winner), *_equal(decided, made))
    for question in questions:
        sentences += (f"Open question: {question.sentence()}", *_otherwise(decided, question, samples))
    answer = WhatToDo(
        sentences=sentences, certainty=certainty, questions=questions, figures=_figures(decided, made, certainty)
    )
    return replace(answer, sentences=(*sentences, _how_sure(answer, made)))


def _how_sure(answer: WhatToDo, made: MatrixVerdict) -> str:
    share = 100 * made.best_shares["together"]
    return f"How sure: {answer.certainty_text}; best in {share:.0f} % of the Monte Carlo samples."


def _certainty(decided: Decided, made: MatrixVerdict) -> Certainty:
    """Return the certainty with all open questions about present parts answered in favour of the winner."""
    asked = [one for name in made.winners for one in open_questions(decided, name)]
    if made.certainty is not Certainty.OPEN or not asked or not all(one.is_of_present_parts for one in asked):
        return made.certainty
    return made.certainty_if_met


def _action(decided: Decided, winner: str) -> str:
    made, now = decided.alternatives[winner], decided.alternatives[decided.baseline]
    if winner == decided.baseline:
        return f"Keep {made.drive.candidate.name} as it is, with the filter {made.chain}: {_error_text(made)}."
    return f"{_change(made, now)} the filter {made.chain}: {_error_text(made, now)}, {price_text(made.drive)}."


def _change(made: Alternative, now: Alternative) -> str:
    chosen, present = made.drive.candidate, now.drive.candidate
    if chosen == present:
        return f"Keep {chosen.name} and {'add' if now.chain == 'none' else 'use'}"
    if chosen.motor == present.motor:
        fitted = f"a gearbox of {chosen.ratio_text}" if chosen.parts.stage == "gearbox" else f"{chosen.gearbox}"
        return f"Keep the motor {present.motor}, fit {fitted} and {'add' if now.chain == 'none' else 'use'}"
    return f"Buy {chosen.name} and use"


def _error_text(made: Alternative, now: Alternative | None = None) -> str:
    error = made.drive.chains[made.chain].truth_error
    unit = error.unit.replace("*", " ")
    before = "" if now is None else f"{error_number(now.drive.chains[now.chain].truth_error.value)} -> "
    return f"reading error {before}{error_number(error.value)} {unit}"


def error_number(value: float | None) -> str:
    """Return a reading error with two or three digits: ``0.071``, ``1.25``, ``12``."""
    if value is None:
        return "?"
    return f"{value:.3f}" if 0.01 <= value < 1 else f"{value:.2g}" if value < 0.01 else f"{value:.3g}"


def price_text(drive: DriveResult) -> str:
    """Return the price of the new parts as a part of a sentence."""
    price = drive.margins["price"]
    if price.unknown:
        return "price not known"
    if price.low is None or price.high is None or price.low == price.high:
        return "no cost" if not price.value else f"price {price.value:.0f} EUR"
    return f"price {price.low:.0f} to {price.high:.0f} EUR"


def _equal(decided: Decided, made: MatrixVerdict) -> tuple[str, ...]:
    if len(made.winners) < 2:
        return ()
    other = decided.alternatives[made.winners[1]]
    return (f"{other.drive.candidate.name} with the filter {other.chain} is equally good.",)


def _not_clear(decided: Decided, among: BestMotors) -> tuple[str, ...]:
    return (f"No drive is clearly best: {_undistinguished(decided, among)}", *_ask(among))


def _undistinguished(decided: Decided, among: BestMotors) -> str:
    motors = list(dict.fromkeys(decided.alternatives[name].drive.candidate.motor for name in among.combinations))
    unit = decided.alternatives[among.combinations[0]].drive.disturbance.unit.replace("*", " ")
    low, high = error_number(among.error_low), error_number(among.error_high)
    errors = f"reading error {low} {unit}" if low == high else f"reading error {low} to {high} {unit}"
    return f"{_listed(motors)} cannot be distinguished on published data ({errors})."


def _listed(names: list[str]) -> str:
    named, more = names[:NAMED], len(names) - NAMED
    if more > 0:
        return f"{', '.join(named)} and {more} other{'s' if more > 1 else ''}"
    return " and ".join(", ".join(named).rsplit(", ", 1))


def _ask(among: BestMotors) -> tuple[str, ...]:
    if not among.facts:
        return ()
    fact = among.facts[0].fact.split(", ")[0]
    return (f"Before you buy, ask the maker {'' if fact.startswith('whether ') else 'for the '}{fact}.",)


def _otherwise(decided: Decided, question: OpenQuestion, samples: SampledTotals | None) -> tuple[str, ...]:
    """Return what to do if the answer to a question eliminates the winner."""
    fails = "If not, the requirement" if question.missing.startswith("whether ") else "If it is missed, the requirement"
    out = f"{fails} {question.requirement} eliminates this drive"
    among = best_motors(decided, question.remaining, samples)
    if among is None:
        return (f"{out}, and no other one is left.",)
    if among.is_clear:
        return (f"{out}.", f"Then: {_action(decided, among.combinations[0])}")
    if len(among.combinations) == 1:  # many motors, each with a small share
        return (f"{out}.", f"Then no drive is clearly best; first is {among.combinations[0].replace(' | ', ' with ')}.")
    return (f"{out}.", f"Then {_undistinguished(decided, among)}", *_ask(among))


def _figures(decided: Decided, made: MatrixVerdict, certainty: Certainty) -> tuple[LargeFigure, ...]:
    winner, now = decided.alternatives[made.winners[0]], decided.alternatives[decided.baseline]
    error, today = (one.drive.chains[one.chain].truth_error for one in (winner, now))
    price = winner.drive.margins["price"]
    share = made.best_shares["together"]
    return (
        LargeFigure(
            name="reading error", value=f"{error_number(error.value)} {error.unit.replace('*', ' ')}",
            note=_compared(error, today, is_same=made.winners[0] == decided.baseline),
        ),
        LargeFigure(
            name="price of new parts", value=_price_value(price),
            note="no part is changed" if winner.drive.margins["new_parts"].value == 0 else _parts_note(price),
        ),
        LargeFigure(
            name="best in", value=f"{100 * share:.0f} %",
            note=f"of the Monte Carlo samples of data, points and weights: {certainty}",
        ),
    )  # fmt: skip


def _compared(error: Figure, today: Figure, *, is_same: bool) -> str:
    if is_same or not today.value or error.value is None:
        return "rms of filtered reading minus true load, as today"
    change = 100 * (error.value / today.value - 1)
    return f"rms; today {error_number(today.value)} {today.unit.replace('*', ' ')} ({change:+.0f} %)"


def _price_value(price: Figure) -> str:
    if price.unknown:
        return "not known"
    if price.low is None or price.high is None or price.low == price.high:
        return f"{price.value or price.low or 0:.0f} EUR"
    return f"{price.low:.0f} to {price.high:.0f} EUR"


def _parts_note(price: Figure) -> str:
    return "motor, drive and gearbox, where they are new" if not price.missing else "interval of the class, not a quote"
