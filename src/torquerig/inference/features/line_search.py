"""Lines that no model has yet: places that exceed the noise in all runs together, at an order or at a frequency."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.line_p_values import CLEAR_BLOCKS, log_gamma_tail, log_p_of_clear, log_p_of_run
from torquerig.inference.features.line_places import HIGHEST, HIGHEST_TONE, line_frequencies
from torquerig.inference.features.line_skirts import exceeds_surroundings
from torquerig.inference.features.noise_ratios import NEAR, Density, NoiseRatios, measured_ratio, noise_ratios
from torquerig.inference.features.tuned_tone import tuned
from torquerig.inference.measured_run import MeasuredRun
from torquerig.inference.places import Place

Floats = NDArray[np.float64]

LEVEL = 1e-3  # p-value, of the whole search, below which a line is real
_MOST_OF_A_BLOCK = 12.0  # [1] times the noise: what a single block shows is no line of the run
_OVERSAMPLED = 2  # points of the grid for each bin of the longest block
_SKIRT_LOG = 0.05  # of the strongest line's log p-value: a weaker line may be its leakage and waits for the next pass
_PASSES = 4
_MOST = 40
_ORDER = 1.15  # by which an order may show less power than a frequency that is as clear: most lines turn with a shaft
_TUNED = 0.25  # [bins] of the longest blocks: so near to the true frequency is the one that single blocks give
_SHOWN = 6.0  # [1] times the noise: a block with so much power shows the line


@dataclass(frozen=True)
class FoundLine:
    """A line that exceeds the noise.

    Parameters
    ----------
    place : Place
        An order of the motor or a fixed frequency, whichever is the more likely one in all runs together.
    log_p : float
        Logarithm of the p-value of the whole search.
    other_domain : float
        The same at the best place of the other domain that could be this line; 0 where there is none.
    other_place : Place or None
        That place.
    """

    place: Place
    log_p: float
    other_domain: float
    other_place: Place | None = None


def search_lines(
    runs: Sequence[MeasuredRun], known: Sequence[Place], densities: Sequence[Density]
) -> tuple[FoundLine, ...]:
    """Return the lines beyond ``known`` in the fitted blocks, clearest first.

    In each block the power of a bin over that of noise is an exponential variate where there is no line. Noise is the
    larger one of what the model expects, ``densities`` [(N m)^2/Hz] by run and frequency [Hz], and of the median of the
    neighbours. The mean of n blocks of a run is a gamma variate of shape n; the p-values of the runs are combined by
    Fisher's method, and multiplied by the number of independent places (Bonferroni). No block counts for more than
    ``_MOST_OF_A_BLOCK``: a line is in many blocks, a transient in one. Some blocks that each show a line are enough.
    Strong lines are removed by regression before weaker ones are searched.
    """
    found: list[FoundLine] = []
    for _ in range(_PASSES):
        places = [*known, *(line.place for line in found)]
        ratios = [
            each for run, density in zip(runs, densities, strict=True) for each in noise_ratios(run, places, density)
        ]
        new = _new_lines(ratios, found) if ratios else []
        if not new:
            break
        found += new[: _MOST - len(found)]
        if len(found) >= _MOST:
            break
    return tuple(sorted(found, key=lambda line: line.log_p))


def _new_lines(ratios: Sequence[NoiseRatios], found: Sequence[FoundLine]) -> list[FoundLine]:
    """Return the new lines, clearest first; what is near a stronger one in every block that shows it is left out."""
    tests = _tests(ratios)
    candidates = [*_peaks(ratios, "order"), *_peaks(ratios, "frequency")]
    candidates.sort(key=lambda each: (each.log_p, -each.power * (_ORDER if each.place.domain == "order" else 1.0)))
    accepted: list[FoundLine] = []
    for each in candidates:
        if accepted and each.log_p > _SKIRT_LOG * accepted[0].log_p:
            break
        if any(_same(each.place, other.place, ratios) for other in (*found, *accepted)):
            continue
        if not _stands_out(each.place, ratios, tests):
            continue
        other_p, other = _elsewhere(each, candidates, ratios)
        accepted.append(FoundLine(_tuned(each.place, ratios), each.log_p, other_p, other and _tuned(other, ratios)))
    return accepted


def _tuned(place: Place, ratios: Sequence[NoiseRatios]) -> Place:
    """Return the place of a tone by whole runs, and another place as it is."""
    if place.domain == "order":
        return place
    step = min(each.frequency_step for each in ratios if each.by_frequency.size)
    return Place(place.domain, float(f"{tuned(place.at, ratios, within=_TUNED * step):.9g}"))


def _elsewhere(each: _Peak, candidates: Sequence[_Peak], ratios: Sequence[NoiseRatios]) -> tuple[float, Place | None]:
    """Return the p-value and the place of the clearest peak of the other domain that could be the same line."""
    same = [
        other for other in candidates
        if other.place.domain != each.place.domain and _same(each.place, other.place, ratios)
    ]  # fmt: skip
    best = min(same, key=lambda other: (other.log_p, -other.power), default=None)
    return (0.0, None) if best is None else (best.log_p, best.place)


@dataclass(frozen=True)
class _Peak:
    place: Place
    log_p: float
    power: float


def _peaks(ratios: Sequence[NoiseRatios], domain: Literal["order", "frequency"]) -> list[_Peak]:
    grid, log_p, power = _scores(ratios, domain)
    found: dict[float, _Peak] = {}
    reach = int(NEAR * _OVERSAMPLED)
    for at in np.flatnonzero(log_p < np.log(LEVEL)).tolist():
        if log_p[at] > log_p[max(at - reach, 0) : at + reach + 1].min():
            continue
        place = _refined(float(grid[at]), ratios, domain)
        best = found.get(place)
        if best is None or (log_p[at], -power[at]) < (best.log_p, -best.power):  # p-values of strong lines are alike
            found[place] = _Peak(Place(domain, float(f"{place:.9g}")), float(log_p[at]), float(power[at]))
    return [*found.values()]


def _refined(at: float, ratios: Sequence[NoiseRatios], domain: str) -> float:
    """Return where the blocks of the finest resolution show a line that was found near ``at``."""
    rows = [(each.by_order, each.order_step) if domain == "order" else (each.by_frequency, each.frequency_step)
            for each in ratios]  # fmt: skip
    rows = [(values, step) for values, step in rows if values.size > at / step + 1]
    near = [(values, step) for values, step in rows if np.nanmax(_around(values, at / step, 1.5), initial=0.0) > _SHOWN]
    if not near:
        return at
    width = 1.5 * max(step for _, step in near)
    fine = min(step for _, step in near)
    grid = np.arange(max(at - width, fine), at + width, 0.25 * fine)
    total = np.zeros(grid.size)
    for values, step in near:
        if step <= 2 * fine:
            total += np.log1p(np.interp(grid / step, np.arange(values.size), np.nan_to_num(values)))
    coarse = float(grid[int(np.argmax(total))])
    places = [(step * between_bins(values, coarse / step), measured_ratio(_around(values, coarse / step, 1.0)).max()
               / step**2) for values, step in near if step <= 2 * fine
              and np.isfinite(_around(values, coarse / step, 2.0)).all()]  # fmt: skip
    if not places:
        return coarse
    finer, weights = np.array(places).T  # the error of a frequency is a share of a bin, smaller by the line's strength
    return float(np.clip(np.average(finer, weights=weights), coarse - fine, coarse + fine))


def between_bins(values: Floats, at: float) -> float:
    """Return where between the bins the peak nearest to bin ``at`` is [bins], by a parabola through three logarithms.

    Under a Hann window the main lobe is so near to a Gaussian that this is off by less than 0.02 bins without noise.
    """
    around = _around(values, at, 1.0)
    middle = max(round(at - 1.0), 0) + int(np.argmax(around))
    if not 1 <= middle < values.size - 1:
        return at
    below, peak, above = np.log(np.maximum(measured_ratio(values[middle - 1 : middle + 2]), 1e-3))
    curved = below - 2 * peak + above
    return float(middle + (np.clip(0.5 * (below - above) / curved, -0.5, 0.5) if curved < 0 else 0.0))


def _around(values: Floats, at: float, reach: float) -> Floats:
    return values[max(round(at - reach), 0) : round(at + reach) + 1]


def _scores(ratios: Sequence[NoiseRatios], domain: str) -> tuple[Floats, Floats, Floats]:
    """Return the grid of places, the logarithm of the p-value of the whole search at each, and the power there."""
    turning = domain == "order"
    rows = [(each.by_order, each.order_step, each) if turning else (each.by_frequency, each.frequency_step, each)
            for each in ratios]  # fmt: skip
    rows = [row for row in rows if row[0].size]
    if not rows:
        return np.zeros(0), np.zeros(0), np.zeros(0)
    grid = _grid(ratios, domain)
    log_p, counted, power = np.zeros((3, grid.size))
    for run in {id(each.run): each.run for _, _, each in rows}.values():
        total, count, blocks = np.zeros((3, grid.size))
        highest = np.zeros((CLEAR_BLOCKS, grid.size))
        joined = max(each.blocks for _, _, each in rows if each.run is run)
        for values, own, each in rows:
            if each.run is not run:
                continue
            shown = (grid < _highest(each, turning=turning)) & (grid > _lowest(each, turning=turning))
            ratio = values[np.minimum(np.rint(grid[shown] / own).astype(int), values.size - 1)]
            seen = np.isfinite(ratio)
            ratio, shown[shown] = ratio[seen], seen
            power[shown] += ratio
            total[shown] += np.minimum(ratio, _MOST_OF_A_BLOCK)
            count[shown] += 1
            blocks[shown] += each.blocks
            for _ in range(each.blocks):
                one = ratio
                for row in highest:
                    one, row[shown] = np.minimum(one, row[shown]), np.maximum(one, row[shown])
        clear = log_p_of_clear(blocks, highest[-1], joined=joined)
        log_p += np.where(count > 0, log_p_of_run(np.maximum(count, 1), total, clear), 0.0)
        counted += count > 0
    combined = np.where(counted > 0, log_gamma_tail(np.maximum(counted, 1), -log_p), 0.0)
    return np.asarray(grid), np.asarray(combined + np.log(_tests(ratios))), np.asarray(power)


def _tests(ratios: Sequence[NoiseRatios]) -> float:
    """Return the number of independent places of both domains, by which the p-values of both are multiplied."""
    return max(sum(_grid(ratios, each).size for each in ("order", "frequency")) / _OVERSAMPLED, 1.0)


def _grid(ratios: Sequence[NoiseRatios], domain: str) -> Floats:
    """Return the places of a domain that are tested."""
    turning = domain == "order"
    steps = [
        each.order_step if turning else each.frequency_step for each in ratios
        if (each.by_order if turning else each.by_frequency).size
    ]  # fmt: skip
    if not steps:
        return np.zeros(0)
    step = min(steps) / _OVERSAMPLED
    top = max(_highest(each, turning=turning) for each in ratios)
    return np.asarray(np.arange(1.0, int(top / step)) * step)


def _highest(each: NoiseRatios, *, turning: bool) -> float:
    return HIGHEST * each.run.rate * 2 * pi / max(each.speed, 1e-9) if turning else HIGHEST_TONE * each.run.rate


def _lowest(each: NoiseRatios, *, turning: bool) -> float:
    own = each.order_step if turning else each.frequency_step
    least = each.run.slowest * 2 * pi / max(each.speed, 1e-9) if turning else each.run.slowest
    return max(least, NEAR * own)


def _stands_out(place: Place, ratios: Sequence[NoiseRatios], tests: float) -> bool:
    """Return whether a peak is a line also if only blocks count in which it is no part of a wider line or hump.

    A line that is wider than a bin (a speed that wanders, impacts that slip) has many peaks, each block others.
    """
    values = [own[at] for _, own, at in _shown(place, ratios) if exceeds_surroundings(own, at, level=LEVEL)]
    total = np.minimum(values, _MOST_OF_A_BLOCK).sum()
    count = np.array(float(max(len(values), 1)))
    return bool(log_gamma_tail(count, np.array(max(total, 1e-9))) + np.log(tests) < np.log(LEVEL))


def _shown(place: Place, ratios: Sequence[NoiseRatios]) -> Iterator[tuple[NoiseRatios, Floats, int]]:
    """Yield the blocks that show a line, with the ratios along its domain and the bin that it is in."""
    for each in ratios:
        turning = place.domain == "order"
        values, step = (each.by_order, each.order_step) if turning else (each.by_frequency, each.frequency_step)
        index = round(place.at / step)
        if 0 < index < values.size and values[index] >= _SHOWN:
            yield each, values, index


def _same(one: Place, other: Place, ratios: Sequence[NoiseRatios]) -> bool:
    """Return whether ``one`` is near ``other`` in every block that shows ``one``."""
    near = []
    for each, _, _ in _shown(one, ratios):
        slow, fast = line_frequencies([other], np.array(each.speeds))[:, 0]
        low, high = line_frequencies([one], np.array(each.speeds))[:, 0]
        width = max(NEAR * each.frequency_step, each.smearing * max(high, fast))
        near.append(bool(low - fast < width and slow - high < width) if one.domain != other.domain
                    else abs(0.5 * (low + high) - 0.5 * (slow + fast)) < width)  # fmt: skip
    return bool(near) and all(near)
