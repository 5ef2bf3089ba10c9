"""A further inertia on a spring: the loaded side rings at two frequencies where the model has one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig import mechanisms
from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.fitting.profiled import profiled_cost
from torquerig.diagnosis.linear.loaded_part import loaded_part
from torquerig.inference.knobs import Knob
from torquerig.rig.assembly import Part
from torquerig.rig.parts import Body

# frequencies [Hz] at which branches of some shares of the loaded part's inertia are tried: a light one shows over a few
# hundredths of its frequency only
_HEAVY = (np.geomspace(15.0, 900.0, 48), (0.15, 0.5))
_LIGHT = (np.geomspace(15.0, 900.0, 140), (0.05,))
_IN_NOTCHES = (np.linspace(0.98, 1.02, 9), (0.05, 0.15, 0.5))  # of the frequency of each notch that all runs have
_STAYS = 0.02  # of that frequency
_DAMPING = 0.02
_BEST = 3
# damping ratio: beyond the one a step swings over by less than half and no mode shows in a spectrum; below the other a
# shaft would ring longer than steel in one piece, let alone a joint
_RINGS, _NEVER_DIES = 0.2, 0.001
# of the loaded part's inertia: a branch lighter than that moves the loaded side within a hundredth of its frequency,
# and there a line that wanders looks the same
_LIGHTEST = 0.02
_WHERE_SWEPT = 100.0  # what one must gain beside where a line swept: what is left of that looks like a light branch
# a spectrum tells the width of a line no finer than its bands and the wander of the load let it
TOLD_LOOSELY = {"damping_ratio": 1.0}
_PROMISED = 2.0  # by the derivatives, beyond what its numbers must gain: what lines tell of a light one is little
_SOUGHT = 20.0  # what one must gain beside for being sought at so many places: the best of them by chance gains 2 ln n


def heavy(case: Case) -> Iterator[Candidate]:
    """Yield the heavy branches that fit best among frequencies of 15 to 900 Hz, hung on the loaded part.

    The model's numbers give way to each: its stiffness and inertia may have stood in for one. Below its frequency a
    branch is but more inertia of the part it hangs on, which may have been fitted too heavy.
    """
    yield from _best(case, *_HEAVY)


def light(case: Case) -> Iterator[Candidate]:
    """Yield the light ones, which resemble noise in a narrow band, and that comes again in what no fit has seen."""
    yield from _best(case, *_LIGHT)


def in_notches(case: Case) -> Iterator[Candidate]:
    """Yield those that fit best where the spectra of all steady runs have a narrow notch, which no noise resembles.

    They are sought at no other place, and pay for none.
    """
    near, shares = _IN_NOTCHES
    found = {notch for run in case.runs for notch in run.notches}
    for notch in sorted(found):
        for one in _best(case, notch * near, shares):
            frequency, *others = one.knobs
            knobs = (replace(frequency, spread=_STAYS), *others)
            yield replace(one, knobs=knobs, price=one.price - _SOUGHT, spared=0.0, resembled=False)


WAYS = (heavy, light, in_notches)


def propose(case: Case) -> Iterator[Candidate]:
    """Yield all of them."""
    for way in WAYS:
        yield from way(case)


def _best(case: Case, frequencies: NDArray[np.float64], shares: tuple[float, ...]) -> list[Candidate]:
    at = loaded_part(case.nominal)
    body = None if at is None else case.nominal.part(at)
    if not isinstance(body, Body):
        return []
    swept = {between for run in case.runs for between in run.swept}
    tried = [_branch(body, float(hertz), share * body.inertia, swept) for share in shares for hertz in frequencies]
    tried.sort(key=lambda one: profiled_cost(case.model, one.added_to(case.model.rig), case.seen))
    return tried[:_BEST]


def _branch(body: Body, frequency: float, inertia: float, swept: Iterable[tuple[float, float]]) -> Candidate:
    part = mechanisms.TorsionalMode(
        name="torsional_mode", after=body.name, frequency=frequency, inertia=inertia, damping_ratio=_DAMPING
    )
    knobs = (
        Knob(part.name, "frequency", 0.15),
        Knob(part.name, "inertia", 0.8),
        Knob(part.name, "damping_ratio", 0.8),
    )
    bends = (f"{body.name}.inertia",)
    price = _SOUGHT + (_WHERE_SWEPT if any(low <= frequency <= high for low, high in swept) else 0.0)
    return Candidate(
        mechanism="torsional_mode", parts=(part,), knobs=knobs, bends=bends, promised=_PROMISED, resembled=True,
        price=price, spared=_SOUGHT, above={"inertia": _LIGHTEST * body.inertia},
    )  # fmt: skip


def possible(part: Part) -> bool:
    """Whether a branch could be a mode: one that hardly rings is a damper, which stands in for what is not known."""
    return isinstance(part, mechanisms.TorsionalMode) and _NEVER_DIES < part.damping_ratio < _RINGS
