"""How sure the answer of a study is: sentences and the table of the uncertainty budget."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.decide.verdict import Certainty
from torquerig.reporting.layout import Cell, Table, number, words

if TYPE_CHECKING:
    from torquerig.study.answer.uncertainty_budget import UncertaintyBudget
    from torquerig.study.answer.uncertainty_item import Item
    from torquerig.study.load_randomness import LoadRandomness
    from torquerig.study.verdict import Verdict

TONES = {Certainty.ROBUST: "good", Certainty.FRAGILE: "poor", Certainty.TIE: "good", Certainty.NOBODY: "poor"}
"""CSS class of the answer: blue, orange, and violet for an open one."""


def sure_sentences(verdict: Verdict, budget: UncertaintyBudget | None, load: LoadRandomness | None) -> tuple[str, ...]:
    """Return the paragraphs of the section "How sure is this?"."""
    shares = verdict.best_shares
    sampled = tuple(
        f"{name}: {100 * shares[key]:.0f} %"
        for key, name in (("intervals", "data alone"), ("scores", "points alone"), ("weights", "weights alone"))
        if key in shares
    )
    return tuple(
        one
        for one in (
            f"Verdict: {verdict.answer.certainty_text}.",
            "" if budget is None else budget.sentence(),
            *verdict.remarks,
            f"Share of the Monte Carlo samples in which the drive is best: {', '.join(sampled)}." if sampled else "",
            "" if load is None else load.sentence(),
        )
        if one
    )


def budget_table(budget: UncertaintyBudget) -> Table:
    """Return the items of a budget with type and standard uncertainty, their combination and expansion."""
    unit = budget.unit.replace("*", " ")
    rows = [
        (*words(one.name, one.kind), number(_shown(one)), *words(one.basis or one.remedy, one.source))
        for one in budget.items
    ]
    rows += [
        _total("combined", f"{budget.combined:.4f}", "root of the sum of squares of the known items"),
        _total("expanded, k = 2", f"{budget.expanded:.3f}", "about 95 % of a normal distribution"),
    ]
    return Table(
        caption=f"Uncertainty of one reading of {budget.drive} with the filter {budget.chain}, after the GUM",
        head=("item", "type", f"standard uncertainty [{unit}]", "basis, or what is missing", "source"),
        rows=tuple(rows), emphasised=frozenset({len(rows) - 1}),
        note="Type A: from repeated observations; type B: from other knowledge. An item that is not known is not zero: "
        "the combination leaves it out. In brackets: contained in another item.",
    )  # fmt: skip


def _total(name: str, text: str, basis: str) -> tuple[Cell, ...]:
    return (*words(name, ""), number(text), *words(basis, ""))


def _shown(one: Item) -> str:
    if one.standard is None:
        return "?"
    return f"{one.standard:.4f}" if one.is_counted else f"({one.standard:.4f})"
