"""A workbook to fill in: a Pugh or Kesselring matrix with an example, lists to choose from and live formulas."""

from __future__ import annotations

from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

from torquerig.decide.kesselring import VDI_2225
from torquerig.decide.matrix_io.matrix_table import Entry, MatrixTable, Method, Row
from torquerig.decide.matrix_io.recompute import recomputed_kesselring, recomputed_pugh, weighted_nets
from torquerig.decide.ranks import competition_ranks
from torquerig.reporting.workbook.study_workbook import CREATED, formats

HEADER, ROWS = 8, 50  # row of the names, from 0; rows below it that formulas and lists reach
WEIGHT, FIRST = 1, 2  # columns, from 0
TOP = f"{VDI_2225.p_max:g}"
_NAMES = ("Belt drive", "Spur gears", "Direct drive", "Harmonic drive")
_CRITERIA = ("torque ripple", "price", "stiffness", "assembly effort")
_WEIGHTS = (0.4, 0.2, 0.3, 0.1)
_MARKS: tuple[tuple[Entry, ...], ...] = (("+", "++", "S"), ("S", "--", "-"), ("+", "++", "+"), ("-", "+", "S"))
_POINTS: tuple[tuple[Entry, ...], ...] = (
    (2.0, 3.0, 4.0, 2.0),
    (4.0, 3.0, 1.0, 1.0),
    (1.0, 2.0, 4.0, 3.0),
    (3.0, 2.0, 4.0, 2.0),
)


@dataclass(frozen=True, kw_only=True)
class Result:
    """One line of results: name, formula over ``{cells}``, ``{weights}``, ``{above}`` and ``{one}``, present values."""

    name: str
    formula: str
    values: tuple[float, ...]
    look: str = "three"


def write_template(path: Path, method: str) -> None:
    """Write a filled example of a ``pugh`` or ``kesselring`` matrix, read by ``torquerig matrix`` to the same numbers.

    The results are above the names, so that the formulas and the lists reach over 50 rows below: a criterion written in
    the next empty row counts at once.
    """
    import xlsxwriter

    archive = BytesIO()  # the library leaves an open archive behind where the disk is full
    book = xlsxwriter.Workbook(archive, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    book.set_properties({"title": f"{method} matrix", "created": CREATED})
    looks = formats(book)
    looks |= {
        "percent": book.add_format({"num_format": "0 %", "bg_color": "#FFF2CC", "border": 1}),
        "choice": book.add_format({"num_format": "@", "align": "center", "bg_color": "#FFF2CC", "border": 1}),
        "whole": book.add_format({"num_format": "0"}),
    }
    sheet = book.add_worksheet(method.capitalize())
    table = example_table(Method(method))
    _write_texts(sheet, looks, table)
    _write_entries(sheet, looks, table)
    _write_results(sheet, looks, table)
    _add_checks(sheet, table)
    book.close()
    path.write_bytes(archive.getvalue())


def example_table(method: Method) -> MatrixTable:
    """Return the example of a template: four drives, invented marks or points, weights that sum to 1."""
    is_pugh = method is Method.PUGH
    rows = tuple(
        Row(criterion=name, entries=entries, weight=weight)
        for name, entries, weight in zip(_CRITERIA, _MARKS if is_pugh else _POINTS, _WEIGHTS, strict=True)
    )
    names, baseline = (_NAMES[1:], f"{_NAMES[0]} (datum)") if is_pugh else (_NAMES, "")
    return MatrixTable(
        name=method.value.capitalize(),
        method=method,
        alternatives=names,
        rows=rows,
        baseline=baseline,
        profile=VDI_2225,
    )


def _columns(table: MatrixTable) -> list[str]:
    return [*([table.baseline] if table.baseline else []), *table.alternatives]


def _write_texts(sheet: Any, looks: dict[str, Any], table: MatrixTable) -> None:
    is_pugh = table.method is Method.PUGH
    what = (
        "marks against the datum: ++ + S - --, ? where unknown; ++ and -- count 2 and -2"
        if is_pugh
        else f"points on the scale 0 to {TOP}, ? where unknown"
    )
    for row, text in enumerate((
        f"{table.name} matrix: overwrite the example",
        f"Coloured cells are yours: {what}.",
        "Write a new criterion in the next empty row. For a new alternative insert a column and copy another into it.",
    )):  # fmt: skip
        sheet.write_string(row, 0, text, looks["bold"] if row == 0 else None)
    sheet.write_string(HEADER, 0, "Criterion", looks["head"])
    sheet.write_string(HEADER, WEIGHT, "Weighting", looks["head"])
    for place, name in enumerate(_columns(table)):
        sheet.write_string(HEADER, FIRST + place, name, looks["head"])
    sheet.set_column(0, 0, 26)
    sheet.set_column(WEIGHT, FIRST + len(_NAMES), 16)
    sheet.freeze_panes(HEADER + 1, FIRST)


def _write_entries(sheet: Any, looks: dict[str, Any], table: MatrixTable) -> None:
    width = len(_columns(table))
    for place in range(ROWS):
        line = HEADER + 1 + place
        sheet.write_blank(line, 0, None, looks["entry"])
        sheet.write_blank(line, WEIGHT, None, looks["percent"])
        for column in range(FIRST, FIRST + width):
            sheet.write_blank(line, column, None, looks["choice" if table.baseline else "entry"])
    for line, row in enumerate(table.rows, start=HEADER + 1):
        sheet.write_string(line, 0, row.criterion, looks["entry"])
        sheet.write_number(line, WEIGHT, row.weight or 0.0, looks["percent"])
        entries = (("S",) if table.baseline else ()) + row.entries
        for column, entry in enumerate(entries, start=FIRST):
            if isinstance(entry, str):
                sheet.write_string(line, column, entry, looks["choice"])
            else:
                sheet.write_number(line, column, entry, looks["entry"])


def _results(table: MatrixTable) -> tuple[Result, ...]:
    rank = 'IF(COUNT({above})=COLUMNS({above}),1+SUMPRODUCT(({above}>{one}+0.000000001)*1),"open")'
    if table.method is Method.PUGH:
        marks = '(({cells}="++")*2+({cells}="+")-({cells}="-")-({cells}="--")*2)'
        plain = [0.0, *recomputed_pugh(table).net_certain[1:].tolist()]
        weighted = [0.0, *weighted_nets(table)[1].tolist()]
        return (
            Result(name="Unweighted sum", formula=_known(f"SUMPRODUCT({marks})"), values=tuple(plain), look="whole"),
            Result(name="Weighted sum", formula=_known(f"SUMPRODUCT({{weights}}*{marks})"), values=tuple(weighted)),
            Result(name="Rank", formula=rank, values=tuple(competition_ranks(plain).tolist()), look="whole"),
        )
    found = recomputed_kesselring(table)
    total = "SUMPRODUCT({weights},{cells})"
    return (
        Result(name="T/T_max", formula=_known(f"{total}/({TOP}*SUM({{weights}}))"), values=tuple(found.share.tolist())),
        Result(name="Weighted sum", formula=_known(total), values=tuple(found.total.tolist())),
        Result(name="Rank", formula=rank, values=tuple(found.ranks.tolist()), look="whole"),
    )


def _known(formula: str) -> str:
    """Return a formula that shows ``open`` where a cell is ``?``: an unknown value must not count as zero."""
    return f'IF(SUMPRODUCT(({{cells}}="?")*1)>0,"open",{formula})'


def _write_results(sheet: Any, looks: dict[str, Any], table: MatrixTable) -> None:
    from xlsxwriter.utility import xl_range, xl_rowcol_to_cell

    width, last = len(_columns(table)), HEADER + ROWS
    weights = xl_range(HEADER + 1, WEIGHT, last, WEIGHT).replace("B", "$B")
    first_line = HEADER - 4
    for line, result in enumerate(_results(table), start=first_line):
        sheet.write_string(line, 0, result.name, looks["bold"])
        # a Pugh rank follows the plain sum two lines above, a Kesselring rank the weighted one
        ranked = first_line if table.method is Method.PUGH else line - 1
        for place, value in enumerate(result.values):
            column = FIRST + place
            formula = result.formula.format(
                cells=xl_range(HEADER + 1, column, last, column), weights=weights,
                above=f"$C{ranked + 1}:${xl_rowcol_to_cell(ranked, FIRST + width - 1)}",
                one=xl_rowcol_to_cell(ranked, column),
            )  # fmt: skip
            sheet.write_formula(line, column, f"={formula}", looks[result.look], value)
    sheet.write_string(HEADER - 1, 0, "Total", looks["bold"])
    sheet.write_formula(HEADER - 1, WEIGHT, f"=SUM({weights})", looks["percent"], sum(table.weights))


def _add_checks(sheet: Any, table: MatrixTable) -> None:
    last = HEADER + ROWS
    sheet.data_validation(HEADER + 1, WEIGHT, last, WEIGHT, {
        "validate": "decimal", "criteria": "between", "minimum": 0, "maximum": 1, "error_title": "Weight",
        "error_message": "A weight is 0 to 100 %.",
    })  # fmt: skip
    first = FIRST + (1 if table.baseline else 0)
    is_pugh = table.method is Method.PUGH
    choices = ["++", "+", "S", "-", "--", "?"] if is_pugh else [*(str(one) for one in range(int(TOP) + 1)), "?"]
    sheet.data_validation(HEADER + 1, first, last, FIRST + len(_columns(table)) - 1, {
        "validate": "list", "source": choices, "error_title": table.name,
        "error_message": f"Choose one of {' '.join(choices)}.",
    })  # fmt: skip
    if table.baseline:
        sheet.data_validation(HEADER + 1, FIRST, last, FIRST, {
            "validate": "list", "source": ["S"], "error_title": "Datum",
            "error_message": "The datum is S: it is compared with itself.",
        })  # fmt: skip
