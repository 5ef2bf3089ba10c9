"""Places at which lines are supposed, so that hypotheses which need a line can be tested where none was found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from math import gcd, pi

import numpy as np

from torquerig.inference.addition import Addition
from torquerig.inference.additions import proposals
from torquerig.inference.context import Context
from torquerig.inference.engine import features_of
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.fit import Data, Fit, sketched
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.places import RESOLVED_WELL, Place, frequency, order
from torquerig.inference.shafts import shafts_of
from torquerig.parallel import parallel_map
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor

_OF_A_SHAFT = (5.0, 23.0)  # [1/rev] of each shaft: blades have few, wheels many; both prime, so no multiples of others
_OF_THE_GRID = 50.0  # [Hz]
_HIGHEST = 0.4  # of the sample rate
_SLOWEST = 2.0  # times the lowest band: a slower line has too few periods in a block


def probed(fit: Fit, runs: Sequence[MeasuredRun], known: Sequence[Place]) -> tuple[Context, tuple[Place, ...]]:
    """Return the fitted model with features at further places, and these places.

    The parameters of the fit stay as they are; residuals and derivatives are those of the features with the places.
    """
    places = tuple(_free(_supposed(fit.nominal), runs, known))
    data: Data = features_of(runs, [*known, *places])
    again = sketched(
        fit.rig, fit.knobs, data, start=fit.positions, gains=fit.gains, off=fit.off, nominal=fit.nominal, iterations=0
    )
    return Context(again, data, ()), places


def hypotheses(context: Context, places: Sequence[Place]) -> Iterator[Addition]:
    """Yield what the library proposes for the model: without lines, and for each supposed line alone."""
    yield from (each for each in proposals(context) if each.parts)

    def of_line(place: Place) -> list[Addition]:
        alone = Context(context.fit, context.data, (FoundLine(place, 0.0, 0.0),))
        return [each for each in proposals(alone) if each.places]

    yield from chain.from_iterable(parallel_map(of_line, places))


def _supposed(rig: Rig) -> Iterator[Place]:
    """Yield orders of windings, magnets and teeth of the motor, of each shaft, and the frequency of the grid."""
    for motor in rig.parts_of(Motor):
        pairs, slots = motor.pole_pairs or 0, motor.slots or 0
        if pairs:
            yield order(float(6 * pairs))
        if pairs and slots:
            yield order(float(slots * 2 * pairs // gcd(slots, 2 * pairs)))
    for shaft in shafts_of(rig):
        yield from (order(one * shaft.turns) for one in _OF_A_SHAFT)
    yield frequency(_OF_THE_GRID)


def _free(places: Iterator[Place], runs: Sequence[MeasuredRun], known: Sequence[Place]) -> Iterator[Place]:
    """Yield the places that a run can show apart from all known and earlier ones."""
    taken = list(known)
    for place in places:
        if place not in taken and any(_is_free(place, run, taken) for run in runs if run.blocks):
            taken.append(place)
            yield place


def _is_free(place: Place, run: MeasuredRun, taken: Sequence[Place]) -> bool:
    speed = float(np.abs(run.speed).mean())
    at, block = place.frequency(speed), run.blocks[0]
    apart = 2 * RESOLVED_WELL * run.rate / (block.stop - block.start) + run.smearing(block.samples) * at
    if not _SLOWEST * run.slowest <= at <= _HIGHEST * run.rate or speed < 2 * pi * 0.01:
        return False
    return all(abs(at - other.frequency(speed)) > apart for other in taken)
