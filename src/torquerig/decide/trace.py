"""How one cell came about: catalog value, metric, value, value function, points, and what they did to the verdict."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.cell import Cell
from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.ranks import shown_rank
from torquerig.decide.working import WorkedOut
from torquerig.errors import UnknownNameError, did_you_mean

Steps = list[tuple[str, str]]


@dataclass(frozen=True, kw_only=True)
class CellTrace:
    """All steps of one cell, in order: a label and what happened."""

    alternative: str
    criterion: str
    steps: tuple[tuple[str, str], ...]


def trace(worked: WorkedOut, alternative: str, criterion: str) -> CellTrace:
    """Return every step from the catalog to the verdict for one cell; UnknownNameError with the close matches."""
    matrix = worked.case.matrix
    matrix.index(alternative)
    known = {one.name: one for one in matrix.criteria}
    if criterion not in known:
        raise UnknownNameError(f"{matrix.name}: unknown criterion {criterion!r}; {did_you_mean(criterion, known)}")
    asked, cell = known[criterion], matrix.cell(alternative, criterion)
    steps: Steps = [
        *_origins(cell),
        *_value(cell, asked, alternative),
        *_judged(worked, alternative, asked),
        *_points(worked, alternative, asked),
    ]
    return CellTrace(alternative=alternative, criterion=criterion, steps=tuple(steps))


def all_traces(worked: WorkedOut) -> tuple[CellTrace, ...]:
    """Return the trace of every cell, row by row."""
    matrix = worked.case.matrix
    return tuple(trace(worked, name, one.name) for name in matrix.alternatives for one in matrix.criteria)


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


def _judged(worked: WorkedOut, alternative: str, criterion: Criterion) -> Steps:
    steps = []
    row = next(one for one in worked.chart.rows if one.alternative == alternative)
    if criterion.demand is not None:
        rule = criterion.demand.rule(criterion.name, criterion.unit)
        mark = row.marks.get(criterion.name)
        told = next((one.sentence() for one in row.remarks if one.criterion == criterion.name), f"{mark} {rule}")
        steps.append(("demand", told if mark else f"{rule}: not asked, an earlier demand eliminates it"))
    sign = worked.pugh.signs(alternative)[worked.pugh.criteria.index(criterion.name)]
    steps.append(("Pugh", f"{sign} against {worked.pugh.datum}"))
    return steps


def _points(worked: WorkedOut, alternative: str, criterion: Criterion) -> Steps:
    result = worked.overall
    row = next(one for one in worked.chart.rows if one.alternative == alternative)
    if criterion.weight <= 0 or criterion.value is None:
        return [("points", "none: the criterion has no weight"), ("decision", str(row.decision))]
    knots = ", ".join(f"{value:g} -> {points:g}" for value, points in criterion.value.knots)
    steps = [("value function", f"{knots} (straight lines between, level outside)")]
    if alternative not in result.alternatives:
        return [*steps, ("points", "none: a demand eliminates it"), ("decision", str(row.decision))]
    place, column = result.alternatives.index(alternative), result.criteria.index(criterion.name)
    low, high, middle = (float(ends[place, column]) for ends in (result.low, result.high, result.middle))
    weight, share = float(result.weights[column]), float(result.normalised[column])
    best, worst = (int(ends[place]) for ends in result.rank_range)
    points = f"{middle:.3g}" if low == high else f"{middle:.3g}, from {low:.3g} to {high:.3g}"
    total = f"T {result.total[place]:.4g} of {result.ideal:.4g}, T/T_max {result.share[place]:.3f}"
    chance = worked.acceptability["together"].chance(alternative)
    return [
        *steps,
        ("points", f"{points}, on the scale {result.profile.p_min:g} to {result.profile.p_max:g}"),
        ("weight", f"{weight:g} as given, {share:.3f} normalised: adds {weight * middle:.3g} to T"),
        ("total", f"{total}, rank {shown_rank(best, worst)}"),
        ("decision", f"{row.decision}; best in {chance:.0%} of joint draws; verdict {worked.verdict.word}"),
    ]


def _from(source: str) -> str:
    return f", from {source}" if source else ""
