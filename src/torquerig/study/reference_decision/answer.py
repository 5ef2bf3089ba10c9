"""The motor to buy or keep, its confidence, and the motor that the report buys."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from torquerig.decide.eliminate import eliminate
from torquerig.decide.kesselring import Profile, kesselring
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.matrix_table import Method
from torquerig.decide.robustness import robustness
from torquerig.decide.verdict import MatrixVerdict, verdict_of
from torquerig.study.rated_drives import feasible_combinations, rated_drives
from torquerig.study.reference_decision.cell_comparison import ComparedTable
from torquerig.study.reference_decision.plan import Plan, real_name
from torquerig.study.scoring import Decided

DRAWS = 10_000
MOST_FACTS = 5


@dataclass(frozen=True, kw_only=True)
class Answer:
    """The answer to the report's question.

    Parameters
    ----------
    published, published_text : str
        The motor that the report buys (the catalog's name), and the printed sum behind it.
    chosen : str
        The best combination by the study's criteria.
    keeps : bool
        Whether that is the present motor.
    keeps_share : float
        Share of Monte Carlo samples in which the best drive has the present motor, on any gearbox [1].
    overall : MatrixVerdict
        Over every drive with its best filter.
    bought : MatrixVerdict
        The same without the present motor.
    table : mapping of str to MatrixVerdict
        The report's own rated table, computed: with its printed weights, and with the missing weight on the goal.
    conditions : tuple of str
        Demands on the chosen one that are still open.
    missing : tuple of str
        The most useful missing values.
    """

    published: str
    published_text: str
    chosen: str
    keeps: bool
    keeps_share: float
    overall: MatrixVerdict
    bought: MatrixVerdict
    table: Mapping[str, MatrixVerdict]
    conditions: tuple[str, ...]
    missing: tuple[str, ...]

    def sentences(self) -> tuple[str, ...]:
        """Return the answer as sentences: the report's choice, the computed one, and the best new motor."""
        action = f"keep the present motor, as {self.chosen}" if self.keeps else f"buy {self.chosen}"
        if self.conditions:
            action = f"if the open requirements are met ({'; '.join(self.conditions)}), {action}"
        return (
            f"The report buys {self.published} ({self.published_text}).",
            (f"Computed: {action}. The verdict is {self.overall.certainty}. It is best in {_share(self.overall)}. In "
            f"{self.keeps_share:.0%} of the samples the best drive has the present motor, on this or another gearbox."),
            self._bought_sentence(),
            *(f"{name}: {_verdict_text(one)}" for name, one in self.table.items()),
        )  # fmt: skip

    def _bought_sentence(self) -> str:
        """Return the best motor where the present one is excluded."""
        if not self.bought.winners:
            return "No new motor meets the requirements."
        named = " (the one that the report names)" if self.published in self.bought.winners[0] else ""
        winners = " and ".join(self.bought.winners).replace(" | ", " with the filter ")
        runner_up = f"; the next is {self.bought.runner_up.replace(' | ', ' with ')}" if self.bought.runner_up else ""
        return (
            f"If a new motor must be bought, the best is {winners}{named}. The verdict is "
            f"{self.bought.certainty}: It is the best new one in {_share(self.bought)}{runner_up}."
        )


def answer(plan: Plan, tables: tuple[ComparedTable, ...], decided: Decided) -> Answer:
    """Return the answer from the study's decision and the report's rated table."""
    names = feasible_combinations(decided)
    present = real_name(plan.study.catalog, plan.study.settings.present.motor)
    motors = {name: decided.alternatives[name].drive.candidate.motor for name in names}
    new = [name for name in names if motors[name] != present]
    empty = verdict_of(decided.chart, None, {})
    every, bought = (rated_drives(decided, one) if one else None for one in (names, new))
    overall = every.verdict if every else empty
    chosen = overall.winners[0] if overall.winners else ""
    rated = [one for one in tables if one.table.sheet.method is Method.KESSELRING]
    published, text = _published(plan, rated)
    return Answer(
        published=published,
        published_text=text,
        chosen=chosen.replace(" | ", " with the filter "),
        keeps=motors.get(chosen) == present,
        keeps_share=sum(every.combinations["together"].best_share(name) for name in names if name not in new)
        if every
        else 0.0,
        overall=overall,
        bought=bought.verdict if bought else empty,
        table={name: found for one in rated for name, found in _rated(plan, one).items()},
        conditions=tuple(dict.fromkeys(one.partition(": ")[2] for one in overall.conditions)),
        missing=tuple(
            f"{one.fact} ({one.p_change:.0%} of its range make another new motor the best)"
            for one in (bought.facts if bought else ())[:MOST_FACTS]
            if one.decisive
        ),
    )


def _verdict(matrix: DecisionMatrix, profile: Profile) -> MatrixVerdict:
    result = kesselring(matrix, profile=profile)
    return verdict_of(eliminate(matrix), result, robustness(matrix, profile=profile, draws=DRAWS))


def _rated(plan: Plan, one: ComparedTable) -> dict[str, MatrixVerdict]:
    """Return the verdicts of a rated table: with the printed weights, with the missing weight, and of new motors.

    New motors are all but the present one.
    """
    sheet, matrix = one.table.sheet, one.table.matrix
    added = list(one.table.planned.missing)
    kept = tuple(criterion for criterion in matrix.criteria if criterion.name not in added)
    cells = {key: cell for key, cell in matrix.cells.items() if key[1] not in added}
    plain = DecisionMatrix(name=matrix.name, alternatives=matrix.alternatives, criteria=kept, cells=cells)
    found = {f"{sheet.name} computed with its printed weights": _verdict(plain, sheet.profile)}
    whole = f"{sheet.name} computed"
    if added:
        weight = next(criterion.weight for criterion in matrix.criteria if criterion.name in added)
        whole = f"{sheet.name} computed with the missing {weight:g} on {added[0]}"
        found[whole] = _verdict(matrix, sheet.profile)
    present = real_name(plan.study.catalog, plan.study.settings.present.motor)
    new = [name for name in matrix.alternatives if real_name(plan.study.catalog, name) != present]
    if len(new) < len(matrix.alternatives):
        found[f"{whole}, new motors only"] = _verdict(matrix.only(alternatives=new), sheet.profile)
    return found


def _published(plan: Plan, rated: list[ComparedTable]) -> tuple[str, str]:
    """Return the motor with the highest printed sum of the rated table, and that sum as text."""
    if not rated:
        return "", "no rated table"
    sheet = rated[0].table.sheet
    best = max((value, name) for value, name in zip(sheet.sums, sheet.alternatives, strict=True) if value is not None)
    ideal = f" of {sheet.ideal_sum:g}" if sheet.ideal_sum else ""
    return real_name(plan.study.catalog, best[1]), f"{sheet.name}, {best[0]:g}{ideal} printed"


def _verdict_text(verdict: MatrixVerdict) -> str:
    return f"{' and '.join(verdict.winners)} first, {verdict.certainty}, best in {_share(verdict)}."


def _share(verdict: MatrixVerdict) -> str:
    if not verdict.best_shares:
        return "no sample"
    alone = ", ".join(f"{one:.0%} over {name}" for name, one in verdict.best_shares.items() if name != "together")
    return f"{verdict.best_shares['together']:.0%} of the Monte Carlo samples ({alone})"
