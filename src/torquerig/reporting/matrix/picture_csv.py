"""The numbers of a matrix's pictures as CSV text, for the page to save."""

from __future__ import annotations

import csv
from collections.abc import Iterable
from io import StringIO

from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.strength import Strength
from torquerig.harmless import csv_cell


def points_csv(result: KesselringResult) -> str:
    """Return the points of each alternative under each criterion, with their range and the normalised weight."""
    head = ("alternative", "criterion", "weight", "points", "points low", "points high")
    rows = [
        (name, criterion, *(f"{one:.10g}" for one in (result.normalised[column], result.middle[row, column],
                                                      result.low[row, column], result.high[row, column])))
        for row, name in enumerate(result.alternatives)
        for column, criterion in enumerate(result.criteria)
    ]  # fmt: skip
    return _text(head, rows)


def strength_csv(found: Strength) -> str:
    """Return technical and economic rating of each alternative with their ranges."""
    head = ("alternative", "technical", "technical low", "technical high", "economic", "economic low", "economic high")
    rows = [
        (name, *(f"{one[row]:.10g}" for rating in (found.technical, found.economic)
                 for one in (rating.value, rating.low, rating.high)))
        for row, name in enumerate(found.alternatives)
    ]  # fmt: skip
    return _text(head, rows)


def _text(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow(head)
    writer.writerows([csv_cell(text) for text in row] for row in rows)
    return buffer.getvalue()
