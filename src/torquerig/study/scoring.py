"""From measured figures to matrices: requirements on each drive, criteria on each drive with each filter."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from torquerig.decide.criterion import Kind
from torquerig.decide.eliminate import Decision, SelectionChart, eliminate
from torquerig.decide.kesselring import TEACHING, KesselringResult, kesselring
from torquerig.decide.matrix import Cell, DecisionMatrix
from torquerig.decide.pugh import PughResult, pugh
from torquerig.errors import InputError
from torquerig.metrics.figure import Figure
from torquerig.study.criteria import criteria_of, requirements_of
from torquerig.study.missing_data import missing_data_text
from torquerig.study.origins import metric_text, origins_in_rig, origins_of

if TYPE_CHECKING:
    from torquerig.decide.cell import Origin
    from torquerig.study.results import DriveResult, StudyRuns
    from torquerig.study.settings import Metric, Settings


@dataclass(frozen=True, kw_only=True)
class Alternative:
    """One motor x gearbox x filter."""

    drive: DriveResult
    chain: str

    @property
    def name(self) -> str:
        """The name in tables: ``HDS6A-0104A 5:1 | order_lines``."""
        return f"{self.drive.candidate.name} | {self.chain}"


@dataclass(frozen=True, kw_only=True)
class Decided:
    """The three matrices of a study.

    Parameters
    ----------
    requirements : DecisionMatrix
        Every drive against the requirements; ``chart`` is its elimination.
    criteria : DecisionMatrix
        Every combination against the criteria, also those that a requirement eliminates.
    matrix : DecisionMatrix
        Its rows that are ranked: every surviving drive with every filter; the present drive is in it as the baseline
        even where a requirement eliminates it.
    overall, technical, economic : KesselringResult
        All criteria together (the ranking), and each kind apart (the axes of the S-diagram).
    alternatives : mapping of str to Alternative
        The rows of ``matrix`` by name.
    """

    requirements: DecisionMatrix
    chart: SelectionChart
    alternatives: Mapping[str, Alternative]
    baseline: str
    criteria: DecisionMatrix
    matrix: DecisionMatrix
    pugh: PughResult
    overall: KesselringResult
    technical: KesselringResult
    economic: KesselringResult | None

    def ranked(self) -> tuple[str, ...]:
        """Return the names of all alternatives, the best by the overall T first; ties keep the order of the study."""
        totals = self.overall.total
        return tuple(self.overall.alternatives[row] for row in sorted(range(len(totals)), key=lambda row: -totals[row]))


def decide(runs: StudyRuns) -> Decided:
    """Return elimination, Pugh and Kesselring of a study's runs."""
    settings, in_rig = runs.study.settings, _origins(runs)
    requirements = DecisionMatrix(
        name="requirements",
        alternatives=tuple(drive.candidate.name for drive in runs.drives),
        criteria=requirements_of(runs.study),
        cells={
            (drive.candidate.name, name): _cell(drive, None, row.metric, settings, in_rig=in_rig[drive.candidate.name])
            for drive in runs.drives
            for name, row in settings.requirements.items()
        },
    )
    chart = eliminate(requirements)
    kept = set(chart.with_decision(Decision.PURSUE, Decision.OPEN, Decision.REVISE))
    present = _present(runs)
    made_all = combinations(runs)
    alternatives = {made.name: made for made in made_all if made.drive.candidate.name in kept or made.drive is present}
    criteria = criteria_matrix(runs, made_all)
    matrix = criteria.only(alternatives=alternatives)
    baseline = f"{present.candidate.name} | {settings.present.filter}"
    counts = any(row.kind is Kind.ECONOMIC and row.weight > 0 for row in matrix.criteria)
    economic = matrix.only(kind=Kind.ECONOMIC) if counts else None
    return Decided(
        requirements=requirements,
        chart=chart,
        alternatives=alternatives,
        baseline=baseline,
        criteria=criteria,
        matrix=matrix,
        pugh=pugh(matrix, baseline),
        overall=kesselring(matrix, profile=TEACHING),
        technical=kesselring(matrix.only(kind=Kind.TECHNICAL), profile=TEACHING),
        economic=None if economic is None else kesselring(economic, profile=TEACHING),
    )


def combinations(runs: StudyRuns) -> tuple[Alternative, ...]:
    """Return every simulated drive with each filter, also those that a requirement eliminates."""
    return tuple(Alternative(drive=drive, chain=chain) for drive in runs.drives for chain in drive.chains)


def criteria_matrix(runs: StudyRuns, alternatives: tuple[Alternative, ...]) -> DecisionMatrix:
    """Return these combinations against the criteria of the study."""
    settings, in_rig = runs.study.settings, _origins(runs)
    return DecisionMatrix(
        name="criteria",
        alternatives=tuple(made.name for made in alternatives),
        criteria=criteria_of(runs.study),
        cells={
            (made.name, name): _cell(
                made.drive, made.chain, row.metric, settings, in_rig=in_rig[made.drive.candidate.name]
            )
            for made in alternatives
            for name, row in settings.criteria.items()
        },
    )


def _origins(runs: StudyRuns) -> dict[str, tuple[Origin, ...]]:
    return {drive.candidate.name: origins_in_rig(drive) for drive in runs.drives}


def _present(runs: StudyRuns) -> DriveResult:
    """Return the present drive of the rig; where the gearbox is fixed, the present motor on that gearbox."""
    present = runs.study.settings.present
    same = [drive for drive in runs.drives if drive.candidate.motor == present.motor and drive.chains]
    if not same:
        raise InputError(
            f"{runs.study.document.place(('study', 'present', 'motor'))}: the present motor {present.motor!r} is not "
            "among the simulated drives, and the Pugh matrix needs it as its baseline; list it under motors, or name "
            "another present drive that reaches the speed"
        )
    here = runs.study.present_gearbox
    return next((drive for drive in same if drive.candidate.gearbox == here), same[0])


def _cell(
    drive: DriveResult, chain: str | None, metric: Metric, settings: Settings, *, in_rig: tuple[Origin, ...]
) -> Cell:  # fmt: skip
    """Return the cell of a figure; the missing value is drawn once for all filters of a drive."""
    figure = figure_of(drive, chain, metric)
    text = metric_text(metric, figure, chain=chain, settings=settings)
    missing = missing_data_text(figure.missing, drive.candidate)
    stated = figure if missing == figure.missing else replace(figure, missing=missing)
    cell = cell_of(stated, origins=origins_of(figure, metric, in_rig=in_rig), metric=text)
    if cell.known:
        return cell
    return replace(cell, fact=cell.unknown_reason or f"{metric.replace('_', ' ')} of {drive.candidate.name}")


def figure_of(drive: DriveResult, chain: str | None, metric: str) -> Figure:
    """Return a metric of a drive with a chain; metrics behind a filter are unknown without one."""
    if metric == "truth_error":
        return Figure(unit=drive.disturbance.unit) if chain is None else drive.chains[chain].truth_error
    if metric == "residual_disturbance":
        return Figure(unit=drive.disturbance.unit) if chain is None else drive.chains[chain].residual_disturbance
    if metric == "disturbance":
        return drive.disturbance
    return drive.margins.get(metric) or Figure(missing=f"{metric.replace('_', ' ')} of {drive.candidate.name}")


def cell_of(figure: Figure, *, origins: tuple[Origin, ...] = (), metric: str = "") -> Cell:
    """Return the cell of a figure: its value, its interval, or ``?`` with the missing value.

    ``origins`` and ``metric`` are the catalog values behind it, and its calculation as text.
    """
    if figure.unknown:
        return Cell(unknown_reason=figure.missing, source=figure.source, origins=origins, metric=metric)
    interval = figure.low is not None and figure.high is not None and figure.low < figure.high
    return Cell(
        value=figure.value if figure.value is not None or interval else figure.low,
        low=figure.low if interval else None,
        high=figure.high if interval else None,
        source=figure.source,
        unknown_reason=figure.missing,
        origins=origins,
        metric=metric,
    )
