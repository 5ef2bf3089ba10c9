"""Certainty of the answer as plain text: verdict, rank shares, flips, baseline runs, open facts, edits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from torquerig.decide.convergence import Convergence
from torquerig.decide.flips import CommonFlip, FlipScore, FlipWeight
from torquerig.decide.near_miss import NearMiss
from torquerig.decide.pareto import Dominance
from torquerig.decide.robustness import RankAcceptability
from torquerig.decide.strength import Strength
from torquerig.decide.trace import CellTrace
from torquerig.decide.value_of_information import MissingFact
from torquerig.decide.verdict import MatrixVerdict
from torquerig.decide.version_comparison import RankingChanges
from torquerig.plain_table import grid, wrapped

FLIPS = 5  # of the smallest changes of a score that are listed


def verdict_text(verdict: MatrixVerdict) -> str:
    """Return the verdict in sentences."""
    return wrapped(verdict.sentence(), rest="")


def near_misses_text(near: Sequence[NearMiss]) -> str:
    """Return the alternatives that were eliminated narrowly, a line each; empty where there is none."""
    return "\n".join(wrapped(f"near miss: {one.sentence()}", rest="    ") for one in near)


def pareto_text(found: Dominance) -> str:
    """Return the Pareto set and the dominated alternatives."""
    lines = [f"in the Pareto set: {', '.join(found.efficient) or 'no alternative for certain'}"]
    if found.open:
        lines.append(f"in it or not, depending on open facts: {', '.join(found.open)}")
    lines += [f"dominated: {name}, by {', '.join(others)}" for name, others in found.dominated.items()]
    return "\n".join(wrapped(one) for one in lines)


def convergence_text(found: Convergence, cycles: Sequence[tuple[str, ...]]) -> str:
    """Return the log of baselines, what each run suggests, and cycles of wins."""
    lines = []
    for number, step in enumerate(found.steps, start=1):
        net = str(step.net_low) if step.net_low == step.net_high else f"{step.net_low}..{step.net_high}"
        parts = [f"run {number}: baseline {step.baseline}"]
        if step.strongest == step.baseline:
            parts.append("no alternative is stronger")
        else:
            parts.append(f"strongest is {step.strongest} (net {net})")
            parts.append(f"improve where it is worse: {', '.join(step.negatives) or 'nowhere'}")
        if step.weak:
            parts.append(f"never better than the baseline, to be dropped: {', '.join(step.weak)}")
        if step.undiscriminating:
            parts.append(f"the same for all: {', '.join(step.undiscriminating)}")
        lines.append("; ".join(parts))
    if found.stable:
        lines.append(f"stable baseline: {found.stable}{'' if found.sure else ', by the known signs only'}")
    else:
        lines.append(f"no stable baseline; they follow each other in a cycle: {_round(found.cycle)}")
    lines += [f"certain wins form a cycle: {_round(one)}" for one in cycles]
    return "\n".join(wrapped(one, rest="    ") for one in lines)


def strength_text(found: Strength) -> str:
    """Return technical x, economic y, both means and the guide value of each alternative."""
    low, high = found.hyperbolic_range
    body = [
        [
            name, _range(found.technical.value[row], found.technical.low[row], found.technical.high[row]),
            _range(found.economic.value[row], found.economic.low[row], found.economic.high[row]),
            f"{found.arithmetic[row]:.3f}", _range(found.hyperbolic[row], low[row], high[row]), word,
        ]
        for row, (name, word) in enumerate(zip(found.alternatives, found.grades(), strict=True))
    ]  # fmt: skip
    return grid([["", "technical x", "economic y", "(x+y)/2", "sqrt(x y)", "technically"], *body])


def acceptability_text(found: Mapping[str, RankAcceptability]) -> str:
    """Return the share of samples in which each is best, by source of uncertainty, and in which it takes each rank."""
    together = found["together"]
    best = [
        [name, *(f"{one.p_best[row]:.1%}" for one in found.values()), f"{together.mean_rank[row]:.2f}"]
        for row, name in enumerate(together.alternatives)
    ]
    ranks = [
        [name, *(f"{share:.1%}" for share in together.shares[row].tolist())]
        for row, name in enumerate(together.alternatives)
    ]
    uncertainty = together.uncertainty
    drawn = (
        f"{together.draws} Monte Carlo samples, random seed {together.seed}: intervals of the facts, "
        f"points +-{uncertainty.scores:g}, weights +-{uncertainty.weights:.0%}"
    )
    return "\n".join(
        [
            drawn,
            grid([["best in", *(f"by {name}" for name in found), "mean rank"], *best]),
            "",
            grid([["takes rank", *(str(place + 1) for place in range(len(ranks)))], *ranks]),
        ]
    )


def flips_text(weights: Sequence[FlipWeight], scores: Sequence[FlipScore], common: CommonFlip | None) -> str:
    """Return the exact weights and the smallest changes of scores at which another one wins."""
    if common is None:
        return "there is only one alternative"
    lines = [
        f"weight of {one.criterion!r}: {one.weight:g} as given, at {one.flip:.3g} {one.other} ties with {one.winner}"
        for one in weights
        if one.flip is not None
    ] or ["no single weight of at least 0 changes the winner"]
    reached = [one for one in scores if one.flip is not None]
    lines += [
        f"points of {one.alternative} for {one.criterion!r}: {one.points:.3g}, at {one.flip:.3g} ({one.change:+.3g}) "
        f"{one.other} ties with {one.winner}"
        for one in reached[:FLIPS]
    ] or ["no single cell's points within the scale change the winner"]
    lines.append(
        "even an error of all points by the whole scale does not change the winner" if common.scores is None
        else f"all points at once: with an error of {common.scores:.3g}, {common.first_by_scores} can reach it"
    )  # fmt: skip
    lines.append(
        "even an error of all weights by 100 % does not change the winner" if common.weights is None
        else f"all weights at once: with an error of {common.weights:.1%}, {common.first_by_weights} can reach it"
    )  # fmt: skip
    return "\n".join(wrapped(one, rest="    ") for one in lines)


def missing_facts_text(facts: Sequence[MissingFact]) -> str:
    """Return the missing facts, the most useful first; those that cannot change the winner alone are only named."""
    decisive = [one for one in facts if one.decisive]
    lines = [
        f"{place}. {one.sentence()}; worth {one.gain:.4f} in T/T_max" for place, one in enumerate(decisive, start=1)
    ]
    others = [one.fact for one in facts if not one.decisive]
    if others:
        lines.append(f"alone these cannot change the winner: {'; '.join(others)}")
    return "\n".join(wrapped(one, rest="   ") for one in lines) or "nothing is missing"


def trace_text(one: CellTrace) -> str:
    """Return the trace of one cell from the catalog to the verdict, a line per step."""
    width = max(len(label) for label, _ in one.steps)
    lines = [wrapped(f"{label.ljust(width)}  {text}", first="  ", rest=" " * (width + 4)) for label, text in one.steps]
    return "\n".join([f"{one.alternative} / {one.criterion}", *lines])


def ranking_changes_text(found: RankingChanges) -> str:
    """Return the edits and the changes of the ranking."""
    lines = [f"{one.key}: {_entry(one.before)} -> {_entry(one.after)}" for one in found.edits] or [
        "nothing was changed"
    ]
    before, after = (" and ".join(names) or "none" for names in (found.winners_before, found.winners_after))
    lines.append(
        f"ranked first before and after: {before}" if before == after else f"ranked first: {before} -> {after}"
    )
    lines += [f"rank of {name}: {_entry(old)} -> {_entry(new)}" for name, old, new in found.ranks]
    lines += [f"{second} now ranks above {first}" for first, second in found.reversed_pairs]
    return "\n".join(wrapped(one, rest="    ") for one in lines)


def _range(value: float, low: float, high: float) -> str:
    return f"{value:.3f}" if high - low < 5e-4 else f"{value:.3f} ({low:.3f}..{high:.3f})"


def _round(names: Sequence[str]) -> str:
    return " > ".join((*names, names[0]))


def _entry(value: object) -> str:
    return "(none)" if value is None else str(value)
