"""Search for the additions of the largest posterior odds: screened by the local model, then fitted together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.addition import Addition
from torquerig.inference.additions import proposals
from torquerig.inference.context import Context
from torquerig.inference.discrepancy import log_prior
from torquerig.inference.dropped import without_needless
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.fit import Data, Fit, finished, sketch_error, sketched
from torquerig.inference.held_out import held_out_density
from torquerig.inference.model import Model, lacks
from torquerig.inference.one_number import FAR, MOVED, moved_lines
from torquerig.inference.refitted import refitted
from torquerig.inference.screening import begins_at, screened
from torquerig.inference.undecided_lines import column_of
from torquerig.parallel import parallel_map

Floats = NDArray[np.float64]
Progress = Callable[[str], None]

MOST_ADDITIONS = 8
FITTED = 5  # of the proposals of one round that are fitted together with the model
_NUMBERS = 2  # of these that are numbers, where others wait: what is promised of a number is the most that it may gain
LEAST_GAIN = 8.0  # [nats] of posterior odds by which an addition must win, 3000 to 1: the library is never complete
LEAST_HELD_OUT = 3.0  # [nats] by which it must make the held-out data more likely
LEAST_OTHER, LEAST_HELD_OUT_OTHER = 3.0, 1.0  # [nats] of a nameless effect, in their sum; of a number the first
_AS_WELL = 3.0  # [nats] 20 to 1: less far behind, no hypothesis is excluded


def searched(
    start: Fit, data: Data, held: Data, lines: Sequence[FoundLine], *, progress: Progress = lambda _: None
) -> Model:
    """Return the model to which additions lead, one at a time, each the best of its round.

    Parameters
    ----------
    start : Fit
        Of the nominal rig.
    data, held : Data
        Features of the fitted and of the held-out blocks.
    lines : sequence of FoundLine
    """
    model = Model(start, (), tuple(lines))
    while len(model.additions) < MOST_ADDITIONS:
        better, tried = _extended(model, data, held)
        if better is None:
            return replace(model, tried=tried)
        model = without_needless(better, data, lines, wins=partial(_still_wins, held=held))
        progress(f"adding {model.additions[-1].label}")
    return model


def _extended(model: Model, data: Data, held: Data) -> tuple[Model | None, tuple[tuple[Addition, float], ...]]:
    """Return the model with the best addition, None where none wins; and what all proposals promised."""
    moved = moved_lines(model.fit, data)
    lacking = (line for line in model.lines if lacks(model.fit, data, line.place) and line.place not in moved)
    context = Context(model.fit, data, (*(FoundLine(one, 0.0, 0.0) for one in moved), *lacking), frozenset(moved))
    taken = frozenset[str]().union(*(each.names for each in model.additions))
    free = [each for each in proposals(context) if not each.names & taken]
    gains = parallel_map(lambda each: screened(context, each), free)
    ranked = sorted(((*gain, each) for gain, each in zip(gains, free, strict=True)), key=lambda one: -one[0])
    tried = tuple((each, gain) for gain, _, each in ranked)
    slack = -log_prior(model.fit.off)  # that an addition gets back when it makes the discrepancy smaller
    passing = [(each, start) for gain, start, each in ranked if gain > -slack]
    passing += [(each, start) for gain, start, each in ranked if gain <= -slack and is_instead(each, passing, data)]
    fits = _fitted(model, data, passing)
    best, others = _best([_Candidate.of(one, held) for one in fits], model, data, held)
    if best is None:
        return None, tried
    added = best.model.additions[-1]
    # one of better odds failed on the held-out data and is no alternative
    behind = [(added, one.added, max(best.odds - one.odds, 0.0)) for one in others
              if one.odds <= best.odds + _economy(best, one, data) and competes(added, one.added, data)]  # fmt: skip
    return replace(best.model, alternatives=(*model.alternatives, *behind)), tried


class _Candidate(NamedTuple):
    """A model with one more addition, and the log-likelihood of the held-out data under it [nats]."""

    model: Model
    held_out: float

    @staticmethod
    def of(model: Model, held: Data) -> _Candidate:
        return _Candidate(model, held_out_density(model.fit, held))

    @property
    def added(self) -> Addition:
        return self.model.additions[-1]

    @property
    def odds(self) -> float:
        """Posterior log-odds given fitted and held-out data (chain rule of probability)."""
        return self.model.log_odds + self.held_out


def _best(
    sketches: Sequence[_Candidate], model: Model, data: Data, held: Data
) -> tuple[_Candidate | None, list[_Candidate]]:  # fmt: skip
    """Return the winner of the largest odds, None where none wins, and the others.

    In the order of their odds, the fits of those are finished that may win.
    """
    before = held_out_density(model.fit, held)
    best, others = None, list[_Candidate]()
    for sketch in sorted(sketches, key=lambda one: -one.odds):
        gain, total = sketch.model.log_odds - model.log_odds, sketch.odds - model.log_odds - before
        error, (least, _, both) = sketch_error(total), _needed(sketch.added)
        loses = gain <= least - error or (bool(sketch.added.parts) and total <= both - error)
        if loses or (best is not None and sketch.odds + _economy(sketch, best, data) <= best.odds - error):
            others.append(sketch)
            continue
        one = _Candidate.of(replace(sketch.model, fit=finished(sketch.model.fit, data)), held)
        gain = one.model.log_odds - model.log_odds
        fits = [each.model for each in sketches]
        is_ahead = gain > least and (best is None or one.odds + _economy(one, best, data) > best.odds)
        if is_ahead and wins(
            one.added, odds=gain, held_out=one.held_out - _compared(model.fit, one.model, data, held, before, fits=fits)
        ):
            others += [] if best is None else [best]
            best = one
        else:
            others.append(one)
    return best, others


def _economy(one: _Candidate, other: _Candidate, data: Data) -> float:
    """Return by how many nats a candidate may be behind another and still be preferred.

    A name is a claim of economy: it does as well as nameless effects with fewer numbers, for the same features.
    """
    named, nameless = one.added, other.added
    is_name = named.is_named and _is_nameless(nameless) and len(named.knobs) < len(nameless.knobs)
    return _AS_WELL if is_name and competes(named, nameless, data) else 0.0


def wins(added: Addition, *, odds: float, held_out: float) -> bool:
    """Return whether an addition wins by its gains of posterior odds and of the held-out likelihood [nats].

    No fit has seen the held-out data, so that both together are the odds given all data. They must reach what is needed
    in both, whichever of them they come from; each must speak for an effect without a name, and clearly for others.
    """
    gains = odds, held_out, odds + held_out
    return all(gain > least for gain, least in zip(gains, _needed(added), strict=True))


def _needed(added: Addition) -> tuple[float, float, float]:
    """Return by how much an addition must win in the odds, on the held-out data, and in their sum [nats]."""
    if _is_nameless(added):
        return 0.0, 0.0, LEAST_OTHER + LEAST_HELD_OUT_OTHER
    return LEAST_OTHER, LEAST_HELD_OUT, LEAST_GAIN + LEAST_HELD_OUT if added.is_named else 0.0


def _is_nameless(added: Addition) -> bool:
    return bool(added.parts) and not added.is_named


def _still_wins(each: Addition, model: Model, less: Model, *, held: Data) -> bool:
    """Return whether an addition wins in a model that has others, compared with the one without it."""
    held_out = held_out_density(model.fit, held) - held_out_density(less.fit, held)
    return wins(each, odds=model.log_odds - less.log_odds, held_out=held_out)


def competes(one: Addition, other: Addition, data: Data) -> bool:
    """Return whether two additions explain the same thing; of lines at other places both may be there."""
    rows, others = (
        {(run, column_of(seen, place)) for run, seen in enumerate(data.seen) for place in each.places}
        for each in (one, other)
    )
    return not rows or not others or not rows.isdisjoint(others)


def is_instead(each: Addition, passing: Sequence[tuple[Addition, tuple[float, ...]]], data: Data) -> bool:
    """Return whether a mechanism explains lines of the first hypothesis: it is fitted also where its start is poor."""
    first = passing[0][0] if passing else None
    return first is not None and each.is_named and bool(each.places and first.places) and competes(first, each, data)


def _explained(one: Model, fits: Sequence[Model]) -> frozenset[str]:
    """Return the other numbers of a round that are near their stated values in a model with its last addition."""
    numbers = frozenset[str]().union(*(each.additions[-1].names for each in fits if not each.additions[-1].parts))
    at = zip(one.fit.knobs, one.fit.positions.tolist(), strict=True)
    return frozenset(knob.name for knob, position in at if abs(position) < FAR) & numbers - one.additions[-1].names


def _brought_back(before: Fit, after: Fit) -> frozenset[str]:
    """Return the numbers that have moved far in one fit and are near their stated values in another."""
    far = {knob.name for knob, at in zip(before.knobs, before.positions.tolist(), strict=True) if abs(at) > MOVED}
    near = {knob.name for knob, at in zip(after.knobs, after.positions.tolist(), strict=True) if abs(at) < FAR}
    return frozenset(far & near)


def _compared(fit: Fit, one: Model, data: Data, held: Data, before: float, *, fits: Sequence[Model]) -> float:
    """Return the held-out log-likelihood that the last addition of a model must exceed [nats].

    A number that is far off has moved already, against its prior: it is compared with the stated one, to which the
    others are fitted anew, except those numbers of the round, ``fits``, that it makes stated ones again. Such a number
    would move instead, and no held-out data see how improbable that is. Parts are compared with ``before``, or likewise
    where they make numbers stated ones again that had moved far.
    """
    each = one.additions[-1]
    moved = _brought_back(fit, one.fit) if each.parts else each.names | _explained(one, fits)
    if not moved:
        return before
    stated = refitted(fit, data, keeps=lambda knob: knob.name not in moved)
    return before if stated is None else held_out_density(stated, held)


def _fitted(model: Model, data: Data, screened: Sequence[tuple[Addition, tuple[float, ...]]]) -> list[Model]:
    """Return the most promising of the screened additions fitted together with the model."""
    chosen = most_promising([each for each, _ in screened], data)
    starts = {id(each): start for each, start in screened}
    fits = parallel_map(lambda one: _together(model, data, one, starts[id(one)]), chosen)
    return [together for together in fits if together is not None]


def most_promising(ranked: Sequence[Addition], data: Data) -> list[Addition]:
    """Return ``FITTED`` additions: the first, those that explain lines of it, names before others, and one or more.

    Of one kind and place there is one, of nameless effects whatever shaft they act on. What wins a round must have been
    compared with all that it may be instead; what explains other lines has its round later.
    """
    kinds = dict[tuple[object, ...], Addition]()
    for each in ranked:
        acts = [getattr(part, "at", "") for part in each.parts] if each.is_named else [] if each.parts else each.names
        kinds.setdefault((each.mechanism or each.kind, each.variant, each.places, *acts), each)
    different = list(kinds.values())
    if not different:
        return []
    shares = [bool(each.places and different[0].places) and competes(different[0], each, data) for each in different]
    instead = [each for each, does in zip(different[1:], shares[1:], strict=True) if does]
    instead = sorted(instead, key=lambda each: not each.is_named)[: FITTED - 2]
    others = [each for each in different[1:] if not any(each is one for one in instead)]
    return _few_numbers([*different[:1], *instead, *others])[:FITTED]


def _few_numbers(chosen: Sequence[Addition]) -> list[Addition]:
    """Return additions with all numbers but the first ``_NUMBERS`` at the end.

    The promise of a number is an upper bound, that of parts a value at their starts, which is less than the fit gives.
    """
    late = [each for each in chosen if not each.parts][_NUMBERS:]
    return [*(each for each in chosen if not any(each is one for one in late)), *late]


def _together(model: Model, data: Data, each: Addition, start: tuple[float, ...]) -> Model | None:
    """Return the model with an addition, all parameters fitted together; None where that is not possible."""
    fit, own = model.fit, {knob.name for knob in each.knobs}
    kept = [at for at, knob in enumerate(fit.knobs) if knob.name not in own]
    new = np.full((len(fit.jacobian), len(each.knobs)), np.nan)
    jacobian = np.concatenate([fit.jacobian[:, kept], new, fit.jacobian[:, len(fit.knobs) :]], axis=1)
    try:
        found = sketched(
            each.added_to(fit.rig), (*(fit.knobs[at] for at in kept), *each.knobs), data, gains=fit.gains, off=fit.off,
            start=np.concatenate([begins_at(fit, each)[kept], start]), jacobian=jacobian, nominal=fit.nominal,
        )  # fmt: skip
    except (TorquerigError, ValueError, np.linalg.LinAlgError):
        return None
    # a nameless line has one size, or one share of the torque: where it has another one, it lacks a second part
    left = tuple(line for line in model.lines if _is_nameless(each) or line.place not in each.places)
    return Model(found, (*model.additions, each), left, model.alternatives)
