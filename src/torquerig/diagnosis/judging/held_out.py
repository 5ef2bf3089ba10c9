"""How well models predict what no fit has seen, by simulating them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.expecting.expectation import Expectation, expected
from torquerig.diagnosis.expecting.phased import as_in_runs, phases_tell
from torquerig.diagnosis.expecting.simulated import expected_from, simulated_runs
from torquerig.diagnosis.fitting.misfit import Misfit, called_chance, misfit, robust_squares
from torquerig.diagnosis.judging.share_explained import share_explained
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.flight_statistics import chance_of_amplitudes, chance_of_blows
from torquerig.diagnosis.looking.flights import blows
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.value_features import value_features, value_misfit
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.diagnosis.outcome import HeldOut
from torquerig.errors import SimulationError
from torquerig.rig.assembly import Rig

Squares = Callable[[Rig, Sequence[Features]], tuple[NDArray[np.float64], NDArray[np.float64]]]

SEEDS = (101, 102)
_DRAWS = 400


def _by_simulation(
    rig: Rig, held: Sequence[Features], *, flying: bool, untold: Collection[str]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the robust square of every held-out residual of ``rig``'s simulations, run after run, and its width.

    ``flying`` also counts how often flanks fly, which depends on the phases of lines: they are those that each run
    shows where fits may see it. Of runs that are ``untold`` the distribution of values alone counts. Both go by chance,
    and two simulations tell more; of all else chance is taken out, and one tells it.
    """
    seeds = SEEDS if flying or untold else SEEDS[:1]
    copies = simulated_runs(as_in_runs(rig, held) if flying else rig, held, seeds=seeds)
    models = expected_from(rig, held, copies)
    squares, widths = [], []
    for features, model, each in zip(held, models, copies, strict=True):
        values = np.mean([value_features(copy, held=True) for copy in each], axis=0)
        residuals = value_misfit(value_features(features.observed, held=True), values)
        if features.observed.name in untold:
            squares.append(robust_squares(residuals))
            widths.append(np.zeros(residuals.size))
            continue
        if flying:
            residuals = np.append(residuals, _flown(features, each))
        missed = misfit(features, _left_to_blows(model, features, copies=len(each)) if flying else model)
        squares.append(robust_squares(np.concatenate([missed.all(), residuals])))
        widths.append(np.concatenate([_width(missed, model), np.zeros(residuals.size)]))
    return np.concatenate(squares), np.concatenate(widths)


def _left_to_blows(model: Expectation, seen: Features, *, copies: int) -> Expectation:
    """Return the expectation with what the few blows that a run shows leave of its spectrum or its lines to chance.

    It is the same for every model: so many blows are taken for each simulation too. A run that shows them where fits
    may see it chatters where they may not.
    """
    if not blows(seen.untoned, held=None):
        return model
    if not seen.observed.steady:
        return replace(model, variance=model.variance + chance_of_amplitudes(seen))
    there = len(blows(seen.untoned, held=True))
    chance = chance_of_blows(there, copies * there)
    return replace(model, power_tolerance=np.hypot(model.power_tolerance, chance)) if model.power.size else model


def _flown(seen: Features, copies: Sequence[Observed]) -> float:
    """Return by how many spreads the number of flights differs from that of simulations.

    Twice the root of a Poisson number has spread 1 (Anscombe 1948, Biometrika 35).
    """
    there = len(blows(seen.untoned, held=True))
    here = float(np.mean([len(blows(without_tones(copy, seen.places), held=True)) for copy in copies]))
    return float(2 * (np.sqrt(there + 0.375) - np.sqrt(here + 0.375)) / np.sqrt(1 + 1 / len(copies)))


def _by_the_twin(
    rig: Rig, held: Sequence[Features], *, untold: Collection[str]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    held = [features for features in held if features.observed.name not in untold]
    models = [expected(rig, features) for features in held]
    missed = [misfit(features, model) for features, model in zip(held, models, strict=True)]
    squares = np.concatenate([robust_squares(each.all()) for each in missed])
    return squares, np.concatenate([_width(each, model) for each, model in zip(missed, models, strict=True)])


def _width(missed: Misfit, model: Expectation) -> NDArray[np.float64]:
    """Return by each residual what its model pays for calling it chance: levels do, all others 0."""
    before, after = missed.bands.size + missed.lines.size, missed.turning.size
    return np.concatenate([np.zeros(before), called_chance(model), np.zeros(after)])


def held_out(
    nominal: Rig, before: Rig, after: Rig, held: Sequence[Features], *, seed: int, untold: Collection[str] = ()
) -> HeldOut:
    """Return the mean of the squares of the three models, and the improvement with its 95 % bootstrap interval.

    A model that calls more of the slow torque chance than the nominal one misses less of it, and foretells less: the
    logarithm of the spread is counted, over the nominal model's, as in a likelihood. Where one of them has a gap, so is
    how often flanks fly across it.

    Of the runs that are ``untold`` (``untold_runs``) the distribution of values alone counts.

    Where the fitted numbers of one cannot be simulated, all three are judged by their linear twins, and it is said.
    """
    flying = any(phases_tell(rig) for rig in (nominal, before, after))
    try:
        one, two, three = _each(partial(_by_simulation, flying=flying, untold=untold), (nominal, before, after), held)
        by_twin = False
    except SimulationError:
        one, two, three = _each(partial(_by_the_twin, untold=untold), (nominal, before, after), held)
        by_twin = True
    rng = np.random.default_rng(seed)
    drawn = rng.integers(0, two.size, (_DRAWS, two.size))
    gains = 1 - three[drawn].mean(axis=1) / np.maximum(two[drawn].mean(axis=1), 1e-12)
    low, high = np.quantile(gains, [0.025, 0.975])
    value = 1 - float(three.mean()) / max(float(two.mean()), 1e-12)
    return HeldOut(
        nominal=float(one.mean()), before=float(two.mean()), after=float(three.mean()),
        improvement=(value, float(low), float(high)), by_twin=by_twin, explained=share_explained(two, three),
    )  # fmt: skip


def _each(squares: Squares, rigs: Sequence[Rig], held: Sequence[Features]) -> list[NDArray[np.float64]]:
    """Return the squares of every rig, more by its width than the first; those of one that comes twice taken once."""
    known = {id(rig): squares(rig, held) for rig in {id(rig): rig for rig in rigs}.values()}
    widths = known[id(rigs[0])][1]
    return [known[id(rig)][0] + known[id(rig)][1] - widths for rig in rigs]
