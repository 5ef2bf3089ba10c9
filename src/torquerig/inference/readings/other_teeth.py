"""Another pair of teeth in a stage: another ratio, or a tooth counted too many or too few.

Behind a stage with p teeth in and w out all orders of the motor go as p/w; the mesh itself is at p times the order of
its input. Each line therefore is at ``o (p'/p)^a (w'/w)^b`` with another pair; a and b follow from two rigs with a
tooth more. The pairs are compared by the lines of whole runs, which separate one tooth in fifty.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import ceil, floor, log

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.features.run_features import run_features
from torquerig.inference.knobs import turned
from torquerig.inference.likelihood import LEVEL, LINE, Discrepancy, log_density, residuals_of
from torquerig.inference.model_density import model_densities
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.prediction.rig_lines import rig_lines
from torquerig.inference.readings.order_comb import OrderSpectrum, expected_over_noise, order_spectrum
from torquerig.inference.readings.reading import CLEARLY, SLIP_LOG_ODDS, Read, Reading, SetupFault, gain_of
from torquerig.inference.readings.teeth import Pair, ToothedStage, toothed_stages, with_pair
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_FARTHEST = 2.0  # times the stated count of the input, and the stated ratio: no slip in a catalog's list is larger
_FIXED = 1e-9  # [1] exponent of a line that does not move
_ALIKE = log(20.0)  # [nats] pairs less far behind are not excluded
_COMPARED = 24  # of those pairs, evenly from the best to the last, are compared by features


@dataclass(frozen=True)
class _Candidate:
    """A pair of a stage, its prior log-odds, and its posterior ones to the stated pair by whole runs [nats]."""

    stage: ToothedStage
    pair: Pair
    log_odds: float
    ahead: float

    @property
    def kind(self) -> str:
        apart = sum(abs(one - stated) for one, stated in zip(self.pair, self.stage.pair, strict=True))
        return "teeth" if apart == 1 else "gear_ratio"


def other_teeth(stated: Reading, rig: Rig, read: Read) -> Reading:
    """Return the reading with another pair of teeth where whole runs or features show it, and both speak for it.

    A shaft whose lines are weak shows its ratio in the mean torques.
    """
    ranked = sorted(_candidates(stated, rig), key=lambda one: -one.ahead)
    if not ranked:
        return stated
    near = [one for one in ranked if ranked[0].ahead - one.ahead < _ALIKE]
    best = _by_features(near, stated, rig)
    again = read(with_pair(rig, best.stage, best.pair), also=stated.data.seen[0].places)
    same = read(rig, stated.runs, also=again.data.seen[0].places)
    gain = gain_of(again.fit, same.fit)
    if gain < 0 or max(best.ahead, gain + best.log_odds) < CLEARLY:
        return stated
    return replace(again, faults=(_fault(best, near), *stated.faults))


def _by_features(near: Sequence[_Candidate], stated: Reading, rig: Rig) -> _Candidate:
    """Return the pair that lines and mean torques favour among those that whole runs do not separate.

    Where only a mesh line shows, its place gives the teeth of the input; their ratio is in the sizes.
    """
    rows: list[int] = np.unique(np.linspace(0, len(near) - 1, _COMPARED).astype(int)).tolist()
    chosen = [near[row] for row in rows]
    if len(chosen) == 1:
        return chosen[0]
    runs = [seen.run for seen in stated.data.seen]
    rigs = [with_pair(rig, one.stage, one.pair) for one in chosen]
    places = {order(line.order) for one in rigs for run in runs for line in Twin(one.at(run.run)).lines()}
    data = [run_features(run, sorted({*stated.data.seen[0].places, *places})) for run in runs]

    def density(one: Rig) -> float:
        at = turned(one, stated.fit.knobs, stated.fit.positions)
        return sum(
            log_density(residuals_of(seen, expected_run(at, seen), Discrepancy(), kind))
            for seen in data for kind in (LINE, LEVEL)
        )  # fmt: skip

    total = [one.ahead + density(each) for one, each in zip(chosen, rigs, strict=True)]
    return chosen[total.index(max(total))]


def _candidates(stated: Reading, rig: Rig) -> Iterator[_Candidate]:
    """Yield the pairs that are ahead of the stated one."""
    for stage in toothed_stages(rig):
        pairs = _pairs(stage.pair)
        gain = _gains(stated, stage, pairs)
        for pair, one in zip(pairs, gain.tolist(), strict=True):
            apart = abs(pair[0] - stage.pair[0]) + abs(pair[1] - stage.pair[1])
            log_odds = SLIP_LOG_ODDS - log(4 if apart == 1 else len(pairs))
            if one + log_odds > 0:
                yield _Candidate(stage, pair, log_odds, one + log_odds)


def _pairs(stated: Pair) -> list[Pair]:
    ratio = stated[1] / stated[0]
    return [
        (low, high)
        for low in range(max(ceil(stated[0] / _FARTHEST), 1), floor(stated[0] * _FARTHEST) + 1)
        for high in range(max(ceil(low * ratio / _FARTHEST), 1), floor(low * ratio * _FARTHEST) + 1)
        if (low, high) != stated
    ]


def _gains(stated: Reading, stage: ToothedStage, pairs: Sequence[Pair]) -> Floats:
    """Return the log-likelihood ratio of each pair to the stated one in whole runs [nats], shape (pairs,)."""
    total = np.zeros(len(pairs))
    densities = model_densities(stated.fit, stated.data)
    here = np.log(np.array([stage.pair, *pairs]) / np.array(stage.pair))
    for row, seen in enumerate(stated.data.seen):
        if not seen.segments:
            continue
        lines = _moving(stated.fit.fitted_rig, stage, row, stated)
        if lines is None:
            continue
        orders = lines.orders * np.exp(here @ lines.exponents.T)
        density = densities[row]
        fixed = expected_over_noise(seen.run, lines.fixed, lines.fixed_square, density)
        highest = float(np.nanmax(orders, initial=0.0))
        found = order_spectrum(seen.run, fixed=lines.fixed, expected=fixed, highest=highest, density=density)
        if found is not None:
            total += _ahead(found, orders, expected_over_noise(seen.run, lines.orders, lines.square, density))
    return total


def _ahead(found: OrderSpectrum, orders: Floats, expected: Floats) -> Floats:
    each = found.log_ratio(orders, expected)
    return np.asarray(each[1:] - each[0])


@dataclass(frozen=True, eq=False)
class _Lines:
    """Lines of a run that another pair moves: orders [1/rev], squares [(N m)^2], exponents (lines, 2); and the rest."""

    orders: Floats
    square: Floats
    exponents: Floats
    fixed: Floats
    fixed_square: Floats


def _moving(rig: Rig, stage: ToothedStage, row: int, stated: Reading) -> _Lines | None:
    seen = stated.data.seen[row]

    def lines_of(one: Rig) -> tuple[Floats, Floats]:
        turning = np.abs(seen.speed) / (2 * np.pi)
        own = [each for each in rig_lines(Twin(one.at(seen.run.run)), seen) if each.follows and each.beats]
        orders = [(each.frequency / turning).mean(axis=1) for each in own]
        return np.concatenate([np.zeros(0), *orders]), np.concatenate(
            [np.zeros(0), *(each.square.mean(axis=1) for each in own)]
        )

    low, high = stage.pair
    try:
        orders, square = lines_of(rig)
        more = [lines_of(with_pair(rig, stage, pair))[0] for pair in ((low + 1, high), (low, high + 1))]
    except (TorquerigError, ValueError):
        return None
    if not orders.size or any(one.size != orders.size for one in more):
        return None
    steps = np.log([(low + 1) / low, (high + 1) / high])
    exponents = np.log(np.array(more) / orders).T / steps
    moves = np.abs(exponents).max(axis=1) > _FIXED
    if not moves.any():
        return None
    return _Lines(orders[moves], square[moves], exponents[moves], orders[~moves], square[~moves])


def _fault(best: _Candidate, near: Sequence[_Candidate]) -> SetupFault:
    stage, pair = best.stage, best.pair
    elsewhere = "".join(sorted({f" Another pair of {one.stage.name} would explain them as well."
                                for one in near if one.stage != stage}))  # fmt: skip
    kinds = sorted({one.kind for one in near} - {best.kind})
    own = [one.pair for one in near if one.stage == stage]
    if best.kind == "teeth":
        side = int(pair[1] != stage.pair[1])
        counts = [float(one[side]) for one in own if one[1 - side] == pair[1 - side]]
        return SetupFault(
            kind="teeth", of=stage.name, stated=stage.pair[side], estimated=pair[side], unit="1",
            equivalent_to=tuple(kinds), interval=(min(counts), max(counts)),
            explanation=f"The orders of the lines show that {('the input', 'the output')[side]} of {stage.name} has "
            f"{pair[side]} teeth, not {stage.pair[side]}.{elsewhere}",
        )  # fmt: skip
    ratios = [one[1] / one[0] for one in own]
    return SetupFault(
        kind="gear_ratio", of=stage.name, stated=stage.pair[1] / stage.pair[0], estimated=pair[1] / pair[0], unit="1",
        equivalent_to=tuple(kinds), interval=(min(ratios), max(ratios)),
        explanation=f"The orders of the lines show that {stage.name} has a ratio of {pair[1] / pair[0]:.4g} (such as "
        f"{pair[0]} and {pair[1]} teeth), not {stage.pair[1] / stage.pair[0]:.4g}.{elsewhere}",
    )  # fmt: skip
