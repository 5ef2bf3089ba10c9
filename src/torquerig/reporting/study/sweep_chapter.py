"""The chapter of a sweep: a slider per quantity, and for each computed point answer, figures, reading and ranking."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from torquerig.reporting.figures.page_picture import Picture, plot_name
from torquerig.reporting.layout import Table, number, plain, words
from torquerig.reporting.moving.matrix_model import study_model
from torquerig.reporting.moving.page_scripts import data_script
from torquerig.reporting.study import tables
from torquerig.reporting.study.csv_tables import csv_text
from torquerig.study.scoring import Decided, combinations
from torquerig.study.sweep import SweptPoint, least_error

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording
    from torquerig.reporting.study import pictures
    from torquerig.study.results import StudyRuns

MOST_SAMPLES = 600_000  # of the readings of all points together: 2 MB of the page
FIRST_VIEW = 0.3  # [s] of each reading
DRAWN = 8  # drives in the figure; the table has all
RANKED = 10  # combinations in the table of a point


def sweep_chapter(swept: Sequence[SweptPoint]) -> Mapping[str, Any] | None:
    """Return the content of the chapter; None without a sweep."""
    if not swept:
        return None
    axes = {key: list(dict.fromkeys(one.values[key] for one in swept)) for key in swept[0].values}
    return {
        "axes": tuple((key, values) for key, values in axes.items()),
        "table": _errors_table(swept), "picture": _picture(swept),
        "points": tuple(_point(number, one, axes, len(swept)) for number, one in enumerate(swept)),
        "count": len(swept),
    }  # fmt: skip


def sweep_csv(swept: Sequence[SweptPoint]) -> str:
    """Return a row per point, drive and filter with its reading error."""
    rows = []
    for point in swept:
        for drive in point.runs.drives:
            for name, result in drive.chains.items():
                error = result.truth_error
                rows.append([
                    *point.values.items(), ("drive", drive.candidate.name), ("filter", name),
                    (f"reading error [{error.unit}]", "?" if error.value is None else f"{error.value:.6g}"),
                ])  # fmt: skip
    return csv_text(rows)


def matrix_model_of(runs: StudyRuns, decided: Decided) -> dict[str, Any]:
    """Return the matrices of a study as the page computes them."""
    drive_of = {one.name: one.drive.candidate.name for one in combinations(runs)}
    return study_model(decided.requirements, decided.criteria, baseline=decided.baseline, drive_of=drive_of)


def _least_errors(swept: Sequence[SweptPoint]) -> dict[str, list[tuple[str, float] | None]]:
    """Return filter and least error of each drive at each point; drives from the least error at the first point up."""
    found: dict[str, list[tuple[str, float] | None]] = {}
    for place, point in enumerate(swept):
        for drive in point.runs.drives:
            row = found.setdefault(drive.candidate.name, [None] * len(swept))
            row[place] = least_error(drive)
    return dict(sorted(found.items(), key=lambda one: min((e[1] for e in one[1] if e), default=float("inf"))))


def _labels(swept: Sequence[SweptPoint]) -> list[str]:
    return [", ".join(one.values.values()) for one in swept]


def _errors_table(swept: Sequence[SweptPoint]) -> Table:
    rows = tuple(
        (*words(drive), *(
            number("-", title="not simulated here") if one is None else number(plain(one[1]), title=f"filter {one[0]}")
            for one in errors
        ))
        for drive, errors in _least_errors(swept).items()
    )  # fmt: skip
    return Table(
        caption=f"Reading error [{tables.effort_text(swept[0].runs.drives[0])}] of each drive with its best filter, by "
        f"{', '.join(swept[0].values)}",
        head=("drive", *_labels(swept)), rows=rows,
        note="Each column is computed: one Monte Carlo sample per drive, the same random load. The tooltip has the "
        "filter.",
    )  # fmt: skip


def _picture(swept: Sequence[SweptPoint]) -> Picture:
    from torquerig.reporting.figures.picture import picture
    from torquerig.reporting.figures.sweep_figure import sweep_figure

    errors = {
        drive: [None if one is None else one[1] for one in found] for drive, found in _least_errors(swept).items()
    }
    drawn = dict(list(errors.items())[:DRAWN])
    present = swept[0].decided.alternatives[swept[0].decided.baseline].drive.candidate.name
    drawn |= {present: errors[present]}
    unit = swept[0].runs.drives[0].disturbance.unit
    return picture(
        sweep_figure(_labels(swept), drawn, x_label=", ".join(swept[0].values), unit=unit),
        caption="Least reading error at the computed points: the best drives and the present one. "
        "The lines only guide the eye.",
        alt_text="A line per drive of the reading error over the swept values; the table has the numbers.",
        name="sweep_errors", csv=sweep_csv(swept),
    )  # fmt: skip


def _point(at: int, point: SweptPoint, axes: Mapping[str, Sequence[str]], count: int) -> Mapping[str, Any]:
    from torquerig.reporting.study import pictures

    decided, answer = point.decided, point.verdict
    made = decided.alternatives.get(answer.winner, decided.alternatives[decided.baseline])
    shown = pictures.filtered(made.drive, made.chain, point.runs)
    return {
        "key": ",".join(str(list(axes[key]).index(value)) for key, value in point.values.items()),
        "text": point.text, "sentence": answer.answer.sentences[0], "figures": answer.answer.figures,
        "picture": None if shown is None else _reading(at, point.text, shown, count),
        "ranking": tables.ranking_table(decided, winner=answer.winner, most=RANKED),
        "matrices": data_script(f"data-matrix-{at}", matrix_model_of(point.runs, decided)),
        "matrices_id": f"data-matrix-{at}",
    }  # fmt: skip


def _reading(at: int, where: str, shown: pictures.Filtered, count: int) -> Picture:
    from torquerig.reporting.figures.picture import picture
    from torquerig.reporting.figures.signal_figure import signal_figure
    from torquerig.reporting.moving.signal_plot import signal_plot

    after = shown.after if shown.chain.stages else shown.before
    kept = min(shown.before.samples, max(MOST_SAMPLES // count, int(2 * FIRST_VIEW * shown.before.sample_rate)))
    before, after = _beginning(shown.before, kept), _beginning(after, kept)
    start, name = min(1.0, before.duration / 2), f"sweep_reading_{at + 1}"
    whole = "" if kept == shown.before.samples else f" The page holds its first {before.duration:.3g} s."
    return picture(
        signal_figure(before, after, start=start),
        caption=f"{where}: {shown.drive.candidate.name} with the filter {shown.chain.name}.{whole}",
        alt_text="Torque over time before and after the filter, and the true load.",
        name=name, plot=signal_plot(before, after, target=plot_name(name), start=start),
    )  # fmt: skip


def _beginning(recording: Recording, samples: int) -> Recording:
    cut = {name: replace(one, values=one.values[:samples]) for name, one in recording.channels.items()}
    return replace(recording, channels=cut)
