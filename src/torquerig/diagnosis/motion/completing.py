"""Which effects complete the model: each hypothesis fitted beside the model's own numbers, the best kept, and again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.motion import cogging, friction, friction_peak, gap, hum, others
from torquerig.diagnosis.motion.evidence import gained, root_mean_square, samples_that_count
from torquerig.diagnosis.motion.fitted import FittedMotion, fitted
from torquerig.diagnosis.motion.moved import Moved
from torquerig.diagnosis.motion.objections import LEAST_FALL, first_that_holds
from torquerig.diagnosis.motion.pairs import pair_that_holds
from torquerig.diagnosis.motion.places import mismatches
from torquerig.diagnosis.motion.tried import Refused, Step, Tried
from torquerig.inference.knobs import Knob
from torquerig.parallel import parallel_map
from torquerig.rig.assembly import Rig

MOST_EFFECTS = 3
_ALONE = 8  # evaluations while the model's own numbers are held
_AS_CLOSE = 0.05  # of the rms residual: what a simpler variant may leave more
_WORTHWHILE = 0.25  # of the best gain alone: less is not caught up by fitting all numbers
_ROOMS = (friction, friction_peak, gap, cogging, hum, others)


def completed(
    nominal: Rig, runs: Sequence[Moved], knobs: Sequence[Knob], *, progress: Callable[[str], None]
) -> tuple[FittedMotion, tuple[Step, ...], tuple[Refused, ...]]:
    """Return the calibrated nominal model, the steps that complete it, and what was tried last without being kept."""
    start = model = fitted(nominal, runs, knobs)
    base, own = nominal, tuple(knobs)
    steps: list[Step] = []
    while len(steps) < MOST_EFFECTS:
        progress(
            "testing the mechanisms of the library"
            if not steps
            else f"testing the residual after {steps[-1].kept.candidate.mechanism}"
        )
        tried = tuple(_tried(model, base, own, runs))
        kept, refused = first_that_holds(tried, model, base, own, runs)
        new: tuple[Step, ...] = (Step(kept, model, tried),) if kept else ()
        if not new and len(steps) + 2 <= MOST_EFFECTS and mismatches(model, runs):
            progress("testing pairs of mechanisms")
            new = pair_that_holds(tried, model, base, own, runs, beside=partial(_tried, runs=runs))
        if not new:
            return start, tuple(steps), refused
        for step in new:
            steps.append(step)
            base, own = step.kept.candidate.added_to(base), (*own, *step.kept.candidate.knobs)
            model = step.kept.model
    return start, tuple(steps), ()


def _proposals(model: FittedMotion, runs: Sequence[Moved]) -> Iterator[Candidate]:
    for room in _ROOMS:
        yield from room.propose(model, runs)


def _tried(model: FittedMotion, base: Rig, own: Sequence[Knob], runs: Sequence[Moved]) -> list[Tried]:
    """Return every hypothesis fitted, best first: alone, then of each name and variant the best start with all.

    Alone all numbers of the model are held but those that stood in for the hypothesis.
    """

    def held(candidate: Candidate) -> Tried:
        loose = [knob for knob in own if knob.field in candidate.loosens]
        made = fitted(candidate.added_to(model.rig), runs, (*candidate.knobs, *loose), evaluations=_ALONE)
        return _weighed(candidate, made, model, runs)

    def freed(one: Tried) -> Tried:
        parts = tuple(one.model.rig.part(part.name) for part in one.candidate.parts)
        placed = replace(one.candidate, parts=parts)
        start = np.concatenate([model.positions, np.zeros(len(placed.knobs))])
        made = fitted(placed.added_to(base), runs, (*own, *placed.knobs), start=start)
        return replace(_weighed(placed, made, model, runs), freed=True)

    alone: dict[tuple[str, str], Tried] = {}
    for one in parallel_map(held, list(_proposals(model, runs))):
        key = (one.candidate.mechanism, one.candidate.variant)
        if key not in alone or one.gain > alone[key].gain:
            alone[key] = one
    worth = _worthwhile(list(alone.values()))
    found = [*parallel_map(freed, worth), *(one for one in alone.values() if one not in worth)]
    return _ranked(found, model, runs)


def _worthwhile(alone: Sequence[Tried]) -> list[Tried]:
    """Return those worth fitting with all numbers free.

    Of a residual that is one slow course few samples count, and no gain is large before it is gone: what lowers it
    counts as well.
    """
    top = max((one.gain for one in alone), default=0.0)
    deepest = max((one.fall for one in alone), default=0.0)
    enough = max(_WORTHWHILE * deepest, LEAST_FALL)
    return [one for one in alone if one.gain >= _WORTHWHILE * top or one.fall >= enough]


def _ranked(found: Sequence[Tried], model: FittedMotion, runs: Sequence[Moved]) -> list[Tried]:
    """Best first, all weighed with the colour of what the closest one leaves; finer variants behind one as close."""
    if not found:
        return []
    before, left = model.of(runs), [one.model.of(runs) for one in found]
    closest = min(left, key=root_mean_square)
    count = samples_that_count(closest)
    gains = [gained(before, after, numbers=len(one.candidate.knobs), count=count)
             for one, after in zip(found, left, strict=True)]  # fmt: skip
    best = sorted((replace(one, gain=gain) for one, gain in zip(found, gains, strict=True)), key=lambda one: -one.gain)
    return sorted(best, key=lambda one: any(_as_close(other, one) for other in best))


def _as_close(simple: Tried, fine: Tried) -> bool:
    """Whether a simpler variant of the same mechanism comes as close as a finer one."""
    alike = simple.freed and simple.candidate.mechanism == fine.candidate.mechanism
    fewer = len(simple.candidate.knobs) < len(fine.candidate.knobs)
    return alike and fewer and 1 - simple.fall < (1 + _AS_CLOSE) * (1 - fine.fall)


def _weighed(candidate: Candidate, made: FittedMotion, model: FittedMotion, runs: Sequence[Moved]) -> Tried:
    before, left = model.of(runs), made.of(runs)
    gain = gained(before, left, numbers=len(candidate.knobs))
    return Tried(candidate, made, gain, 1 - root_mean_square(left) / root_mean_square(before))
