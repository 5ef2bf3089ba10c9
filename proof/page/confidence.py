"""Calibration of the confidence, and improvement or harm on held-out data."""

from __future__ import annotations

from collections.abc import Sequence

from proof.page.cells import percent
from proof.page.figures import reliability_figure
from proof.scoring.summary import Summary
from proof.scoring.trial import Trial
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.layout import Table, number, words
from torquerig.reporting.matrix.chapters import Chapter


def calibration(ours: Summary) -> Chapter:
    """Return expected calibration error, Brier score and the reliability table."""
    found = ours.calibration
    if found is None:
        return Chapter(anchor="calibration", title="Calibration", lines=("No findings, so no calibration.",))
    rows = tuple(
        (*words(f"{row.low:.1f} to {row.high:.1f}"), number(str(row.count)), number(percent(row.said)),
         number(percent(row.right)))
        for row in found.table
    )  # fmt: skip
    lines = (
        (
            f"Calibration error: {found.expected_error:.3f} of {found.count} findings (required: at most 0.05), "
            f"Brier score {found.brier:.3f}."
        ),
    )
    table = Table(caption="Reliability", head=("confidence", "findings", "mean confidence", "right"), rows=rows)
    return Chapter(anchor="calibration", title="Calibration", lines=lines, tables=(table,))


def reliability_picture(ours: Summary) -> tuple[Picture, ...]:
    """Return the reliability diagram, if there are findings."""
    if ours.calibration is None:
        return ()
    figure = reliability_figure([(row.said, row.right, row.count) for row in ours.calibration.table])
    caption = "Stated confidence and share of right findings; the numbers count findings."
    return (picture(figure, caption=caption, alt_text="reliability diagram"),)


def improvement(ours: Summary, trials: Sequence[Trial]) -> Chapter:
    """Return the improvement on held-out data compared with the oracle, and every case with harm."""
    gains = [(trial, trial.improvement) for trial in trials if trial.improvement is not None and trial.matches]
    harmed = tuple(
        words(
            trial.name, ", ".join(match.finding.mechanism for match in trial.matches), f"{PERCENT * gain.share:+.1f} %"
        )
        for trial, gain in gains
        if gain.harmed
    )
    lines = [
        (
            f"On {len(gains)} rigs with findings, the median reduction of the held-out residual is "
            f"{percent(ours.improvement)}."
        ),
        (
            "The oracle knows the true mechanisms and fits them with the code of the diagnosis. "
            f"The diagnosis reaches {percent(ours.of_oracle)} of the oracle's reduction (median of {ours.oracles} "
            "rigs, including rigs without findings; required: 90 % or more)."
        ),
        f"Worse by more than 1 % on held-out data: {len(harmed)} of {len(gains)}.",
    ]
    tables = (
        (
            Table(
                caption="Cases with a larger held-out residual",
                head=("case", "findings", "residual removed"),
                rows=harmed,
            ),
        )
        if harmed
        else ()
    )
    return Chapter(anchor="improvement", title="Improvement on held-out data", lines=tuple(lines), tables=tables)


PERCENT = 100.0
