"""Differences between simulated and published figures, and their reasons, as sentences."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from torquerig.study.reference_report.cells import CellResult
from torquerig.study.reference_report.mechanical import HIGH, LOW, MechanicalDrop
from torquerig.study.reference_report.published import MECHANICAL_DROP
from torquerig.study.reference_report.results import ReportResults

_ALIKE = 1.25  # [1] largest over smallest of shares that count as equal
_NEAR = 3.0  # [percentage points] smallest difference that counts as one


def fit_sentences(results: ReportResults) -> tuple[str, ...]:
    """Return the fitted parameters and the residuals of fitted and held-out cells."""
    return _free(results), _held_out(results)


def _free(results: ReportResults) -> str:
    fit, load = results.fit, results.rig.load
    hits, slow = load.hit_rms * fit.scale, load.slow_rms * fit.scale
    others = "; ".join(f"{occupancy:g} %: {residual:.1f}" for occupancy, (_, _, residual) in fit.by_occupancy.items())
    return (
        f"Three parameters are free. The load's fluctuation at 0.5 mm is {fit.scale:.3f} times that of the scenario "
        f"(hits {load.hit_rms:g} to {hits:.4f} of the mean, slow part {load.slow_rms:g} to {slow:.4f}). Its exponent "
        f"of the particle size is {fit.exponent:+.2f} (0 in the scenario). The occupancy of Table IX, which the report "
        f"does not state, is {fit.occupancy:g} % (rms residual of the fitted cells in percentage points: {others})."
    )


def _held_out(results: ReportResults) -> str:
    seen, held = ([one for one in results.cells if one.cell.fitted is wanted] for wanted in (True, False))
    guess = float(np.mean([one.cell.cut for one in seen]))
    fitted, other = (_rms([one.difference for one in some]) for some in (seen, held))
    plain, blind = _rms([one.shipped_cut - one.cell.cut for one in held]), _rms([guess - one.cell.cut for one in held])
    worse = "larger" if other > blind else "smaller"
    return (
        f"Over the {len(seen)} fitted cells the rms difference is {fitted:.1f} percentage points, over the "
        f"{len(held)} held-out ones "
        f"{other:.1f}. Without a fit the rms difference of the held-out cells is {plain:.1f}. With the mean of the "
        f"fitted cells ({guess:.1f} %) as prediction it is {blind:.1f}: the error of the model is {worse} than that."
    )


def cell_sentence(one: CellResult) -> str:
    """Return whether a simulated cell agrees, and if not, the fluctuation of the load that would give it."""
    name = f"Table {one.cell.table}, {one.cell.shown}"
    tolerance = max(_NEAR, one.highest - one.lowest)
    if abs(one.difference) <= tolerance:
        return f"{name}: {one.cut:.1f} % against {one.cell.cut:g} %, within {tolerance:.1f} percentage points."
    first = (
        f"{name}: {one.cut:.1f} % against {one.cell.cut:g} %, {abs(one.difference):.1f} points "
        f"{'more' if one.difference > 0 else 'less'}. The rms of the reading is {one.lines:.3f} N m "
        f"from lines and {one.load:.3f} N m from the load"
    )
    if one.needed is None:
        return f"{first}. With these lines no fluctuation of the load gives the published reduction."
    return (
        f"{first}. With these lines the published value needs a load fluctuation of {one.needed:.3f} N m "
        f"({100 * one.needed / one.mean:.1f} % of the mean instead of {100 * one.load / one.mean:.1f} %)."
    )


def table_sentences(results: ReportResults) -> tuple[str, ...]:
    """Return the differences of the tables as a whole from the model and from each other."""
    eight = [one for one in results.cells if one.cell.table == "VIII"]
    nine = [one for one in results.cells if one.cell.table == "IX"]
    return (_shape(eight), *_same_run(eight, nine, results), _notches(results.cells), _energy(results.cells))


def mechanical_sentences(drop: MechanicalDrop) -> tuple[str, ...]:
    """Return the simulated and the published drop of mechanical noise."""
    needed = "" if drop.needed_high is None else f"; {MECHANICAL_DROP:g} % needs {drop.needed_high:.1f} % occupancy"
    reading = (
        f"From {LOW:g} to {HIGH:g} % occupancy the first line of the output shaft falls from {drop.low:.4f} to "
        f"{drop.high:.4f} N m in the reading, by {drop.percent:.1f} %. The report prints {MECHANICAL_DROP:g} % between "
        "a low and a high load that it does not state."
    )
    model = (
        f"In the model the shaft line is divided by 1 + relief x occupancy and falls by {drop.by_model:.1f} %{needed}. "
        f"The noise floor at neighbouring orders is {drop.floor:.4f} N m at {HIGH:g} % occupancy; it is the "
        f"random error "
        "of this figure. The relief of the scenario was chosen after the report, so this does not test its cause. A "
        "backlash that closes under load would give the same."
    )
    return reading, model


def _shape(eight: Sequence[CellResult]) -> str:
    simulated = " > ".join(f"{one.cut:.0f}" for one in eight)
    falls = all(first.cut >= last.cut for first, last in pairwise(eight))
    needed = ", ".join(
        f"{one.cell.shown}: {100 * one.needed / one.mean:.1f} %"
        if one.needed is not None
        else f"{one.cell.shown}: none"
        for one in eight
    )
    shape = f"falls with occupancy ({simulated} %)" if falls else f"is {simulated.replace(' > ', ', ')} %"
    because = "because" if falls and eight[-1].load > eight[0].load else "while"
    loads = f"{eight[0].load:.3f} to {eight[-1].load:.3f} N m"
    lines = f"{eight[0].lines:.3f} to {eight[-1].lines:.3f} N m"
    shares = [one.needed / one.mean for one in eight if one.needed is not None]
    apart = len(shares) < len(eight) or max(shares) > _ALIKE * min(shares)
    fits = "no single share gives all four" if apart else f"one share within a factor of {_ALIKE:g} gives all four"
    return (
        f"The simulated reduction {shape}, {because} the load's fluctuation is proportional to its mean "
        f"({loads}) while the "
        f"lines change from {lines}. The published one has its minimum at 11 %. It needs a load fluctuation, as "
        f"a share "
        f"of the mean, of {needed}: {fits}."
    )


def _same_run(eight: Sequence[CellResult], nine: Sequence[CellResult], results: ReportResults) -> tuple[str, ...]:
    pairs = [
        (first, last) for first in eight for last in nine
        if first.occupancy == last.occupancy and abs(first.size - last.size) < 1e-9
    ]  # fmt: skip
    return tuple(
        f"At {first.occupancy:g} % and {1e3 * first.size:g} mm the two tables would be one run ({first.cell.cut:g} and "
        f"{last.cell.cut:g} % published): unstated conditions change the result by "
        f"{abs(first.cell.cut - last.cell.cut):g} percentage points. The error of any model of occupancy and "
        f"size is at "
        "least half of that."
        for first, last in pairs
    )


def _notches(cells: Sequence[CellResult]) -> str:
    found = [(one, one.placebo) for one in cells if one.placebo is not None]
    low = min(100 * min(placebo.std_cuts) for _, placebo in found)
    high = max(100 * max(placebo.std_cuts) for _, placebo in found)
    least = min(found, key=lambda pair: pair[0].cut - 100 * max(pair[1].std_cuts))
    return (
        f"The same twenty notches at neighbouring orders without lines reduce the standard deviation by {low:.1f} to "
        f"{high:.1f} %. This part of a published reduction is not removed noise. It is largest for Table "
        f"{least[0].cell.table}, {least[0].cell.shown}: up to {100 * max(least[1].std_cuts):.1f} of "
        f"{least[0].cut:.1f} %."
    )


def _energy(cells: Sequence[CellResult]) -> str:
    energies = [one.energy_change for one in cells if one.energy_change is not None]
    change = f"{min(energies):+.4f} to {max(energies):+.4f} %" if energies else "an unknown amount (no speed)"
    worst = max(abs(one.mean_change) for one in cells)
    falls = bool(energies) and max(energies) < 0
    found = "found here too" if falls else "not found here"
    return (
        f"The mean changes by {worst:.1g} % at most and the energy by {change}. The filter subtracts the mean "
        f"and adds it again, so the report's 0 % is no evidence. Its 'slight decrease in total energy' is {found}."
    )


def _rms(values: Sequence[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
