"""The sheets of a matrix that a person fills in: criteria, facts, settings, sources."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.matrix_io import excel_layout as layout

if TYPE_CHECKING:
    from torquerig.decide.case import MatrixCase
    from torquerig.decide.cell import Cell

Looks = dict[str, Any]
Entry = str | float | int | None
SPARE_KNOTS = 2  # columns of knots beyond the longest value function, to be filled in


def criterion_heads(case: MatrixCase) -> tuple[str, ...]:
    """Return the heads of the sheet of criteria, with enough columns for every value function."""
    most = max(len(one.value.knots) if one.value else 0 for one in case.matrix.criteria) + SPARE_KNOTS
    knots = [text.format(number + 1) for number in range(most) for text in (layout.KNOT, layout.POINTS)]
    return (*layout.CRITERION_HEADS, *knots)


def fact_heads(case: MatrixCase) -> tuple[str, ...]:
    """Return the heads of the sheet of facts: a column per criterion, three where anybody has an interval."""
    heads: list[str] = [layout.FACT_HEAD]
    for criterion in case.matrix.criteria:
        heads.append(criterion.name)
        cells = [case.matrix.cell(name, criterion.name) for name in case.matrix.alternatives]
        if criterion.unit != YES_NO and any(cell.low is not None for cell in cells):
            heads += [text.format(criterion.name) for text in (layout.LOW, layout.HIGH)]
    return tuple(heads)


def source_rows(case: MatrixCase) -> tuple[tuple[str, str], ...]:
    """Return the cells that have more than a number, in the order of their rows."""
    matrix = case.matrix
    pairs = ((name, one.name) for name in matrix.alternatives for one in matrix.criteria)
    return tuple(pair for pair in pairs if any(text for text in _remarks(matrix.cell(*pair)).values()))


def write_criteria(sheet: Any, looks: Looks, case: MatrixCase) -> None:
    """Write a row per criterion, with its value function as pairs of columns."""
    rows = []
    for one in case.matrix.criteria:
        knots = one.value.knots if one.value else ()
        held = _criterion(one)
        held |= {layout.KNOT.format(place): value for place, (value, _) in enumerate(knots, start=1)}
        held |= {layout.POINTS.format(place): points for place, (_, points) in enumerate(knots, start=1)}
        rows.append(held)
    _table(sheet, looks, criterion_heads(case), rows, wide={0: 30, 7: 24, 12: 40})


def write_facts(sheet: Any, looks: Looks, case: MatrixCase) -> None:
    """Write a row per alternative: the value or ``?``, and the interval in two further columns."""
    rows = []
    for name in case.matrix.alternatives:
        held: dict[str, Entry] = {layout.FACT_HEAD: name}
        for one in case.matrix.criteria:
            cell = case.matrix.cell(name, one.name)
            if one.unit == YES_NO:
                held[one.name] = "?" if cell.value is None else "yes" if cell.value else "no"
                continue
            held[one.name] = "?" if cell.value is None else cell.value
            held |= {layout.LOW.format(one.name): cell.low, layout.HIGH.format(one.name): cell.high}
        rows.append(held)
    _table(sheet, looks, fact_heads(case), rows, wide={0: 30})


def write_settings(sheet: Any, looks: Looks, case: MatrixCase) -> None:
    """Write what else a case has, a setting per row in the order of ``excel_layout.SETTING_KEYS``."""
    held: tuple[Entry, ...] = (
        case.matrix.name, case.baseline, case.profile.p_min, case.profile.p_max, case.goal, ", ".join(case.goal_words),
        case.draws, case.seed, case.uncertainty.scores, case.uncertainty.weights,
        case.cost.criterion if case.cost else None, case.cost.permissible if case.cost else None,
    )  # fmt: skip
    rows: list[Mapping[str, Entry]] = [
        {"setting": key, "value": value} for key, value in zip(layout.SETTING_KEYS, held, strict=True)
    ]
    _table(sheet, looks, ("setting", "value"), rows, wide={0: 20, 1: 40})


def write_sources(sheet: Any, looks: Looks, case: MatrixCase) -> None:
    """Write where the facts come from, what is missing, and what was set by hand with its reason."""
    rows: list[Mapping[str, Entry]] = [
        {"alternative": pair[0], "criterion": pair[1], **_remarks(case.matrix.cell(*pair))}
        for pair in source_rows(case)
    ]
    _table(
        sheet, looks, layout.SOURCE_HEADS, rows, wide={0: 24, 1: 28, 2: 40, 4: 30, 5: 40, 6: 30, 7: 30, 8: 40, 11: 50}
    )


def _criterion(one: Criterion) -> dict[str, Entry]:
    limits, band, same = one.requirement, one.band, one.indifference
    return {
        "criterion": one.name,
        "unit": one.unit,
        "better": str(one.better),
        "weight": one.weight,
        "kind": str(one.kind),
        "requirement min": limits.low if limits else None,
        "requirement max": limits.high if limits else None,
        "in question": limits.in_question if limits else "",
        "band low": band[0] if band else None,
        "band high": band[1] if band else None,
        "same within": same.absolute or None,
        "same within share": same.relative or None,
        "purpose": one.purpose,
    }


def _remarks(cell: Cell) -> dict[str, Entry]:
    hand = cell.by_hand
    return {
        "source": cell.source,
        "evidence": cell.evidence,
        "note": cell.note,
        "missing": cell.unknown_reason,
        "fact": cell.fact,
        "metric": cell.metric,
        "origins": layout.NEXT.join(
            layout.WITHIN.join((one.name, one.shown, one.evidence, one.source)) for one in cell.origins
        ),
        "by hand value": hand.value if hand else None,
        "by hand points": hand.points if hand else None,
        "reason": hand.reason if hand else "",
    }


def _table(
    sheet: Any, looks: Looks, heads: Sequence[str], rows: Sequence[Mapping[str, Entry]], *, wide: Mapping[int, int]
) -> None:
    for column, head in enumerate(heads):
        sheet.write_string(0, column, head, looks["head"])
        sheet.set_column(column, column, wide.get(column, 12))
    for number, row in enumerate(rows, start=1):
        for column, head in enumerate(heads):
            value = row.get(head)
            if value is None or value == "":
                sheet.write_blank(number, column, None, looks["entry"])
            elif isinstance(value, str):
                sheet.write_string(number, column, value, looks["unknown" if value == "?" else "entry"])
            else:
                sheet.write_number(number, column, value, looks["entry"])
    sheet.freeze_panes(1, 1)
