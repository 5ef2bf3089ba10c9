"""A study's ranking and shares as plain text for a terminal, at most 110 wide."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from torquerig.plain_table import cut, grid, wrapped
from torquerig.reporting.figures.shades import SHARES
from torquerig.reporting.layout import figure_text, plain
from torquerig.reporting.study.answers import narrow_loops
from torquerig.reporting.study.tables import decision_words, effort_text
from torquerig.study.load_randomness import load_randomness
from torquerig.study.sweep import least_error

if TYPE_CHECKING:
    from torquerig.study.results import StudyRuns
    from torquerig.study.scoring import Decided
    from torquerig.study.sweep import SweptPoint

WIDTH = 110


def ranked_text(decided: Decided, *, most: int = 10) -> str:
    """Return the ``most`` best combinations as a table, and the present one where it is not among them."""
    names = decided.ranked()
    shown = names[:most] if decided.baseline in names[:most] else (*names[:most], decided.baseline)
    said, overall = decision_words(decided), decided.overall
    rows = []
    for name in shown:
        made, place = decided.alternatives[name], overall.alternatives.index(name)
        mark = "*" if name == decided.baseline else ""
        rows.append([
            f"{overall.ranks[place]}{mark}", made.drive.candidate.name, made.chain,
            figure_text(made.drive.chains[made.chain].truth_error), plain(made.drive.disturbance.value),
            f"{overall.share[place]:.3f}", figure_text(made.drive.margins["price"]), said[made.drive.candidate.name],
        ])  # fmt: skip
    head = [
        "rank",
        "drive",
        "filter",
        f"error [{effort_text(decided.alternatives[decided.baseline].drive)}]",
        "disturb",
        "T/Tmax",
        "EUR",
        "requirements",
    ]
    here = decided.alternatives[decided.baseline].drive.margins["new_parts"].value == 0
    note = "present drive" if here else "baseline: the present motor on this gearbox, without a filter"
    samples = max((made.drive.disturbance.source for made in decided.alternatives.values()), default="")
    drives = {made.drive.candidate.name: made.drive for made in decided.alternatives.values()}
    randomness = load_randomness(drives.values())
    error = [
        f"error: {samples}; in brackets their extremes" if samples else "",
        "" if randomness is None else randomness.sentence(),
    ]
    below = [wrapped(line) for line in error if line]
    return "\n".join([_fitted([head, *rows], left=(1, 2, 7)), f"* {note}", *below])


def sweep_text(swept: Sequence[SweptPoint], *, most: int = 12) -> str:
    """Return winner and reading error of the ``most`` best drives at each computed point of a sweep."""
    found = [{one.candidate.name: least_error(one) for one in point.runs.drives} for point in swept]
    known = {name for point in found for name, error in point.items() if error is not None}
    names = sorted(known, key=lambda name: min(point[name][1] for point in found if point.get(name)))  # type: ignore[index]
    unit = effort_text(swept[0].runs.drives[0])
    rows = [[f"error [{unit}], best filter", *(", ".join(one.values.values()) for one in swept)]]
    for name in names[:most]:
        errors = [point.get(name) for point in found]
        rows.append([name, *("-" if one is None else f"{one[1]:.4f}" for one in errors)])
    winners = "; ".join(f"{one.text}: {one.verdict.winner or 'none'}" for one in swept)
    return (
        f"Sweep of {', '.join(swept[0].values)}, {len(swept)} computed points, nothing interpolated:\n"
        f"{_fitted(rows, left=(0,))}\n{wrapped(f'First at each point: {winners}.')}"
    )


def shares_text(runs: StudyRuns) -> str:
    """Return rms [N m] and share of the fluctuation's power [%] of load, cogging, electrical and mechanical ripple."""
    rows = []
    for drive in runs.drives:
        if drive.shares is None:
            rows.append([drive.candidate.name, "-", *("-" for _ in SHARES)])
            continue
        percent = drive.shares.percent()
        cells = [f"{getattr(drive.shares, name):.4f} {percent[name]:5.1f} %" for name in SHARES]
        rows.append([drive.candidate.name, f"{drive.shares.mean:.3f}", *cells])
    table = _fitted([["drive", "mean", *SHARES], *rows], left=(0,))
    why = [f"{drive.candidate.name}: {drive.out_of_reach}" for drive in runs.drives if drive.out_of_reach]
    why += narrow_loops(runs)
    return "\n".join([table, *(cut(line, WIDTH) for line in why)])


def _fitted(rows: Sequence[Sequence[str]], *, left: tuple[int, ...]) -> str:
    """Return aligned columns, those of ``left`` to the left; the widest of these is cut where a row is too wide."""
    widths = [max(len(row[place]) for row in rows) for place in range(len(rows[0]))]
    while sum(widths) + 2 * (len(widths) - 1) > WIDTH:
        widths[max(left, key=lambda place: widths[place])] -= 1
    fitted = [[cut(cell, width) for cell, width in zip(row, widths, strict=True)] for row in rows]
    return grid(fitted, right=set(range(len(widths))) - set(left))
