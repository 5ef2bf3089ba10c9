"""Every published cell simulated at the fitted load over several seeds, and the load that would give its value."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.evaluation.placebo import Placebo, placebo
from torquerig.filters.filter_effect import chain_effect
from torquerig.study.reference_report.conditions import ReportRig
from torquerig.study.reference_report.fitting import Fit, Places, place_of
from torquerig.study.reference_report.published import Cell

RUNS = 3  # seeds per cell
KNOWN_HARMONICS = 30


@dataclass(frozen=True, kw_only=True)
class CellResult:
    """A published cell and its simulation.

    Parameters
    ----------
    cell : Cell
    occupancy, size : float
        Simulated conditions [%], [m].
    cut, lowest, highest : float
        Reduction of the standard deviation over the runs: mean and range [%].
    shipped_cut : float
        The same with the load of the scenario, without a fit [%].
    mean : float
        Of the reading [N m].
    mean_change, energy_change : float
        [%]; the report prints 0 for the mean and no number for the energy.
    lines, load : float
        Rms of lines and noise, and of the load's fluctuation, in the reading [N m].
    taken : float
        Share of the load's variance that the notches remove [1].
    needed : float or None
        Rms of the load's fluctuation that would give the published reduction [N m].
    placebo : Placebo or None
        The same notches at orders without lines.
    """

    cell: Cell
    occupancy: float
    size: float
    cut: float
    lowest: float
    highest: float
    shipped_cut: float
    mean: float
    mean_change: float
    energy_change: float | None
    lines: float
    load: float
    taken: float
    needed: float | None
    placebo: Placebo | None

    @property
    def difference(self) -> float:
        """Simulated minus published [percentage points]."""
        return self.cut - self.cell.cut


def cell_results(
    rig: ReportRig, chain: Chain, fit: Fit, *, cells: Sequence[Cell], places: Places,
    progress: Callable[[int, int, str], None],
) -> tuple[CellResult, ...]:  # fmt: skip
    """Return every cell, simulated at the fitted load (not superposed), ``RUNS`` times."""
    made = []
    for number, cell in enumerate(cells, start=1):
        made.append(_cell(rig, chain, fit, cell, places))
        progress(number, len(cells), f"Table {cell.table}, {cell.shown}")
    return tuple(made)


def _cell(rig: ReportRig, chain: Chain, fit: Fit, cell: Cell, places: Places) -> CellResult:
    occupancy, size = place = place_of(cell, occupancy=fit.occupancy, size=rig.size)
    scale, parts, ratio = fit.scale_at(size), places[place], rig.kinematics.ratio
    readings = [rig.reading(occupancy, size, scale=scale, run=run) for run in range(RUNS)]
    effects = [chain_effect(one, chain.apply(one), ratio=ratio) for one in readings]
    cuts = [effect.std_reduction_percent for effect in effects]
    needed = parts.needed(cell.cut)
    return CellResult(
        cell=cell,
        occupancy=occupancy,
        size=size,
        cut=sum(cuts) / len(cuts),
        lowest=min(cuts),
        highest=max(cuts),
        shipped_cut=float(parts.cut(1.0)),
        mean=parts.mean,
        mean_change=effects[0].mean_change_percent,
        energy_change=effects[0].energy_change_percent,
        lines=parts.lines(),
        load=parts.load(scale),
        taken=parts.taken(),
        needed=None if needed is None else parts.load(needed),
        placebo=placebo(chain, readings[0], known=rig.kinematics.lines(KNOWN_HARMONICS)),
    )
