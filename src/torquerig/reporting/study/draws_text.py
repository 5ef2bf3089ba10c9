"""The distribution and the ranking of many draws as text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.plain_table import grid, wrapped
from torquerig.study.monte_carlo.distribution import distribution, share_uncertainty
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, error_column

if TYPE_CHECKING:
    from torquerig.study.monte_carlo.lost_draws import LostDraws
    from torquerig.study.monte_carlo.ranking import Ranking

Floats = NDArray[np.float64]
FEWEST = 10  # draws; fewer have no 95 % interval of their median
CLEAR = 0.9  # [1] share of the draws from which on a drive is called the best one


def answer_text(ranking: Ranking) -> str:
    """Return what the draws say of the choice, in a few sentences."""
    draws = len(ranking.totals)
    if not ranking.combinations:
        return f"No drive meets the requirements: {_listed(ranking.eliminated)}."
    shares = ranking.drive_shares()
    first, share = next(iter(shares.items()))
    within = f"{share:.0%} of {draws} draws ({_sure(share, draws)})"
    if share >= CLEAR:
        return f"{first} is the best drive: it is first in {within}. {_filters(ranking, first)}"
    others = [f"{name} ({part:.0%})" for name, part in list(shares.items())[1:4] if part >= 0.005]
    named = f"; then come {', '.join(others)}" if others else ""
    return f"No drive is clearly best: what the data sheets leave open decides. {first} is first in {within}{named}."


def _sure(share: float, draws: int) -> str:
    """Return how sure a share is by the number of draws."""
    reach = share_uncertainty(share, draws)
    if share == 1.0:  # Wilson's interval is one-sided there
        return f"at least {1 - 2 * reach:.0%} of all"
    return f"± {reach:.1%}"


def _filters(ranking: Ranking, drive: str) -> str:
    """Return with which filter a drive is best; several where the draws do not part them."""
    shares = {pair[1]: share for pair, share in ranking.shares().items() if pair[0] == drive and share > 0}
    first, share = next(iter(shares.items()))
    if share >= CLEAR * sum(shares.values()):
        return f"Its best filter is {first}."
    return f"Its best filter is open: {', '.join(f'{name} ({part:.0%})' for name, part in shares.items())}."


def ranked_draws_text(drawn: DrawnStudy, ranking: Ranking, tables: Mapping[str, Floats]) -> str:
    """Return the combinations by the share of draws in which they are best, with their reading errors."""
    unit, drives = drawn.study.effort_unit.replace("*", " "), list(drawn.drives)
    rows = [["combination", "best %", f"reading error {unit}: median", "5 %", "95 %", "median known to %"]]
    for (drive, filtering), share in ranking.shares().items():
        found = distribution(tables[error_column(filtering)][drives.index(drive)])
        if found is None:
            rows.append([f"{drive} | {filtering}", f"{100 * share:.1f}", "-", "-", "-", "-"])
            continue
        rows.append(
            [
                f"{drive} | {filtering}", f"{100 * share:.1f}", f"{found.median:.4f}", f"{found.low:.4f}",
                f"{found.high:.4f}", "-" if found.draws < FEWEST else f"{100 * found.uncertainty:.1f}",
            ]
        )  # fmt: skip
    return grid(rows)


def lost_draws_text(lost: Mapping[str, LostDraws]) -> str:
    """Return the draws at which drives have no figures, with the reasons; empty for none."""
    return "\n".join(wrapped(one.sentence(drive)) for drive, one in lost.items())


def left_out_text(drawn: DrawnStudy, ranking: Ranking) -> str:
    """Return the drives that are not ranked, with the reason; empty for none."""
    parts = []
    if drawn.left_out:
        parts.append(f"Not simulated: {_listed(drawn.left_out)}.")
    if ranking.eliminated:
        parts.append(f"Eliminated by a requirement: {_listed(ranking.eliminated)}.")
    return "\n".join(wrapped(part) for part in parts)


def convergence_text(ranking: Ranking) -> str:
    """Return how the share of the first drive settles with the number of draws: after a quarter, a half, and all."""
    draws = len(ranking.totals)
    shares = ranking.drive_shares()
    if draws < 4 or not shares:
        return ""
    first = next(iter(shares))
    is_first = np.array([ranking.combinations[at][0] == first for at in ranking.best])
    steps = [f"{is_first[:count].mean():.1%} after {count}" for count in (draws // 4, draws // 2, draws)]
    return f"Share of draws in which {first} is best: {', '.join(steps)}."


def _listed(reasons: Mapping[str, str]) -> str:
    return "; ".join(f"{name} ({why})" for name, why in reasons.items())
