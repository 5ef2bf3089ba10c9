"""The sheets of the workbook without formulas over other sheets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from torquerig.decide.pugh import PughResult, Sign
from torquerig.metrics.figure import Figure
from torquerig.reporting.figures.shades import SHARES
from torquerig.reporting.study.answers import assumptions
from torquerig.reporting.study.chapters import rule_text
from torquerig.reporting.study.tables import decision_words

if TYPE_CHECKING:
    from torquerig.decide.eliminate import SelectionChart
    from torquerig.decide.matrix import DecisionMatrix
    from torquerig.study.results import StudyRuns
    from torquerig.study.scoring import Decided

Looks = dict[str, Any]


def write_ranking(sheet: Any, looks: Looks, decided: Decided) -> None:
    """Write every combination, the best first, with the figures of all criteria and their ends."""
    criteria = decided.matrix.criteria
    head = [
        "rank",
        "best rank",
        "worst rank",
        "drive",
        "filter",
        "T/T_max",
        "T/T_max low",
        "T/T_max high",
        "requirements",
    ]
    for one in criteria:
        unit = "" if one.unit == "1" else f" [{one.unit}]"
        head += [f"{one.name}{unit}", f"{one.name} low{unit}", f"{one.name} high{unit}"]
    write_head(sheet, looks, head, wide={3: 24, 4: 22})
    result, said = decided.overall, decision_words(decided)
    best, worst = result.rank_range
    for row, name in enumerate(decided.ranked(), start=1):
        made, place = decided.alternatives[name], result.alternatives.index(name)
        for column, rank in enumerate((result.ranks[place], best[place], worst[place])):
            sheet.write_number(row, column, int(rank))
        sheet.write_string(row, 3, made.drive.candidate.name)
        sheet.write_string(row, 4, made.chain)
        totals = (result.total[place], result.total_low[place], result.total_high[place])
        for column, total in enumerate(totals, start=5):
            sheet.write_number(row, column, float(total / result.ideal), looks["three"])
        sheet.write_string(row, 8, said[made.drive.candidate.name])
        for place, one in enumerate(criteria):
            cell = decided.matrix.cell(name, one.name)
            figure = Figure(value=cell.value, low=cell.low, high=cell.high)
            _figure(sheet, looks, (row, 9 + 3 * place), figure)
    _scale(sheet, (1, 5, len(result.alternatives), 5))


def write_shares(sheet: Any, looks: Looks, runs: StudyRuns) -> None:
    """Write mean, rms and percent of the shares, a row per drive."""
    unit = runs.study.effort_unit
    head = ["motor", "gearbox", "ratio", "whole ratio", f"mean [{unit}]", *(f"{name} rms [{unit}]" for name in SHARES),
            *(f"{name} [% of power]" for name in SHARES), "out of reach"]  # fmt: skip
    write_head(sheet, looks, head, wide={0: 20, 1: 18})
    for row, drive in enumerate(runs.drives, start=1):
        made = drive.candidate
        whole = made.ratio if made.whole_ratio is None else made.whole_ratio
        sheet.write_row(row, 0, [made.motor, made.gearbox, made.ratio, whole])
        if drive.shares is None:
            for column in range(4, 5 + 2 * len(SHARES)):
                sheet.write_string(row, column, "?", looks["unknown"])
            sheet.write_string(row, 5 + 2 * len(SHARES), drive.out_of_reach)
            continue
        percent = drive.shares.percent()
        sheet.write_row(row, 4, [drive.shares.mean, *(getattr(drive.shares, name) for name in SHARES)], looks["four"])
        sheet.write_row(row, 5 + len(SHARES), [percent[name] for name in SHARES], looks["one"])


def write_elimination(
    sheet: Any, looks: Looks, chart: SelectionChart, requirements: DecisionMatrix, *, of: str = "drive"
) -> None:
    """Write the selection chart with every remark in full."""
    rules = [rule_text(one) for one in requirements.criteria if one.name in chart.criteria]
    write_head(sheet, looks, [of, *rules, "decision", "remarks"], wide={0: 24, len(rules) + 2: 110})
    for row, line in enumerate(chart.rows, start=1):
        sheet.write_string(row, 0, line.alternative)
        for column, name in enumerate(chart.criteria, start=1):
            mark = str(line.marks.get(name, ""))
            sheet.write_string(row, column, mark, looks.get(mark, looks["mark"]))
        sheet.write_string(row, len(rules) + 1, str(line.decision))
        sheet.write_string(row, len(rules) + 2, "; ".join(remark.sentence() for remark in line.remarks))


def write_pugh(sheet: Any, looks: Looks, result: PughResult) -> None:
    """Write the signs of all combinations against the baseline; the counts are formulas over the signs."""
    from xlsxwriter.utility import xl_range

    best, worst = result.rank_range
    width = len(result.criteria)
    counted = [f"count {sign}" for sign in Sign]
    net = ["net low (option)", "net high (option)", "best rank by net", "worst rank by net"]
    write_head(sheet, looks, [f"against {result.baseline}", *result.criteria, *counted, *net], wide={0: 46})
    for row, name in enumerate(result.alternatives, start=1):
        sheet.write_string(row, 0, name, looks["bold"] if name == result.baseline else None)
        for column, sign in enumerate(result.signs(name), start=1):
            sheet.write_string(row, column, str(sign), looks[str(sign)])
        signs = xl_range(row, 1, row, width)
        for column, (sign, count) in enumerate(result.counts(name).items(), start=width + 1):
            # not COUNTIF, to which ? is any character
            sheet.write_formula(row, column, f'=SUMPRODUCT(--({signs}="{sign}"))', None, count)
        ends = (result.net_low, result.net_high, best, worst)
        sheet.write_row(row, width + 1 + len(Sign), [int(end[row - 1]) for end in ends])


def write_assumptions(sheet: Any, looks: Looks, runs: StudyRuns) -> None:
    """Write every drawn value with its interval."""
    write_head(
        sheet, looks, ["motor, gearbox or part", "value", "drawn value and its interval"], wide={0: 24, 1: 36, 2: 60}
    )
    listed = [(owner, name, text) for owner, values in assumptions(runs) for name, text in values]
    for row, texts in enumerate(listed, start=1):
        for column, text in enumerate(texts):
            sheet.write_string(row, column, text)


def write_head(sheet: Any, looks: Looks, head: Sequence[str], *, wide: dict[int, int]) -> None:
    """Write the head of a sheet and the widths of its columns; head and first column are frozen."""
    for column, text in enumerate(head):
        sheet.write_string(0, column, text, looks["head"])
        sheet.set_column(column, column, wide.get(column, 12))
    sheet.freeze_panes(1, 1)


def _figure(sheet: Any, looks: Looks, place: tuple[int, int], figure: Figure) -> None:
    """Write value, low and high in three cells; ``?`` where nothing is known."""
    row, column = place
    low = figure.value if figure.low is None else figure.low
    high = figure.value if figure.high is None else figure.high
    for step, value in enumerate((figure.value, low, high)):
        if value is None:
            sheet.write_string(row, column + step, "?", looks["unknown"])
        else:
            sheet.write_number(row, column + step, value, looks["four"])


def _scale(sheet: Any, area: tuple[int, int, int, int]) -> None:
    sheet.conditional_format(
        *area, {"type": "3_color_scale", "min_color": "#F4B6AE", "mid_color": "#FFF3C9", "max_color": "#B5DDB4"}
    )
