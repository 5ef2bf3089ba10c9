"""Decision sheets in the many forms that people give them, each drawn with what it means."""

from dataclasses import dataclass

import numpy as np
import openpyxl

DATUM_NAMES = ("Belt (datum)", "Baseline", "reference", "Referenz", "Belt")
SPELLED = {
    2: ("++", "+ +", 2, "+2"), 1: ("+", 1, "+1", "\uff0b"), 0: ("S", "s", 0, "0", "="),
    -1: ("-", "\u2212", "\u2013", -1, "\u22121"), -2: ("--", "\u2212\u2212", "\u2013\u2013", -2),
}  # fmt: skip
CRITERIA = ("torque ripple [Nm]", "price [EUR]", "stiffness", "assembly effort", "mass [kg]", "noise [dB]", "service")
NAMES = ("Gear", "Direct", "Harmonic", "Planetary", "Worm")


@dataclass
class Drawn:
    """A sheet as rows of cells, and what it means."""

    rows: list
    method: str
    alternatives: list
    criteria: list
    entries: np.ndarray  # (criteria, alternatives), levels or points
    weights: np.ndarray | None
    differs: bool = False  # a total in the sheet is wrong

    @property
    def totals(self):
        """The plain sum of the marks, or the weighted sum of the points."""
        if self.method == "pugh":
            return dict(zip(self.alternatives, self.entries.sum(axis=0).tolist(), strict=True))
        weights = np.ones(len(self.criteria)) if self.weights is None else self.weights
        return dict(zip(self.alternatives, (weights @ self.entries).tolist(), strict=True))


def comma(value):
    """Return a number as text with a decimal comma."""
    return f"{value:g}".replace(".", ",")


def drawn_sheet(seed):
    """Return one sheet: method, spelling, weights, order, orientation, titles, blanks, totals by the random seed."""
    rng = np.random.default_rng(seed)
    method = str(rng.choice(["pugh", "kesselring"]))
    criteria = rng.permutation(CRITERIA)[: rng.integers(2, 7)].tolist()
    names = rng.permutation(NAMES)[: rng.integers(2, 5)].tolist()
    levels = rng.integers(-2, 3, (len(criteria), len(names)))
    points = rng.integers(0, 9, (len(criteria), len(names))) / 2
    entries = levels if method == "pugh" else points
    shares = rng.multinomial(20 - len(criteria), np.ones(len(criteria)) / len(criteria)) + 1
    how = str(rng.choice(["per cent", "fraction", "comma", "whole", "none"]))
    weights = {"whole": shares * 5.0, "none": None}.get(how, shares * 0.05)
    drawn = Drawn([], method, names, criteria, entries.astype(float), weights)
    drawn.rows = _laid_out(rng, drawn, how)
    return drawn


def _laid_out(rng, drawn, how):
    datum = str(rng.choice(DATUM_NAMES)) if drawn.method == "pugh" else ""
    heads = [*drawn.alternatives]
    place = int(rng.integers(0, len(heads) + 1))
    if datum:
        heads.insert(place, datum)
    weight_head = str(
        rng.choice(["Weight", "Gewichtung", "weighting", "Gewicht [%]" if how == "per cent" else "Weight"])
    )
    corner = str(rng.choice(["", "Criterion", "Kriterium", "Criteria"]))
    body = [[corner, *([weight_head] if how != "none" else []), *heads]]
    for row, name in enumerate(drawn.criteria):
        cells = [_cell(rng, drawn.method, value) for value in drawn.entries[row].tolist()]
        if datum:
            cells.insert(place, str(rng.choice(["S", "0", "s"])))
        body.append([name, *([_weight(how, drawn.weights[row])] if how != "none" else []), *cells])
    body += _totals(rng, drawn, heads, datum, how)
    width = len(body[0])
    if rng.random() < 0.4:
        body = [[*row, *[None] * (width - len(row))] for row in body]
        body = [list(column) for column in zip(*body, strict=True)]
        if body[0][0] in ("Criterion", "Kriterium", "Criteria"):
            body[0][0] = None  # in the corner the word would name the alternatives
    for at in sorted(rng.integers(1, len(body) + 1, int(rng.integers(0, 3))).tolist(), reverse=True):
        body.insert(at, [])
    titles = [["Selection of a drive, 3rd meeting"], [], [None, "rated by the team"]][: rng.integers(0, 4)]
    shift = int(rng.integers(0, 3))
    end = [[], ["scale 0 to 4"]] if drawn.method == "kesselring" else [[], ["+ better, - worse than the datum"]]
    return [[*[None] * shift, *row] for row in (*titles, *body, *end)]


def _totals(rng, drawn, heads, datum, how):
    """Return a row of sums, and perhaps ranks; sometimes one sum is wrong."""
    if rng.random() < 0.25:
        return []
    sums = drawn.totals
    wrong = rng.random() < 0.3
    drawn.differs = bool(wrong)
    values = [sums.get(name, 0.0) for name in heads]
    if wrong:
        values[heads.index(drawn.alternatives[0])] += 7.25
    name = str(rng.choice(["Sum", "Total", "Summe", "total score"]))
    total = [_weight(how, sum(drawn.weights))] if how != "none" else []
    as_text = rng.random() < 0.5
    rows = [[name, *total, *(comma(one) if as_text else one for one in values)]]
    if rng.random() < 0.5 and not wrong:
        ranks = [1 + sum(other > sums[one] + 1e-9 for other in sums.values()) for one in drawn.alternatives]
        given = dict(zip(drawn.alternatives, ranks, strict=True))
        rows.append([str(rng.choice(["Rank", "Rang"])), *[None] * len(total), *(given.get(one) for one in heads)])
    return rows


def _cell(rng, method, value):
    if method == "pugh":
        choices = SPELLED[int(value)]
        return choices[int(rng.integers(0, len(choices)))]
    return comma(value) if rng.random() < 0.5 else value


def _weight(how, value):
    if how == "per cent":
        return f"{100 * value:g} %"
    return comma(value) if how == "comma" else float(value)


def write_sheet(path, rows, *, name="Tabelle1", merged=()):
    """Write rows of cells as a workbook; numbers stay numbers, text stays text."""
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = name
    for number, row in enumerate(rows, start=1):
        for column, value in enumerate(row, start=1):
            if value is not None:
                cell = sheet.cell(number, column)
                cell.value = value
                if isinstance(value, str):
                    cell.data_type = "s"  # never a formula, also where it starts with =
    for cells in merged:
        sheet.merge_cells(cells)
    book.save(path)
    return path
