"""How one cell came about: catalog value, metric, value, value function, points, and what they did to the verdict."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.cell import Cell
from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.eliminate import Decision, SelectionChart
from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.pugh import PughResult
from torquerig.decide.ranks import shown_rank
from torquerig.decide.verdict import Word
from torquerig.decide.working import WorkedOut
from torquerig.errors import UnknownNameError, did_you_mean

Steps = list[tuple[str, str]]


@dataclass(frozen=True, kw_only=True)
class CellTrace:
    """All steps of one cell, in order: a label and what happened."""

    alternative: str
    criterion: str
    steps: tuple[tuple[str, str], ...]

    def told(self, label: str) -> tuple[str, ...]:
        """Return what the steps of one label say."""
        return tuple(text for name, text in self.steps if name == label)


@dataclass(frozen=True, kw_only=True)
class Standing:
    """How an alternative ends: its decision, how often it is best in joint draws, the verdict on the winner."""

    decision: Decision
    chance: float
    word: Word


def trace(worked: WorkedOut, alternative: str, criterion: str) -> CellTrace:
    """Return every step from the catalog to the verdict for one cell; UnknownNameError with the close matches."""
    matrix = worked.case.matrix
    matrix.index(alternative)
    known = {one.name: one for one in matrix.criteria}
    if criterion not in known:
        raise UnknownNameError(f"{matrix.name}: unknown criterion {criterion!r}; {did_you_mean(criterion, known)}")
    asked, together = known[criterion], worked.acceptability["together"]
    row = next(one for one in worked.chart.rows if one.alternative == alternative)
    left = alternative in together.alternatives
    standing = Standing(
        decision=row.decision,
        chance=together.chance(alternative) if left else 0.0,
        word=worked.verdict.word,
    )
    steps = (
        *value_steps(matrix.cell(alternative, criterion), asked, alternative),
        *demand_steps(worked.chart, asked, alternative),
        *sign_steps(worked.pugh, asked, alternative),
        *point_steps(worked.overall, asked, alternative, standing),
    )
    return CellTrace(alternative=alternative, criterion=criterion, steps=steps)


def all_traces(worked: WorkedOut) -> tuple[CellTrace, ...]:
    """Return the trace of every cell, row by row."""
    matrix = worked.case.matrix
    return tuple(trace(worked, name, one.name) for name in matrix.alternatives for one in matrix.criteria)


def value_steps(cell: Cell, criterion: Criterion, alternative: str) -> Steps:
    """Return the steps from the catalog to the value, with what is missing and what was set by hand."""
    return [*_origins(cell), *_value(cell, criterion, alternative)]


def demand_steps(chart: SelectionChart, criterion: Criterion, alternative: str) -> Steps:
    """Return what the elimination says of the cell; nothing where nothing is demanded."""
    if criterion.demand is None:
        return []
    row = next(one for one in chart.rows if one.alternative == alternative)
    rule = criterion.demand.rule(criterion.name, criterion.unit)
    mark = row.marks.get(criterion.name)
    told = next((one.sentence() for one in row.remarks if one.criterion == criterion.name), f"{mark} {rule}")
    return [("demand", told if mark else f"{rule}: not asked, an earlier demand eliminates it")]


def sign_steps(pugh: PughResult, criterion: Criterion, alternative: str) -> Steps:
    """Return the sign against the datum."""
    sign = pugh.signs(alternative)[pugh.criteria.index(criterion.name)]
    return [("Pugh", f"{sign} against {pugh.datum}")]


def point_steps(result: KesselringResult, criterion: Criterion, alternative: str, standing: Standing) -> Steps:
    """Return the steps from the value function over points and weight to the verdict."""
    if criterion.weight <= 0 or criterion.value is None:
        return [("points", "none: the criterion has no weight"), ("decision", str(standing.decision))]
    knots = ", ".join(f"{value:g} -> {points:g}" for value, points in criterion.value.knots)
    steps = [("value function", f"{knots} (straight lines between, level outside)")]
    if alternative not in result.alternatives:
        return [*steps, ("points", "none: a demand eliminates it"), ("decision", str(standing.decision))]
    place, column = result.alternatives.index(alternative), result.criteria.index(criterion.name)
    low, high, middle = (float(ends[place, column]) for ends in (result.low, result.high, result.middle))
    weight, share = float(result.weights[column]), float(result.normalised[column])
    points = f"{middle:.3g}" if low == high else f"{middle:.3g}, from {low:.3g} to {high:.3g}"
    return [
        *steps,
        ("points", f"{points}, on the scale {result.profile.p_min:g} to {result.profile.p_max:g}"),
        ("weight", f"{weight:g} as given, {share:.3f} normalised: adds {weight * middle:.3g} to T"),
        *end_steps(result, alternative, standing),
    ]


def end_steps(result: KesselringResult, alternative: str, standing: Standing) -> Steps:
    """Return the sum of an alternative and how it ends, which all its cells share."""
    place = result.alternatives.index(alternative)
    best, worst = (int(ends[place]) for ends in result.rank_range)
    total = f"T {result.total[place]:.4g} of {result.ideal:.4g}, T/T_max {result.share[place]:.3f}"
    return [
        ("total", f"{total}, rank {shown_rank(best, worst)}"),
        ("decision", f"{standing.decision}; best in {standing.chance:.0%} of joint draws; verdict {standing.word}"),
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
