"""The result of ``matrix`` for tables of marks or points: ranks, and how the sheet was read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from torquerig.api.result import Result, records
from torquerig.decide.lints.audit import audit
from torquerig.decide.lints.finding import Finding
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, TableSet
from torquerig.decide.matrix_io.recompute import recomputed_kesselring, recomputed_pugh, weighted_nets
from torquerig.decide.ranks import competition_ranks

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True, kw_only=True)
class TablesResult(Result):
    """Pugh and Kesselring tables recalculated from their cells.

    Parameters
    ----------
    tables : TableSet
        As they are in the file.
    understood : tuple of str
        How a sheet without fixed form was read; sentences that start with ``difference`` name results in the sheet that
        its cells do not give. Empty for published tables in YAML.
    """

    tables: TableSet
    understood: tuple[str, ...] = ()

    @property
    def ranking(self) -> pd.DataFrame:
        """One row per table and alternative, the best first in each table.

        ``total`` is the plain sum of the marks (Pugh, where ``?`` is left out) or the weighted sum of the points
        (Kesselring); ``weighted`` is the weighted sum of either, NaN for a Pugh table without weights;
        ``share_of_ideal`` is T/T_max, NaN where no points scale is known. ``rank`` follows ``total``; a tie shares its
        rank.
        """
        import pandas as pd

        rows = [row for table in self.tables.tables for row in _rows(table)]
        columns = ["table", "method", "rank", "alternative", "total", "total_low", "total_high", "weighted",
                   "share_of_ideal"]  # fmt: skip
        return pd.DataFrame(rows, columns=columns)

    @property
    def differences(self) -> tuple[str, ...]:
        """The results written in the sheet that do not follow from its cells."""
        return tuple(one for one in self.understood if one.startswith("difference"))

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What the checks of the tables found."""
        return audit(self.tables)

    def summary(self) -> str:
        """Return the first of each table, and how many written results differ."""
        said = []
        for table in self.tables.tables:
            rows = _rows(table)
            first = [row["alternative"] for row in rows if row["rank"] == 1]
            if rows:
                worse = table.method is Method.PUGH and rows[0]["total_high"] < 0
                datum = f", but worse than the baseline {table.baseline}" if worse else ""
                said.append(f"{table.name}: {' and '.join(first)} ranked first by {table.method.value}{datum}")
        differing = [f"{len(self.differences)} written results differ from the cells"] if self.differences else []
        return "; ".join([*said, *differing]) or "no table with a ranking"

    def to_frame(self) -> pd.DataFrame:
        """Return the ranking."""
        return self.ranking

    def as_dict(self) -> dict[str, Any]:
        """Return summary, ranking and how the sheet was read as plain values."""
        return {"summary": self.summary(), "ranking": records(self.ranking), "understood": list(self.understood)}

    def plot(self) -> Figure:
        """Return the totals of each table as bars."""
        from torquerig.reporting.figures.totals_figure import totals_figure

        named = [(table.name, _rows(table)) for table in self.tables.tables]
        return totals_figure({name: {row["alternative"]: row["total"] for row in rows} for name, rows in named if rows})


def _rows(table: MatrixTable) -> list[dict[str, Any]]:
    if table.method is Method.ELIMINATION:
        return []
    if table.method is Method.PUGH:
        rated = recomputed_pugh(table)
        names = table.alternatives
        totals, lows, highs = (one[1:].astype(float) for one in (rated.net_certain, rated.net_low, rated.net_high))
        weighted = weighted_nets(table)[1].tolist() if table.has_weights else [float("nan")] * len(names)
        shares = [float("nan")] * len(names)
    else:
        points = recomputed_kesselring(table)
        names, totals, lows, highs = points.alternatives, points.total, points.total_low, points.total_high
        weighted = points.total.tolist()
        shares = points.share.tolist() if table.profile.stated else [float("nan")] * len(names)
    rows = [
        {
            "table": table.name, "method": table.method.value, "rank": int(rank), "alternative": name,
            "total": float(total), "total_low": float(low), "total_high": float(high), "weighted": float(heavy),
            "share_of_ideal": float(share),
        }
        for name, rank, total, low, high, heavy, share in zip(
            names, competition_ranks(totals).tolist(), totals, lows, highs, weighted, shares, strict=True
        )
    ]  # fmt: skip
    return sorted(rows, key=lambda row: (row["rank"], row["alternative"]))
