"""Draws at which a drive cannot run: how many, and why."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.study.loop_figures import UNSTABLE

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, kw_only=True)
class LostDraws:
    """The draws of one drive that have no figures.

    Parameters
    ----------
    draws : int
        Of the drive.
    unstable : int
        At which its speed loop is unstable.
    out_of_reach : int
        At which it cannot reach the speed, torque or voltage of the run.
    failed : int
        That failed with an error.
    """

    draws: int
    unstable: int
    out_of_reach: int
    failed: int

    def sentence(self, drive: str) -> str:
        """Return which share of the draws has no figures, with the reasons."""
        parts = [
            f"an unstable speed loop at {self._share(self.unstable)}",
            f"too little speed, torque or voltage at {self._share(self.out_of_reach)}",
            f"an error at {self._share(self.failed)}",
        ]
        found = [
            text for text, count in zip(parts, (self.unstable, self.out_of_reach, self.failed), strict=True) if count
        ]
        remedy = " Lower study: speed_loop: crossover." if self.unstable else ""
        return f"{drive} has {', '.join(found)} of its {self.draws} draws; these have no reading error.{remedy}"

    def _share(self, count: int) -> str:
        return f"{count} ({count / self.draws:.1%})"


def lost_draws(rows: pd.DataFrame) -> dict[str, LostDraws]:
    """Return the draws without figures of each drive that has some, from the stored rows."""
    found = {}
    for drive, of in rows.groupby("drive", sort=False):
        reasons = of["out_of_reach"].fillna("")
        unstable = int(reasons.str.startswith(UNSTABLE).sum())
        beyond = int((reasons != "").sum()) - unstable
        failed = int((of["state"] != "done").sum())
        if unstable or beyond or failed:
            found[str(drive)] = LostDraws(draws=len(of), unstable=unstable, out_of_reach=beyond, failed=failed)
    return found
