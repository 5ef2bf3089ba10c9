"""Tables of a study: ranking, reading errors, shares, filters, drives that are out of reach."""

from __future__ import annotations

from collections.abc import Sequence
from math import log
from typing import TYPE_CHECKING

from torquerig.decide.ranks import shown_rank
from torquerig.reporting.figures.shades import GOOD_IS_HIGH, GOOD_IS_LOW, SHARES, shade
from torquerig.reporting.layout import Cell, Table, figure_cell, listed, number, plain, span, words

if TYPE_CHECKING:
    from torquerig.study.results import DriveResult, StudyRuns
    from torquerig.study.scoring import Alternative, Decided
    from torquerig.study.what_if import Change

Ranks = dict[str, str]


def effort_text(drive: DriveResult) -> str:
    """Return the unit of what is measured, as a text has it: N m, or N where it moves in a line."""
    return drive.disturbance.unit.replace("*", " ")


def rank_texts(decided: Decided) -> Ranks:
    """Return the rank of each alternative by the overall T, with its range over the unknown values."""
    best, worst = (ends.tolist() for ends in decided.overall.rank_range)
    ranks = decided.overall.ranks.tolist()
    return {
        name: str(rank) if low == high else f"{rank} ({shown_rank(low, high)})"
        for name, rank, low, high in zip(decided.overall.alternatives, ranks, best, worst, strict=True)
    }


def decision_words(decided: Decided) -> dict[str, str]:
    """Return the decision of the elimination for each drive."""
    return {row.alternative: str(row.decision) for row in decided.chart.rows}


def best_per_drive(decided: Decided) -> tuple[str, ...]:
    """Return each drive's best combination in the order of the ranking, and the baseline where it is not among them."""
    first: dict[str, str] = {}
    for name in decided.ranked():
        first.setdefault(decided.alternatives[name].drive.candidate.name, name)
    kept = tuple(first.values())
    return kept if decided.baseline in kept else (*kept, decided.baseline)


def best_new_motor(decided: Decided) -> Alternative | None:
    """Return the best combination whose motor is not the present one; None where there is no other motor."""
    present = decided.alternatives[decided.baseline].drive.candidate.motor
    ranked = (decided.alternatives[name] for name in decided.ranked())
    return next((made for made in ranked if made.drive.candidate.motor != present), None)


def ranking_table(decided: Decided, *, winner: str, most: int) -> Table:
    """Return the best ``most`` combinations, and the present one where it is not among them."""
    names = decided.ranked()
    shown = names[:most] if decided.baseline in names[:most] else (*names[:most], decided.baseline)
    ranks, said, overall = rank_texts(decided), decision_words(decided), decided.overall
    rows = []
    for name in shown:
        made, place = decided.alternatives[name], overall.alternatives.index(name)
        ends = overall.total_low[place] / overall.ideal, overall.total_high[place] / overall.ideal
        share = float(overall.share[place])
        rows.append((
            Cell(text=ranks[name], word="name"), Cell(text=made.drive.candidate.name, word="name"),
            Cell(text=made.chain, word="name"),
            figure_cell(made.drive.chains[made.chain].truth_error), figure_cell(made.drive.disturbance),
            number(f"{share:.3f}", style=shade(share, 0.4, 1.0, scale=GOOD_IS_HIGH)),
            number(span(*ends, digits=2)), figure_cell(made.drive.margins["price"]),
            Cell(text=said[made.drive.candidate.name]),
        ))  # fmt: skip
    unit = effort_text(decided.alternatives[decided.baseline].drive)
    highlighted = frozenset(place for place, name in enumerate(shown) if name in (winner, decided.baseline))
    return Table(
        caption=f"The best {min(most, len(names))} of {len(names)} combinations, by T/T_max over all criteria; bold: "
        "the chosen and the present one",
        head=("rank (range)", "drive", "filter", f"reading error [{unit}]", f"disturbance [{unit}]", "T/T_max", "range",
              "price [EUR]", "requirements"),
        rows=tuple(rows), emphasised=highlighted,
        note="A simulated figure is the median of the Monte Carlo samples of the catalog, the range in brackets their "
        "extremes; other ranges are the catalog's intervals. The randomness of the load is apart: see 'Limits of "
        "validity'.",
    )  # fmt: skip


def error_table(runs: StudyRuns, *, present: str) -> Table:
    """Return the reading error of each drive (rows) with each filter (columns), coloured from best to worst."""
    names = runs.study.settings.filters.names
    found = [
        result.truth_error.value
        for drive in runs.drives
        for result in drive.chains.values()
        if result.truth_error.value
    ]
    low, high = min(found, default=0.0), max(found, default=1.0)
    rows = tuple(_error_row(drive, names, low=low, high=high) for drive in runs.drives)
    highlighted = frozenset(row for row, drive in enumerate(runs.drives) if drive.candidate.name == present)
    unit = effort_text(runs.drives[0])
    return Table(
        caption=f"Reading error [{unit}], rms of filtered reading minus true load: simulated; blue is small",
        head=("drive", *names), rows=rows, emphasised=highlighted,
        note="Median of the Monte Carlo samples. The tooltip of a number has their extremes, and the standard error by "
        "the random load; combinations.csv has both.",
    )  # fmt: skip


def _error_row(drive: DriveResult, names: Sequence[str], *, low: float, high: float) -> tuple[Cell, ...]:
    if not drive.chains:
        blank = (Cell(text="", style="background:#eee") for _ in names[1:])
        return (*words(drive.candidate.name), Cell(text="out of reach", title=drive.out_of_reach), *blank)
    cells = []
    for name in names:
        error = drive.chains[name].truth_error
        if not error.value:
            cells.append(figure_cell(error))
            continue
        colour = shade(log(error.value), log(low), log(high), scale=GOOD_IS_LOW)
        unit = effort_text(drive)
        interval = "" if error.low is None or error.high is None else f"{span(error.low, error.high)} {unit}"
        random = drive.chains[name].random_error
        interval += "" if random is None else f"; random load: ±{random:.2g} {unit}"
        cells.append(number(f"{error.value:.{3 if error.value < 10 else 1}f}", style=colour, title=interval))
    return (*words(drive.candidate.name), *cells)


def shares_table(motor: str, drives: Sequence[DriveResult]) -> Table:
    """Return the shares of the reading of one motor, a row per ratio."""
    rows = []
    for drive in drives:
        if drive.shares is None:
            blank = (Cell(text="-", word="number", title=drive.out_of_reach) for _ in range(5 + 2 * len(SHARES)))
            rows.append((*words(drive.candidate.ratio_text), *blank))
            continue
        percent = drive.shares.percent()
        cells = [number(plain(drive.shares.mean, 4))]
        for name in SHARES:
            value = float(getattr(drive.shares, name))
            cells += [number(f"{value:.4f}"), number(f"{percent[name]:.1f}")]
        rows.append((*words(drive.candidate.ratio_text), *cells, *_load_path_cells(drive)))
    unit = effort_text(drives[0])
    head = [text for name in SHARES for text in (f"{name} [{unit}]", "[%]")]
    return Table(
        caption=motor,
        head=(
            "ratio",
            f"mean [{unit}]",
            *head,
            f"true load [{unit}]",
            "J1/(J1+J2)",
            "largest gain",
            "at [Hz]",
        ),
        rows=tuple(rows),
    )


LOAD_NOTE = (
    "The load is the same in every row (true load, rms where it acts). The sensor reads another rms of it: of a load "
    "that changes faster than the speed loop only J1/(J1+J2) reaches it, J1 the inertia before the sensor, which grows "
    "with the ratio squared, J2 that behind it; and the largest gain, at a torsional mode, amplifies it."
)


def _load_path_cells(drive: DriveResult) -> tuple[Cell, ...]:
    """Return the true load, and what the shafts make of it on its way to the sensor."""
    path, load = drive.load_path, None if drive.shares is None else drive.shares.true_load
    shown = [number("-" if load is None else f"{load:.4f}")]
    if path is None:
        return (*shown, *(number("-") for _ in range(3)))
    return (*shown, number(f"{path.inertia_share:.2f}"), number(f"{path.largest:.3g}"), number(f"{path.at:.3g}"))


def out_of_reach_table(runs: StudyRuns) -> Table:
    """Return the drives that were not simulated, with the reason."""
    rows = tuple(words(drive.candidate.name, drive.out_of_reach) for drive in runs.drives if drive.out_of_reach)
    return Table(caption="Not simulated", head=("drive", "reason"), rows=rows)


def effects_table(drive: DriveResult) -> Table:
    """Return the effect of each filter on the reading of one drive."""
    rows = []
    for name, result in drive.chains.items():
        effect = result.effect
        rows.append((
            *words(name), number(f"{effect.std_reduction_percent:.1f}"),
            number(f"{effect.variance_reduction_percent:.1f}"), number(f"{effect.mean_change_percent:.2g}"),
            number("?" if effect.energy_change_percent is None else f"{effect.energy_change_percent:.2g}"),
            figure_cell(result.truth_error), *words(listed(result.left_out, nothing="-")),
        ))  # fmt: skip
    return Table(
        caption=f"Effect of each filter on the reading of {drive.candidate.name}",
        head=("filter", "std reduction [%]", "variance reduction [%]", "mean change [%]", "energy change [%]",
              f"reading error [{effort_text(drive)}]", "lines not removed"),
        rows=tuple(rows),
        note="A lower standard deviation does not prove a better reading: a filter that removes load lowers it too. "
        "The reading error is the rms difference between the filtered reading and the true load.",
    )  # fmt: skip


def changes_table(changes: Sequence[Change]) -> Table:
    """Return the differences between the edited and the original study."""
    rows = tuple(
        (*words(f"{one.before} -> {one.after}" if one.before != one.after else one.after, one.chain_before),
         number(plain(one.error_before)), *words(one.chain_after), number(plain(one.error_after)),
         number(plain(one.disturbance_before)), number(plain(one.disturbance_after)))
        for one in changes
    )  # fmt: skip
    return Table(
        caption="Edited and original study: smallest reading error and disturbance of each drive",
        head=("drive", "best filter before", "error before", "best filter now", "error now", "disturbance before",
              "disturbance now"),
        rows=rows,
    )  # fmt: skip
