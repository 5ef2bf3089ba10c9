"""The answer of a decision matrix: sentences of at most 25 words and three large figures."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.eliminate import Decision
from torquerig.decide.matrix_analysis import MatrixAnalysis
from torquerig.decide.verdict import DECIDED, Certainty
from torquerig.study.answer.what_to_do import LargeFigure

TONES = {Certainty.ROBUST: "good", Certainty.TIE: "good", Certainty.FRAGILE: "poor", Certainty.NOBODY: "poor"}
"""CSS class of the answer: blue, orange, and violet for an open one."""


@dataclass(frozen=True, kw_only=True)
class MatrixAnswer:
    """What the first screen of a matrix shows."""

    sentences: tuple[str, ...]
    figures: tuple[LargeFigure, ...]
    tone: str


def matrix_answer(worked: MatrixAnalysis) -> MatrixAnswer:
    """Return what to choose, what is open with the other branch, and how sure it is."""
    verdict = worked.verdict
    tone = TONES.get(verdict.certainty, "open")
    if not verdict.winners:
        none = ("No alternative meets the requirements.", "The elimination shows by how much each one misses.")
        return MatrixAnswer(sentences=none, figures=(), tone=tone)
    share = 100 * verdict.best_shares["together"]
    sure = f"How sure: {verdict.certainty}; best in {share:.0f} % of the Monte Carlo samples."
    return MatrixAnswer(sentences=(_choice(worked), *_open(worked), sure), figures=_figures(worked, share), tone=tone)


def _choice(worked: MatrixAnalysis) -> str:
    verdict = worked.verdict
    first = verdict.winners[0]
    if len(verdict.winners) > 1:
        return f"Choose {' or '.join(verdict.winners[:2])}: they have the same T."
    if verdict.certainty is Certainty.OPEN and verdict.best_shares["intervals"] < DECIDED:
        return f"No alternative is clearly best: missing values decide. First is {first}."
    if not verdict.runner_up:
        return f"Choose {first}: no other alternative meets the requirements."
    condition = " if its open requirement is met" if verdict.conditions else ""
    scores = dict(zip(worked.overall.alternatives, worked.overall.share.tolist(), strict=True))
    best, second = scores[first], scores[verdict.runner_up]
    return f"Choose {first}{condition}: score {best:.2f} of 1, against {second:.2f} of {verdict.runner_up}."


def _open(worked: MatrixAnalysis) -> tuple[str, ...]:
    questions = [one.partition(": ")[2] for one in worked.verdict.conditions]
    if questions:
        more = f" and {len(questions) - 1} more" if len(questions) > 1 else ""
        return (f"Open question: {questions[0]}{more}.", f"If the requirement is missed, {_next(worked)}.")
    if worked.verdict.certainty is Certainty.OPEN and worked.missing:
        return (f"{worked.missing[0].sentence().partition(':')[0].capitalize()} first.",)
    return ()


def _next(worked: MatrixAnalysis) -> str:
    out = {*worked.chart.with_decision(Decision.ELIMINATE), *worked.verdict.winners}
    totals = zip(worked.overall.total.tolist(), worked.overall.alternatives, strict=True)
    ranked = sorted(((-total, name) for total, name in totals if name not in out), key=lambda one: one[0])
    return f"choose {ranked[0][1]}" if ranked else "no alternative is left"


def _figures(worked: MatrixAnalysis, share: float) -> tuple[LargeFigure, ...]:
    overall, verdict = worked.overall, worked.verdict
    place = overall.alternatives.index(verdict.winners[0])
    low, high = (float(ends[place]) / overall.ideal for ends in (overall.total_low, overall.total_high))
    return (
        LargeFigure(name="score T/T_max", value=f"{overall.share[place]:.3f}",
                    note=f"weighted points over the ideal; range {low:.2f} to {high:.2f}"),
        LargeFigure(name="lead", value=f"{verdict.lead:.3f}",
                    note=f"ahead of {verdict.runner_up}" if verdict.runner_up else "no other alternative"),
        LargeFigure(name="best in", value=f"{share:.0f} %",
                    note="of the Monte Carlo samples of values, points and weights"),
    )  # fmt: skip
