"""Where the simulated figures differ from the published ones, and why: sentences out of computed numbers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from torquerig.study.reference_report.cells import CellResult
from torquerig.study.reference_report.mechanical import HIGH, LOW, MechanicalDrop
from torquerig.study.reference_report.published import MECHANICAL_DROP
from torquerig.study.reference_report.results import ReportResults

_ALIKE = 1.25  # [1] largest over smallest of shares that count as one
_NEAR = 3.0  # percentage points that count as agreement where the copies of a run lie nearer


def fit_sentences(results: ReportResults) -> tuple[str, ...]:
    """Return what was fitted, to what, and how well the fitted and the held-out cells come out."""
    return _free(results), _held_out(results)


def _free(results: ReportResults) -> str:
    fit, load = results.fit, results.rig.load
    hits, slow = load.hit_rms * fit.scale, load.slow_rms * fit.scale
    others = "; ".join(f"{occupancy:g} %: {misfit:.1f}" for occupancy, (_, _, misfit) in fit.by_occupancy.items())
    return (
        f"Free are three: the load's fluctuation at 0.5 mm, {fit.scale:.3f} times the scenario's (hits "
        f"{load.hit_rms:g} to {hits:.4f} of the mean, slow part {load.slow_rms:g} to {slow:.4f}); its power of the "
        f"particle size, {fit.exponent:+.2f} (0 in the scenario); and the occupancy of Table IX, which the report does "
        f"not state: {fit.occupancy:g} % (rms over the fitted cells by occupancy, in points: {others})."
    )


def _held_out(results: ReportResults) -> str:
    seen, held = ([one for one in results.cells if one.cell.fitted is wanted] for wanted in (True, False))
    guess = float(np.mean([one.cell.cut for one in seen]))
    own, other = (_rms([one.difference for one in some]) for some in (seen, held))
    plain, blind = _rms([one.shipped_cut - one.cell.cut for one in held]), _rms([guess - one.cell.cut for one in held])
    worse = "more" if other > blind else "less"
    return (
        f"Over the {len(seen)} fitted cells the rms difference is {own:.1f} points, over the {len(held)} held-out ones "
        f"{other:.1f}. With nothing fitted the held-out cells are {plain:.1f} points off. The mean of the fitted cells "
        f"({guess:.1f} %), taken for every held-out one, is {blind:.1f} off: the model errs by {worse} than that."
    )


def cell_sentence(one: CellResult) -> str:
    """Return whether a cell comes out, and where it does not, what would be needed for it."""
    name = f"Table {one.cell.table}, {one.cell.shown}"
    spread = max(_NEAR, one.highest - one.lowest)
    if abs(one.difference) <= spread:
        return f"{name}: {one.cut:.1f} % against {one.cell.cut:g} %, within {spread:.1f} points."
    first = (
        f"{name}: {one.cut:.1f} % against {one.cell.cut:g} %, {abs(one.difference):.1f} points "
        f"{'more' if one.difference > 0 else 'less'}. The reading holds {one.lines:.3f} N m of lines and "
        f"{one.load:.3f} N m of load"
    )
    if one.needed is None:
        return f"{first}; no fluctuation of the load gives the published cut beside these lines."
    return (
        f"{first}; beside these lines the load would have to fluctuate by {one.needed:.3f} N m "
        f"({100 * one.needed / one.mean:.1f} % of the mean instead of {100 * one.load / one.mean:.1f} %)."
    )


def table_sentences(results: ReportResults) -> tuple[str, ...]:
    """Return what the tables as a whole say against the model, and against each other."""
    eight = [one for one in results.cells if one.cell.table == "VIII"]
    nine = [one for one in results.cells if one.cell.table == "IX"]
    return (_shape(eight), *_same_run(eight, nine, results), _notches(results.cells), _energy(results.cells))


def mechanical_sentences(drop: MechanicalDrop) -> tuple[str, ...]:
    """Return the drop of mechanical noise beside the published one."""
    needed = (
        "" if drop.needed_high is None else f"; {MECHANICAL_DROP:g} % would need {drop.needed_high:.1f} % occupancy"
    )
    reading = (
        f"From {LOW:g} to {HIGH:g} % occupancy the first line of the output shaft falls from {drop.low:.4f} to "
        f"{drop.high:.4f} N m in the reading, by {drop.percent:.1f} %; the report prints {MECHANICAL_DROP:g} % between "
        "a low and a high load that it does not state."
    )
    model = (
        f"The model's own shaft line is divided by 1 + relief x occupancy and falls {drop.by_model:.1f} %{needed}. "
        f"Beside the line, at empty orders, the load at {HIGH:g} % alone shows {drop.chance:.4f} N m, which is how far "
        "chance moves the figure. The relief is put into the scenario after the report, so that this is no test of its "
        "cause: a gap that closes under load would look the same."
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
    shape = f"falls with occupancy ({simulated} %)" if falls else f"runs {simulated.replace(' > ', ', ')} %"
    because = "because" if falls and eight[-1].load > eight[0].load else "while"
    loads = f"{eight[0].load:.3f} to {eight[-1].load:.3f} N m"
    lines = f"{eight[0].lines:.3f} to {eight[-1].lines:.3f} N m"
    shares = [one.needed / one.mean for one in eight if one.needed is not None]
    apart = len(shares) < len(eight) or max(shares) > _ALIKE * min(shares)
    fits = "no one share gives all four" if apart else f"one share within a factor of {_ALIKE:g} gives all four"
    return (
        f"The simulated cut {shape}, {because} the load's fluctuation goes with its mean ({loads}) while the lines go "
        f"from {lines}; the published one turns at 11 %. As a share of the mean the load would have to fluctuate by "
        f"{needed}: {fits}."
    )


def _same_run(eight: Sequence[CellResult], nine: Sequence[CellResult], results: ReportResults) -> tuple[str, ...]:
    pairs = [
        (first, last) for first in eight for last in nine
        if first.occupancy == last.occupancy and abs(first.size - last.size) < 1e-9
    ]  # fmt: skip
    return tuple(
        f"At {first.occupancy:g} % and {1e3 * first.size:g} mm the two tables would be one run ({first.cell.cut:g} and "
        f"{last.cell.cut:g} % published): what the tables leave unsaid is worth "
        f"{abs(first.cell.cut - last.cell.cut):g} points, and no model of occupancy and size does better than half of "
        "it."
        for first, last in pairs
    )


def _notches(cells: Sequence[CellResult]) -> str:
    found = [(one, one.placebo) for one in cells if one.placebo is not None]
    low = min(100 * min(placebo.std_cuts) for _, placebo in found)
    high = max(100 * max(placebo.std_cuts) for _, placebo in found)
    least = min(found, key=lambda pair: pair[0].cut - 100 * max(pair[1].std_cuts))
    return (
        f"The same twenty notches at empty orders beside cut {low:.1f} to {high:.1f} %: that much of a published cut "
        f"is no noise removed. It is most against the cut at Table {least[0].cell.table}, {least[0].cell.shown}: up to "
        f"{100 * max(least[1].std_cuts):.1f} of {least[0].cut:.1f} %."
    )


def _energy(cells: Sequence[CellResult]) -> str:
    energies = [one.energy_change for one in cells if one.energy_change is not None]
    told = f"{min(energies):+.4f} to {max(energies):+.4f} %" if energies else "nothing without a speed"
    worst = max(abs(one.mean_change) for one in cells)
    falls = bool(energies) and max(energies) < 0
    found = "found here too" if falls else "not found here"
    return (
        f"The mean changes by {worst:.1g} % at most and the energy by {told}: the filter takes the mean off and puts "
        f"it back, so that the report's 0 % is no evidence, and its 'slight decrease in total energy' is {found}."
    )


def _rms(values: Sequence[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
