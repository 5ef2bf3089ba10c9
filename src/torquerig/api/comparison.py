"""``compare``: every motor, gearbox and filter of a study, simulated and ranked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.api.result import Result
from torquerig.api.scenarios import scenario_file
from torquerig.api.values import folders, settings_of
from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.results import StudyRuns
from torquerig.study.run_study import Progress, run_study
from torquerig.study.scoring import Decided, decide
from torquerig.study.verdict import Verdict, verdict

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


@dataclass(frozen=True, kw_only=True)
class Comparison(Result):
    """The combinations of a study, what was simulated of each, and how they rank.

    Parameters
    ----------
    runs : StudyRuns
        Figures of every drive, and of every filter on it.
    decided : Decided
        Elimination, Pugh and Kesselring matrices.
    verdict : Verdict
        The winner, and how sure that is.
    """

    runs: StudyRuns
    decided: Decided
    verdict: Verdict

    @property
    def ranking(self) -> pd.DataFrame:
        """One row per motor x gearbox x filter, the best first; those that a requirement eliminates come last."""
        from torquerig.reporting.study.csv_tables import combinations_csv, table_of

        return table_of(combinations_csv(self.runs, self.decided))

    @property
    def shares(self) -> pd.DataFrame:
        """One row per drive: rms [N m] and share of power [%] of load, cogging, electrical and mechanical ripple."""
        from torquerig.reporting.study.csv_tables import shares_csv, table_of

        return table_of(shares_csv(self.runs))

    def summary(self) -> str:
        """Return the verdict in one sentence."""
        return self.verdict.sentence

    def to_frame(self) -> pd.DataFrame:
        """Return the ranking."""
        return self.ranking

    def plot(self) -> Figure:
        """Return the reading error of each drive with each filter."""
        from torquerig.reporting.figures.error_figure import error_figure

        return error_figure(self.runs.drives, present=self.decided.baseline.split(" | ", maxsplit=1)[0])

    def report(self, folder: str | Path) -> Path:
        """Write page, CSV tables and workbook into ``folder``, and return the page's path."""
        from torquerig.reporting.study.report import write_study_report

        return write_study_report(self.runs, self.decided, self.verdict, Path(folder))[0]


def compare(
    scenario: str | Path, *, changes: Mapping[str, Any] | None = None, catalogs: Sequence[str | Path] = (),
    workers: int | None = None, progress: Progress | None = None,
) -> Comparison:  # fmt: skip
    """Return every motor x gearbox x filter of a study, simulated, measured and ranked.

    Parameters
    ----------
    scenario : str or Path
        A scenario file with a ``study:`` section; a shipped one by its name.
    changes : mapping of str to value, optional
        Values to change without editing the file.
    catalogs : sequence of path
        Further catalog folders.
    workers : int, optional
        Runs at a time; one per core without it. The result does not depend on it.
    progress : callable, optional
        Called with (done, total, name) after each drive.

    Returns
    -------
    Comparison
        ``.ranking`` and ``.shares`` are tables; ``.report(folder)`` writes the page.

    Raises
    ------
    InputError
        With file, line, key and remedy, before anything is simulated.

    Examples
    --------
    >>> import torquerig as tr
    >>> small = {"study.motors": ["bldc-12n14p"], "study.gearboxes": ["reference-5-1"], "study.draws": 0}
    >>> result = tr.compare("wear_rig.yaml", changes=small)
    >>> result.ranking["filter"].nunique() > 3
    True
    """
    file = scenario_file(scenario)
    study = open_study(overridden(read_document(file), settings_of(changes)), catalog_for(file, folders(catalogs)))
    runs = run_study(study, progress=progress, workers=workers)
    decided = decide(runs)
    return Comparison(runs=runs, decided=decided, verdict=verdict(decided))
