"""Search for the additions of the largest posterior odds: each hypothesis alone, then the best ones fitted fully."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import lgamma
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.held_out import HeldOut, held_out
from torquerig.inference.motion.hypotheses import proposals
from torquerig.inference.motion.hypothesis import Hypothesis

Floats = NDArray[np.float64]
Progress = Callable[[str], None]

MOST_ADDITIONS = 10
FITTED = 3  # proposals that are fitted until they converge at a time, until one is accepted
STEPS = 8  # of a proposal with simulated parameters in each stage, before it is compared
LEAST_GAIN, LEAST_HELD_OUT = 8.0, 3.0  # [nats] of a mechanism, as of torquerig.inference.search
WORSE = 1.02  # of the mean square of held-out residuals, 1 % of their rms: more is no improvement in N m
LEAST_OTHER, LEAST_HELD_OUT_OTHER = 3.0, 1.0  # [nats] of an effect without a name
MOST = 0.5  # of the mean square of held-out residuals: a mechanism that predicts more is not a matter of single runs


@dataclass(frozen=True, eq=False)
class Tried:
    """A hypothesis that was fitted: with the model's other additions."""

    hypothesis: Hypothesis
    fit: Fit

    @property
    def log_odds(self) -> float:
        """Log posterior odds of the whole model [nats]."""
        return self.fit.log_odds


@dataclass(frozen=True, eq=False)
class Step:
    """One addition, and what was fitted in its place.

    Parameters
    ----------
    kept : Tried
    gain : float
        Of log posterior odds over the model before [nats].
    others : tuple of (Hypothesis, float)
        By how many nats they are behind, the nearest first.
    """

    kept: Tried
    gain: float
    others: tuple[tuple[Hypothesis, float], ...]


@dataclass(frozen=True, eq=False)
class Found:
    """The completed model: its fit, the steps that led to it, and the proposals of the last round with their gains."""

    fit: Fit
    steps: tuple[Step, ...]
    refused: tuple[tuple[Hypothesis, float], ...]


def searched(nominal: Fit, *, progress: Progress = lambda _: None) -> Found:
    """Return the model with every addition that raises the posterior odds and predicts held-out frames better.

    Mechanisms go first. What they leave is then given to effects without a name. Whatever the model does not need any
    more, a mechanism too, is dropped. At last each addition is compared with all others in its place.
    """
    fit, steps = nominal, list[Step]()
    for _ in range(MOST_ADDITIONS):
        progress(f"comparing hypotheses ({len(fit.model.additions)} in the model)")
        tried = list(_tried(fit))
        step = _accepted(fit, [one for one in tried if one.hypothesis.is_named]) or _accepted(
            fit, [one for one in tried if not one.hypothesis.is_named]
        )
        if step is None:
            break
        fit = _without_needless(step.kept.fit, step.kept.hypothesis.name)
    refused = tuple((one.hypothesis, one.log_odds - fit.log_odds) for one in tried)
    for each in fit.model.additions:
        progress(f"comparing {each.label} with the others in its place")
        fit, step = _in_place(fit, each)
        steps.append(step)
    return Found(fit, tuple(steps), refused)


def _tried(fit: Fit) -> Iterator[Tried]:
    for each in proposals(fit):
        steps = STEPS if each.knobs or each.zeros else 0
        made = fitted(fit.model.plus(each), fit.runs, after=_for(fit, each), steps=steps, bar=fit)
        if made is None:
            continue
        kept = with_needed_orders(made, each)
        if kept is not each:
            if not kept.orders:
                continue
            made = fitted(fit.model.plus(kept), fit.runs, after=_for(fit, kept), steps=0)
        if made is not None and not _refuses(made, kept):
            yield Tried(kept, made)


def _for(fit: Fit, each: Hypothesis) -> Fit:
    """Return the fit to start from, without the positions of an addition that is replaced."""
    taken = {knob.name for knob in each.knobs}
    if not taken & set(fit.names):
        return fit
    names = [f"({name})" if name in taken else name for name in fit.names]
    return replace(fit, names=names, derivatives={k: v for k, v in fit.derivatives.items() if k not in taken})


def _accepted(fit: Fit, tried: Sequence[Tried]) -> Step | None:
    """Return the addition of the largest evidence of all frames that passes, fitted fully; None where none does.

    Held-out frames must become more likely, and their rms residual must not grow: a density that falls at many high
    frequencies can pay for a worse level at a few low ones.
    """
    ranked = sorted(tried, key=lambda one: -one.log_odds)
    passing = [one for one in ranked if one.log_odds - fit.log_odds >= _least(one.hypothesis)[0]]
    before = held_out(fit) if passing else None
    if before is None:
        return None
    for start in range(0, len(passing), FITTED):  # forms of one effect can fill the first places and all be refused
        full = [
            Tried(one.hypothesis, (fitted(one.fit.model, fit.runs, after=one.fit) or one.fit))
            for one in passing[start : start + FITTED]
        ]
        judged = [(one, after) for one in full if (after := held_out(one.fit)) is not None]
        better = [
            (one, after) for one, after in judged
            if after.log_density - before.log_density >= _least(one.hypothesis)[1]
            and after.square <= WORSE * before.square
        ]  # fmt: skip
        if better:
            best = _best(better)
            return Step(best, best.log_odds - fit.log_odds, ())
    return None


def _best(judged: Sequence[tuple[Tried, HeldOut]]) -> Tried:
    """Return the most probable by all frames, of each effect only the forms with its least rms residual in N m.

    A form for a direction that no fit has seen has free sizes there: they make held-out frames more likely, and predict
    nothing. Forms of each run are estimated in held-out runs too; their price is in the density, so that they do not
    set the least residual.
    """
    least: dict[str, float] = {}
    for one, after in judged:
        if not one.hypothesis.local:
            least[one.hypothesis.name] = min(after.square, least.get(one.hypothesis.name, np.inf))
    kept = [
        (one, after) for one, after in judged
        if one.hypothesis.local or after.square <= WORSE * least[one.hypothesis.name]
    ]  # fmt: skip
    return max(kept, key=lambda pair: pair[0].log_odds + pair[1].log_density)[0]


def _without_needless(fit: Fit, last: str) -> Fit:
    """Return the model without the additions that it does not need any more; the last one stays."""
    for each in fit.model.additions:
        if each.name == last:
            continue
        less = fitted(fit.model.minus(each.name), fit.runs, after=fit)
        if less is not None and fit.log_odds - less.log_odds < _least(each)[0]:
            return _without_needless(less, last)
    return fit


def _in_place(fit: Fit, each: Hypothesis) -> tuple[Fit, Step]:
    """Return the fit and the step of an addition, compared with all others in its place; the best one is kept.

    A mechanism that predicts most of the held-out residual is not replaced by sizes that each run must be given.
    """
    less = fitted(fit.model.minus(each.name), fit.runs, after=fit)
    if less is None:
        return fit, Step(Tried(each, fit), 0.0, ())
    tried = sorted(_tried(less), key=lambda one: -one.log_odds)
    present = {one.name for one in less.model.additions}
    stays = each.is_named and _predicts_most(fit, less)
    instead = [
        one for one in tried
        if one.hypothesis.name not in present
        and (one.hypothesis.name, one.hypothesis.variant) != (each.name, each.variant)
        and not (stays and one.hypothesis.local)
    ]  # fmt: skip
    full = [
        Tried(one.hypothesis, fitted(one.fit.model, fit.runs, after=one.fit) or one.fit) for one in instead[:FITTED]
    ]
    here = Tried(each, fit)
    judged = [(one, after) for one in (here, *full) if (after := held_out(one.fit)) is not None]
    kept = here
    if judged and judged[0][0] is here:
        kept = _best([pair for pair in judged if pair[1].square <= WORSE * judged[0][1].square])
    density = {id(one): after.log_density for one, after in judged}
    behind = [
        (one.hypothesis, _gap(kept, one, density)) for one in (here, *full, *instead[FITTED:])
        if one.hypothesis is not kept.hypothesis
    ]  # fmt: skip
    others = sorted(behind, key=lambda pair: pair[1])
    return kept.fit, Step(kept, kept.log_odds - less.log_odds, tuple(others))


def _predicts_most(fit: Fit, less: Fit) -> bool:
    """Return whether a fit predicts most of the held-out residual of a smaller one."""
    after, before = held_out(fit), held_out(less)
    return after is not None and before is not None and after.square < MOST * before.square


def _gap(kept: Tried, other: Tried, density: Mapping[int, float]) -> float:
    """Return by how many nats an alternative is behind; held-out frames may only count against it."""
    held = density.get(id(kept), 0.0)
    return max(kept.log_odds - other.log_odds + max(held - density.get(id(other), held), 0.0), 0.0)


def _least(each: Hypothesis) -> tuple[float, float]:
    return (LEAST_GAIN, LEAST_HELD_OUT) if each.is_named else (LEAST_OTHER, LEAST_HELD_OUT_OTHER)


def _refuses(fit: Fit, each: Hypothesis) -> bool:
    """Return whether a fitted friction is none: a static value that is smaller than the sliding one."""
    for part in fit.rig.parts:
        if part.name in {one.name for one in each.parts} and each.variant == "stribeck":
            held: Any = part
            return bool(held.static < held.coulomb or held.stribeck_speed < held.smoothing)
    return False


def with_needed_orders(fit: Fit, each: Hypothesis) -> Hypothesis:
    """Return a family of lines with the orders alone that pay for themselves; its prior odds with that choice.

    An order is needed where ``1/2 b' C^-1 b`` exceeds what its freedom costs, ``-1/2 ln det C``, with C the covariance
    of its sizes in standard deviations of their priors.
    """
    if len(each.orders) < 2:
        return each
    covariance = fit.covariance
    kept = []
    for number, order in enumerate(each.orders):
        rows = [
            row for row, name in enumerate(fit.names)
            if name.startswith(f"{each.name}[") and int(name[len(each.name) + 1 :].split("]")[0])
            % (2 * len(each.orders)) // 2 == number
        ]  # fmt: skip
        own, sizes = covariance[np.ix_(rows, rows)], fit.positions[rows]
        if 0.5 * float(sizes @ np.linalg.solve(own, sizes)) + 0.5 * float(np.linalg.slogdet(own)[1]) > 1.0:
            kept.append(order)
    if len(kept) == len(each.orders):
        return each
    held: Any = each.columns
    written: Any = each.written
    choices = lgamma(len(each.orders) + 1) - lgamma(len(kept) + 1) - lgamma(len(each.orders) - len(kept) + 1)
    return replace(
        each, orders=tuple(kept), columns=replace(held, orders=tuple(kept)), log_odds=each.log_odds - choices,
        at=kept[0] if kept and not each.is_named else each.at,
        written=None if written is None else replace(written, orders=tuple(kept)),
    )  # fmt: skip
