"""The reference report's results and the simulated rig: fit, cells, mechanical noise, readings of the figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from torquerig.catalog.reading import Catalog
from torquerig.document import Document
from torquerig.errors import InputError
from torquerig.filters.chains.filter_chain import Chain, report_filter_code_chain
from torquerig.recordings.recording import Recording
from torquerig.study.reference_report.cells import CellResult, cell_results
from torquerig.study.reference_report.conditions import ReportRig
from torquerig.study.reference_report.fitting import Fit, fitted
from torquerig.study.reference_report.mechanical import HIGH, LOW, MechanicalDrop, mechanical_drop
from torquerig.study.reference_report.published import CELLS, MECHANICAL_DROP, OCCUPANCIES
from torquerig.study.reference_report.superposition import everywhere

Progress = Callable[[int, int, str], None]


@dataclass(frozen=True, kw_only=True)
class ReportResults:
    """Results that the page shows.

    Parameters
    ----------
    rig : ReportRig
    chain : Chain
        The report's filter as its code runs.
    fit : Fit
    cells : tuple of CellResult
        In the order of the report.
    drop : MechanicalDrop
    low, high : Recording
        Readings at low and high load, of the scenario's particle size.
    small, large : Recording
        Readings at the smallest and the largest size, at the occupancy fitted for Table IX.
    """

    rig: ReportRig
    chain: Chain
    fit: Fit
    cells: tuple[CellResult, ...]
    drop: MechanicalDrop
    low: Recording
    high: Recording
    small: Recording
    large: Recording


def reference_results(document: Document, catalog: Catalog, *, seed: int, progress: Progress) -> ReportResults:
    """Return the results of the report and those of the rig of a scenario; the same seed gives the same figures.

    Raises
    ------
    InputError
        For a rig without one particle load, a run that is not steady, or a motor whose poles or slots are unknown.
    """
    rig = ReportRig(document, catalog, seed)
    _check(rig)
    chain = report_filter_code_chain(rig.kinematics)
    sizes = sorted({cell.size for cell in CELLS if cell.size is not None} | {rig.size})
    wanted = tuple((occupancy, size) for occupancy in OCCUPANCIES for size in sizes)
    places = everywhere(rig, chain, wanted, progress=progress)
    fit = fitted(CELLS, places, size=rig.size)
    cells = cell_results(rig, chain, fit, cells=CELLS, places=places, progress=progress)
    scale = fit.scale_at(rig.size)
    low, high = (rig.reading(one, rig.size, scale=scale) for one in (LOW, HIGH))
    ends = (rig.reading(fit.occupancy, size, scale=fit.scale_at(size)) for size in (sizes[0], sizes[-1]))
    return ReportResults(
        rig=rig,
        chain=chain,
        fit=fit,
        cells=cells,
        drop=mechanical_drop(rig, low, high, published=MECHANICAL_DROP),
        low=low,
        high=high,
        small=next(ends),
        large=next(ends),
    )


def _check(rig: ReportRig) -> None:
    path, run = rig.document.path, rig.scenario.rig.run
    if run.profile != "steady" or not run.speed:
        raise InputError(f"{path}: the report's results are of steady runs; write profile: steady and a speed")
    _ = rig.load
    if rig.kinematics.pole_pairs is None or rig.kinematics.slots is None:
        raise InputError(f"{path}: the report's notches need the motor's poles and slots, and they are unknown")
