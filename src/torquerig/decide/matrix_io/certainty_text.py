"""How sure the answer is as plain text: verdict, draws, flips, datum runs, open facts, edits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from torquerig.decide.comparing import Reordering
from torquerig.decide.convergence import Convergence
from torquerig.decide.flips import CommonFlip, FlipScore, FlipWeight
from torquerig.decide.missing import MissingFact
from torquerig.decide.near_miss import NearMiss
from torquerig.decide.pareto import Dominance
from torquerig.decide.robustness import Acceptability
from torquerig.decide.strength import Strength
from torquerig.decide.trace import CellTrace
from torquerig.decide.verdict import MatrixVerdict
from torquerig.plain_table import grid, wrapped

FLIPS = 5  # of the smallest changes of a score that are told


def tell_verdict(verdict: MatrixVerdict) -> str:
    """Return the answer in a sentence."""
    return wrapped(verdict.sentence(), rest="")


def tell_near_misses(near: Sequence[NearMiss]) -> str:
    """Return who was eliminated by a hair, a line each; empty where nobody was."""
    return "\n".join(wrapped(f"near miss: {one.sentence()}", rest="    ") for one in near)


def tell_pareto(found: Dominance) -> str:
    """Return who is dominated by whom, and who is in the Pareto set."""
    told = [f"in the Pareto set: {', '.join(found.efficient) or 'nobody for sure'}"]
    if found.open:
        told.append(f"in it or not, by facts that are open: {', '.join(found.open)}")
    told += [f"dominated: {name}, by {', '.join(others)}" for name, others in found.dominated.items()]
    return "\n".join(wrapped(one) for one in told)


def tell_convergence(found: Convergence, circles: Sequence[tuple[str, ...]]) -> str:
    """Return the log of datums, what each run says to do next, and wins that run round."""
    told = []
    for number, step in enumerate(found.steps, start=1):
        net = str(step.net_low) if step.net_low == step.net_high else f"{step.net_low}..{step.net_high}"
        parts = [f"run {number}: datum {step.datum}"]
        if step.strongest == step.datum:
            parts.append("nobody is stronger")
        else:
            parts.append(f"strongest is {step.strongest} (net {net})")
            parts.append(f"attack its negatives: {', '.join(step.negatives) or 'it has none'}")
        if step.weak:
            parts.append(f"never better than the datum, to be dropped: {', '.join(step.weak)}")
        if step.undiscriminating:
            parts.append(f"the same for all: {', '.join(step.undiscriminating)}")
        told.append("; ".join(parts))
    if found.stands:
        told.append(f"the datum stands: {found.stands}{'' if found.sure else ', as far as the known signs go'}")
    else:
        told.append(f"no datum stands; they follow each other in a circle: {_round(found.circle)}")
    told += [f"sure wins run in a circle: {_round(one)}" for one in circles]
    return "\n".join(wrapped(one, rest="    ") for one in told)


def tell_strength(found: Strength) -> str:
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


def tell_acceptability(found: Mapping[str, Acceptability]) -> str:
    """Return how often each is best by what is in doubt, and how often it takes each rank over all of it."""
    together = found["together"]
    best = [
        [name, *(f"{one.p_best[row]:.1%}" for one in found.values()), f"{together.mean_rank[row]:.2f}"]
        for row, name in enumerate(together.alternatives)
    ]
    ranks = [
        [name, *(f"{share:.1%}" for share in together.shares[row].tolist())]
        for row, name in enumerate(together.alternatives)
    ]
    doubt = together.doubt
    drawn = (
        f"{together.draws} draws, seed {together.seed}: intervals of the facts, points +-{doubt.scores:g}, "
        f"weights +-{doubt.weights:.0%}"
    )
    return "\n".join(
        [
            drawn,
            grid([["best in", *(f"by {name}" for name in found), "mean rank"], *best]),
            "",
            grid([["takes rank", *(str(place + 1) for place in range(len(ranks)))], *ranks]),
        ]
    )


def tell_flips(weights: Sequence[FlipWeight], scores: Sequence[FlipScore], common: CommonFlip | None) -> str:
    """Return the exact weights and the smallest changes of scores at which another one wins."""
    if common is None:
        return "one alternative has no rival"
    told = [
        f"weight of {one.criterion!r}: {one.weight:g} as given, at {one.flip:.3g} {one.rival} ties with {one.winner}"
        for one in weights
        if one.flip is not None
    ] or ["no single weight of at least 0 lets anybody catch up"]
    reached = [one for one in scores if one.flip is not None]
    told += [
        f"points of {one.alternative} for {one.criterion!r}: {one.points:.3g}, at {one.flip:.3g} ({one.change:+.3g}) "
        f"{one.rival} ties with {one.winner}"
        for one in reached[:FLIPS]
    ] or ["no single cell's points within the scale let anybody catch up"]
    told.append(
        "even all points off by the whole scale change nothing" if common.scores is None
        else f"all points at once: off by {common.scores:.3g}, {common.score_rival} can catch up"
    )  # fmt: skip
    told.append(
        "weights may all be off by 100 % of themselves" if common.weights is None
        else f"all weights at once: off by {common.weights:.1%} of themselves, {common.weight_rival} can catch up"
    )  # fmt: skip
    return "\n".join(wrapped(one, rest="    ") for one in told)


def tell_missing(facts: Sequence[MissingFact]) -> str:
    """Return what to ask for, the most useful first; what cannot change the winner alone is only named."""
    decisive = [one for one in facts if one.decisive]
    told = [
        f"{place}. {one.sentence()}; worth {one.gain:.4f} in T/T_max" for place, one in enumerate(decisive, start=1)
    ]
    rest = [one.fact for one in facts if not one.decisive]
    if rest:
        told.append(f"alone these cannot change the winner: {'; '.join(rest)}")
    return "\n".join(wrapped(one, rest="   ") for one in told) or "nothing is missing"


def tell_trace(one: CellTrace) -> str:
    """Return the way of one cell from the catalog to the verdict, a line per step."""
    width = max(len(label) for label, _ in one.steps)
    lines = [wrapped(f"{label.ljust(width)}  {text}", first="  ", rest=" " * (width + 4)) for label, text in one.steps]
    return "\n".join([f"{one.alternative} / {one.criterion}", *lines])


def tell_reordering(found: Reordering) -> str:
    """Return what was changed and what it did."""
    told = [f"{one.key}: {_entry(one.before)} -> {_entry(one.after)}" for one in found.edits] or ["nothing was changed"]
    before, after = (" and ".join(names) or "nobody" for names in (found.winners_before, found.winners_after))
    told.append(f"in front before and after: {before}" if before == after else f"in front: {before} -> {after}")
    told += [f"rank of {name}: {_entry(old)} -> {_entry(new)}" for name, old, new in found.ranks]
    told += [f"{second} has overtaken {first}" for first, second in found.reversed_pairs]
    return "\n".join(wrapped(one, rest="    ") for one in told)


def _range(value: float, low: float, high: float) -> str:
    return f"{value:.3f}" if high - low < 5e-4 else f"{value:.3f} ({low:.3f}..{high:.3f})"


def _round(names: Sequence[str]) -> str:
    return " > ".join((*names, names[0]))


def _entry(value: object) -> str:
    return "(none)" if value is None else str(value)
