"""``matrix``: elimination, Pugh and Kesselring of a decision matrix."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.api.matrix_tables import TablesResult
from torquerig.api.result import Result, records
from torquerig.api.values import folders
from torquerig.catalog.search import catalog_for
from torquerig.decide.eliminate import Decision
from torquerig.decide.matrix_analysis import MatrixAnalysis, analyse_matrix
from torquerig.decide.matrix_io.matrix_table import TableSet

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True, kw_only=True)
class MatrixResult(Result):
    """The three methods on one matrix, and how certain the winner is.

    Parameters
    ----------
    analysis : MatrixAnalysis
        Selection chart, Pugh and Kesselring matrices, robustness, open facts, lints.
    """

    analysis: MatrixAnalysis

    @property
    def verdict(self) -> str:
        """The certainty of the winner: robust, fragile, tie or open."""
        return str(self.analysis.verdict.certainty)

    @property
    def ranking(self) -> pd.DataFrame:
        """One row per alternative that no requirement eliminates, the best first: points and share of the ideal."""
        import pandas as pd

        found = self.analysis.overall
        best, worst = found.rank_range
        rows = [
            {
                "rank": int(found.ranks[row]), "alternative": name, "total": float(found.total[row]),
                "total_low": float(found.total_low[row]), "total_high": float(found.total_high[row]),
                "share_of_ideal": float(found.share[row]), "best_rank": int(best[row]), "worst_rank": int(worst[row]),
            }
            for row, name in enumerate(found.alternatives)
        ]  # fmt: skip
        return pd.DataFrame(rows).sort_values(["rank", "alternative"], ignore_index=True)

    @property
    def pugh(self) -> pd.DataFrame:
        """One row per alternative: its signs against the baseline, criterion by criterion."""
        import pandas as pd

        found = self.analysis.pugh
        rows = {name: [str(sign) for sign in found.signs(name)] for name in found.alternatives}
        return pd.DataFrame.from_dict(rows, orient="index", columns=list(found.criteria)).rename_axis("alternative")

    @property
    def elimination(self) -> pd.DataFrame:
        """One row per alternative: whether the requirements keep it, eliminate it, or leave it open."""
        import pandas as pd

        chart = self.analysis.chart
        rows = [(name, str(decision)) for decision in Decision for name in chart.with_decision(decision)]
        return pd.DataFrame(rows, columns=["alternative", "decision"])

    def summary(self) -> str:
        """Return the verdict in one sentence."""
        return self.analysis.verdict.sentence()

    def to_frame(self) -> pd.DataFrame:
        """Return the ranking."""
        return self.ranking

    def as_dict(self) -> dict[str, Any]:
        """Return verdict, summary and ranking as plain values."""
        return {"verdict": self.verdict, "summary": self.summary(), "ranking": records(self.ranking)}

    def plot(self) -> Figure:
        """Return the value profile: points by criterion, weak spots marked."""
        from torquerig.reporting.figures.value_profile import value_profile

        return value_profile(self.analysis.overall)

    def write(self, path: str | Path) -> Path:
        """Write the matrix as .html, .md, .xlsx or .yaml, by the ending, and return the path."""
        from torquerig.reporting.matrix.files import write_matrix

        write_matrix(self.analysis, Path(path))
        return Path(path)


def matrix(path: str | Path, *, catalogs: Sequence[str | Path] = ()) -> MatrixResult | TablesResult:
    """Return elimination, Pugh and Kesselring of a decision matrix, and how certain the winner is.

    Parameters
    ----------
    path : str or Path
        A matrix as YAML (see ``scenarios/matrix_example.yaml``) or as a filled-in Excel sheet; a shipped one by its
        name. An Excel or CSV sheet of any form with Pugh marks or Kesselring points is read by its shape.
    catalogs : sequence of path
        Further catalog folders, for matrices of catalog motors.

    Returns
    -------
    MatrixResult or TablesResult
        ``.ranking``, ``.pugh``, ``.elimination`` are tables; ``.write(path)`` makes a page or a workbook. A sheet of
        marks or points, or a file of published tables, gives a TablesResult with ``.ranking``, ``.understood`` (how it
        was read), ``.differences`` (written results that its cells do not give) and ``.findings``.

    Raises
    ------
    InputError
        With file, line or cell, and remedy.

    Examples
    --------
    >>> import torquerig as tr
    >>> result = tr.matrix("matrix_example.yaml")
    >>> result.ranking.columns[:2].tolist()
    ['rank', 'alternative']
    """
    from torquerig.api.scenarios import scenario_file
    from torquerig.decide.matrix_io.matrix_file import matrix_from
    from torquerig.decide.matrix_io.opened import open_matrix

    opened = open_matrix(scenario_file(path))
    if opened.tables is not None or opened.document is None:
        return TablesResult(tables=opened.tables or TableSet(tables=()), understood=opened.understood)
    document = opened.document
    wants_motors = isinstance(document.data, dict) and document.data.get("motors")
    catalog = catalog_for(document.path, folders(catalogs)) if wants_motors else None
    return MatrixResult(analysis=analyse_matrix(matrix_from(document, catalog=catalog)))
