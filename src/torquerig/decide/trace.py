"""Trace of one cell: catalog value, metric, value, value function, points, rank and verdict."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from torquerig.decide.cell import Cell
from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.ranks import shown_rank
from torquerig.errors import UnknownNameError, did_you_mean

if TYPE_CHECKING:
    from torquerig.decide.eliminate import Decision, SelectionChart
    from torquerig.decide.kesselring import KesselringResult
    from torquerig.decide.matrix_analysis import MatrixAnalysis
    from torquerig.decide.pugh import PughResult
    from torquerig.decide.verdict import Certainty

Steps = list[tuple[str, str]]


@dataclass(frozen=True, kw_only=True)
class CellTrace:
    """All steps of one cell, in order: a label and what happened."""

    alternative: str
    criterion: str
    steps: tuple[tuple[str, str], ...]

    def texts(self, label: str) -> tuple[str, ...]:
        """Return the texts of the steps with this label."""
        return self._by_label.get(label, ())

    @cached_property
    def _by_label(self) -> dict[str, tuple[str, ...]]:
        found: dict[str, tuple[str, ...]] = {}
        for name, text in self.steps:
            found[name] = (*found.get(name, ()), text)
        return found


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """The result of an alternative: its decision, the share of samples in which it is best, and the verdict."""

    decision: Decision
    best_share: float
    certainty: Certainty


def trace(analysis: MatrixAnalysis, alternative: str, criterion: str) -> CellTrace:
    """Return every step from the catalog to the verdict for one cell; UnknownNameError with the close matches."""
    matrix = analysis.case.matrix
    matrix.index(alternative)
    known = {one.name: one for one in matrix.criteria}
    if criterion not in known:
        raise UnknownNameError(f"{matrix.name}: unknown criterion {criterion!r}; {did_you_mean(criterion, known)}")
    rated, together = known[criterion], analysis.acceptability["together"]
    row = next(one for one in analysis.chart.rows if one.alternative == alternative)
    is_rated = alternative in together.alternatives
    outcome = Outcome(
        decision=row.decision,
        best_share=together.best_share(alternative) if is_rated else 0.0,
        certainty=analysis.verdict.certainty,
    )
    steps = (
        *value_steps(matrix.cell(alternative, criterion), rated, alternative),
        *requirement_steps(analysis.chart, rated, alternative),
        *sign_steps(analysis.pugh, rated, alternative),
        *point_steps(analysis.overall, rated, alternative, outcome),
    )
    return CellTrace(alternative=alternative, criterion=criterion, steps=steps)


def all_traces(analysis: MatrixAnalysis) -> tuple[CellTrace, ...]:
    """Return the trace of every cell, row by row."""
    matrix = analysis.case.matrix
    return tuple(trace(analysis, name, one.name) for name in matrix.alternatives for one in matrix.criteria)


def value_steps(cell: Cell, criterion: Criterion, alternative: str) -> Steps:
    """Return the steps from the catalog to the value, with what is missing and what was set by hand."""
    return [*_origins(cell), *_value(cell, criterion, alternative)]


def requirement_steps(chart: SelectionChart, criterion: Criterion, alternative: str) -> Steps:
    """Return the result of the elimination for the cell; nothing where there is no requirement."""
    if criterion.requirement is None:
        return []
    row = next(one for one in chart.rows if one.alternative == alternative)
    rule = criterion.requirement.rule(criterion.name, criterion.unit)
    mark = row.marks.get(criterion.name)
    text = next((one.sentence() for one in row.remarks if one.criterion == criterion.name), f"{mark} {rule}")
    return [("requirement", text if mark else f"{rule}: not tested, an earlier requirement eliminates it")]


def sign_steps(pugh: PughResult, criterion: Criterion, alternative: str) -> Steps:
    """Return the sign against the baseline."""
    sign = pugh.signs(alternative)[pugh.criteria.index(criterion.name)]
    return [("Pugh", f"{sign} against {pugh.baseline}")]


def point_steps(result: KesselringResult, criterion: Criterion, alternative: str, outcome: Outcome) -> Steps:
    """Return the steps from the value function over points and weight to the verdict."""
    if criterion.weight <= 0 or criterion.value is None:
        return [("points", "none: the criterion has no weight"), ("decision", str(outcome.decision))]
    knots = ", ".join(f"{value:g} -> {points:g}" for value, points in criterion.value.knots)
    steps = [("value function", f"{knots} (straight lines between, level outside)")]
    if alternative not in result.alternatives:
        return [*steps, ("points", "none: a requirement eliminates it"), ("decision", str(outcome.decision))]
    place, column = result.alternatives.index(alternative), result.criteria.index(criterion.name)
    low, high, middle = (float(ends[place, column]) for ends in (result.low, result.high, result.middle))
    weight, share = float(result.weights[column]), float(result.normalised[column])
    points = f"{middle:.3g}" if low == high else f"{middle:.3g}, from {low:.3g} to {high:.3g}"
    return [
        *steps,
        ("points", f"{points}, on the scale {result.profile.p_min:g} to {result.profile.p_max:g}"),
        ("weight", f"{weight:g} as given, {share:.3f} normalised: adds {weight * middle:.3g} to T"),
        *end_steps(result, alternative, outcome),
    ]


def end_steps(result: KesselringResult, alternative: str, outcome: Outcome) -> Steps:
    """Return the sum, rank and decision of an alternative, which are the same for all its cells."""
    place = result.alternatives.index(alternative)
    best, worst = (int(ends[place]) for ends in result.rank_range)
    total = f"T {result.total[place]:.4g} of {result.ideal:.4g}, T/T_max {result.share[place]:.3f}"
    share = f"{outcome.best_share:.0%} of the Monte Carlo samples"
    return [
        ("total", f"{total}, rank {shown_rank(best, worst)}"),
        ("decision", f"{outcome.decision}; best in {share}; verdict {outcome.certainty}"),
    ]


def _origins(cell: Cell) -> Steps:
    steps = [
        ("catalog", f"{one.name}: {one.shown}{f' [{one.evidence}]' if one.evidence else ''}{_from(one.source)}")
        for one in cell.origins
    ]
    return [*steps, ("metric", cell.metric)] if cell.metric else steps


def _value(cell: Cell, criterion: Criterion, alternative: str) -> Steps:
    unit = "" if criterion.unit in ("1", YES_NO) else f" [{criterion.unit}]"
    stated = Cell(value=cell.value, low=cell.low, high=cell.high, text=cell.text)
    evidence = f" [{cell.evidence}]" if cell.evidence else ""
    steps = [("value", f"{stated.shown()}{unit}{evidence}{_from(cell.source)}")]
    if not stated.known:
        steps.append(("missing", cell.fact or cell.unknown_reason or f"{criterion.name} of {alternative}"))
    if cell.note:
        steps.append(("note", cell.note))
    if (hand := cell.by_hand) is not None:
        what = f"value {hand.value:g}{unit}" if hand.value is not None else f"{hand.points:g} points"
        steps.append(("set by hand", f"{what}, because: {hand.reason}"))
    return steps


def _from(source: str) -> str:
    return f", from {source}" if source else ""
