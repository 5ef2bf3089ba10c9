"""The Kesselring sheet: formulas from weights and points to totals, T/T_max and ranks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from torquerig.decide.ranks import TIE

if TYPE_CHECKING:
    from torquerig.decide.kesselring import KesselringResult

Looks = dict[str, Any]
HEAD, WEIGHTS, NORMALISED, IDEAL, FIRST = 1, 2, 3, 4, 5
"""Rows of the sheet, counted from 0; the combinations start at ``FIRST``."""
TOTALS = ("T", "T/T_max", "rank", "T low", "T high", "best rank", "worst rank")


@dataclass(frozen=True, kw_only=True)
class Links:
    """Formulas that fetch what the sheet calculates with from other sheets.

    Parameters
    ----------
    weight : function of the criterion's place
    points : function of the places of alternative and criterion, and of 0, 1, 2 for middle, fewest and most
    ideal : str
    hint : str
        Instruction for the reader.
    """

    weight: Callable[[int], str]
    points: Callable[[int, int, int], str]
    ideal: str
    hint: str


HINT = "Change the weights in the coloured row; totals and ranks are recalculated."


def write_kesselring(sheet: Any, looks: Looks, result: KesselringResult, *, links: Links | None = None) -> None:
    """Write weights, ideal, points and the formulas over them, each with its present value stored.

    With ``links``, weights and points are formulas themselves. Further columns hold the fewest and the most points
    that the facts allow; they give the range of the rank.
    Ranks are shared competition ranks: 1 plus how many are better by more than rounding.
    """
    from xlsxwriter.utility import xl_range_abs

    count = len(result.criteria)
    points, low, high = 1, 1 + count + len(TOTALS), 1 + 2 * count + len(TOTALS)
    sheet.write_string(0, 0, f"{HINT if links is None else links.hint} Points in italics are the middle of an "
                       "uncertain range.", looks["bold"])  # fmt: skip
    _head(sheet, looks, result)
    weights = xl_range_abs(WEIGHTS, 1, WEIGHTS, count)
    for column in range(count):
        weight, share = float(result.weights[column]), float(result.normalised[column])
        _number(sheet, (WEIGHTS, 1 + column), weight, looks["weight" if links is None else "three"],
                None if links is None else links.weight(column))  # fmt: skip
        sheet.write_formula(NORMALISED, 1 + column, f"={_cell(WEIGHTS, 1 + column)}/SUM({weights})", looks["three"],
                            share)  # fmt: skip
        _number(sheet, (IDEAL, 1 + column), result.profile.p_max, None,
                None if links is None else links.ideal)  # fmt: skip
    _ideal(sheet, looks, result, weights)
    for row, name in enumerate(result.alternatives):
        sheet.write_string(FIRST + row, 0, name)
        for column in range(count):
            known = result.low[row, column] == result.high[row, column]
            by_hand = (name, result.criteria[column]) in result.by_hand
            look = looks["hand" if by_hand else "three" if known else "guess"]
            blocks = (
                (points, result.middle, look),
                (low, result.low, looks["three"]),
                (high, result.high, looks["three"]),
            )
            for block, (start, ends, looked) in enumerate(blocks):
                formula = None if links is None else links.points(row, column, block)
                _number(sheet, (FIRST + row, start + column), float(ends[row, column]), looked, formula)
        _totals(sheet, looks, result, row=row, blocks=(points, low, high), weights=weights)
    last = FIRST + len(result.alternatives) - 1
    scale = {"type": "3_color_scale", "min_color": "#F4B6AE", "mid_color": "#FFF3C9", "max_color": "#B5DDB4"}
    sheet.conditional_format(FIRST, points, last, points + count - 1,
                             scale | {"min_type": "num", "min_value": result.profile.p_min, "mid_type": "num",
                                      "mid_value": (result.profile.p_min + result.profile.p_max) / 2,
                                      "max_type": "num", "max_value": result.profile.p_max})  # fmt: skip
    sheet.conditional_format(FIRST, count + 2, last, count + 2, scale)


def _number(sheet: Any, place: tuple[int, int], value: float, look: Any, formula: str | None) -> None:
    """Write a number, or the formula that gives it, with the number as stored value."""
    if formula:
        sheet.write_formula(*place, formula, look, value)
    else:
        sheet.write_number(*place, value, look)


def _head(sheet: Any, looks: Looks, result: KesselringResult) -> None:
    fewest, most = ([f"{word} points: {name}" for name in result.criteria] for word in ("fewest", "most"))
    for column, text in enumerate(["combination", *result.criteria, *TOTALS, *fewest, *most]):
        sheet.write_string(HEAD, column, text, looks["head"])
        sheet.set_column(column, column, 46 if column == 0 else 11)
    for row, text in ((WEIGHTS, "weight as given"), (NORMALISED, "weight normalised"), (IDEAL, "ideal")):
        sheet.write_string(row, 0, text, looks["bold"])
    sheet.freeze_panes(FIRST, 1)


def _ideal(sheet: Any, looks: Looks, result: KesselringResult, weights: str) -> None:
    from xlsxwriter.utility import xl_range

    count = len(result.criteria)
    ideal = xl_range(IDEAL, 1, IDEAL, count)
    sheet.write_formula(IDEAL, count + 1, f"=SUMPRODUCT({weights},{ideal})", looks["three"], result.ideal)
    sheet.write_formula(IDEAL, count + 2, f"={_cell(IDEAL, count + 1)}/{_cell(IDEAL, count + 1)}", looks["three"], 1)
    sheet.write_formula(WEIGHTS, count + 1, f"=SUM({weights})", looks["three"], result.weight_sum)


def _totals(
    sheet: Any, looks: Looks, result: KesselringResult, *, row: int, blocks: tuple[int, int, int], weights: str
) -> None:
    """Write T, T/T_max, rank, and their ranges; the columns of ``TOTALS`` in order."""
    from xlsxwriter.utility import xl_range, xl_range_abs

    count, line = len(result.criteria), FIRST + row
    total, share, rank, low, high, best, worst = range(count + 1, count + 1 + len(TOTALS))
    last = FIRST + len(result.alternatives) - 1
    whole = {column: xl_range_abs(FIRST, column, last, column) for column in (total, low, high)}
    ends = zip((total, low, high), blocks, (result.total, result.total_low, result.total_high), strict=True)
    for column, block, values in ends:
        formula = f"=SUMPRODUCT({weights},{xl_range(line, block, line, block + count - 1)})"
        sheet.write_formula(line, column, formula, looks["three"], float(values[row]))
    sheet.write_formula(line, share, f"={_cell(line, total)}/{_cell(IDEAL, total, fixed=True)}", looks["three"],
                        float(result.share[row]))  # fmt: skip
    above = {column: f"1+SUMPRODUCT(({whole[column]}>{{}}+{TIE})*1)" for column in (total, low, high)}
    best_rank, worst_rank = (int(ends[row]) for ends in result.rank_range)
    sheet.write_formula(line, rank, f"={above[total].format(_cell(line, total))}", None, int(result.ranks[row]))
    sheet.write_formula(line, best, f"={above[low].format(_cell(line, high))}", None, best_rank)
    # the highest total of an alternative may exceed its lowest one; it does not rank against itself
    itself = f"({_cell(line, high)}>{_cell(line, low)}+{TIE})"
    sheet.write_formula(line, worst, f"={above[high].format(_cell(line, low))}-{itself}", None, worst_rank)


def _cell(row: int, column: int, *, fixed: bool = False) -> str:
    from xlsxwriter.utility import xl_rowcol_to_cell

    return str(xl_rowcol_to_cell(row, column, row_abs=fixed, col_abs=fixed))
