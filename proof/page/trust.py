"""Whether a confidence can be believed, and whether naming an effect ever makes the model worse."""

from __future__ import annotations

from collections.abc import Sequence

from proof.page.cells import percent
from proof.page.figures import reliability_figure
from proof.scoring.summary import Summary
from proof.scoring.trial import Trial
from torquerig.reporting.figures.picture import Picture, picture
from torquerig.reporting.layout import Table, number, words
from torquerig.reporting.matrix.chapters import Chapter


def calibration(ours: Summary) -> Chapter:
    """Return expected calibration error, Brier score and the reliability table."""
    found = ours.calibration
    if found is None:
        return Chapter(anchor="calibration", title="Calibration", lines=("Nothing was named, so nothing can be said.",))
    rows = tuple(
        (*words(f"{row.low:.1f} to {row.high:.1f}"), number(str(row.count)), number(percent(row.said)),
         number(percent(row.right)))
        for row in found.table
    )  # fmt: skip
    lines = (
        (
            f"Expected calibration error {found.expected_error:.3f} over {found.count} findings (asked: 0.05 or less), "
            f"Brier score {found.brier:.3f}."
        ),
    )
    table = Table(caption="Reliability", head=("confidence", "findings", "said, mean", "right"), rows=rows)
    return Chapter(anchor="calibration", title="Calibration", lines=lines, tables=(table,))


def reliability_picture(ours: Summary) -> tuple[Picture, ...]:
    """Return the reliability diagram, where anything was named."""
    if ours.calibration is None:
        return ()
    figure = reliability_figure([(row.said, row.right, row.count) for row in ours.calibration.table])
    told = "Confidence that was said against the share that was right; numbers are findings."
    return (picture(figure, caption=told, told="reliability diagram"),)


def improvement(ours: Summary, trials: Sequence[Trial]) -> Chapter:
    """Return what was gained on data that no fit has seen, beside the oracle, and every case that was harmed."""
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
            f"Over {len(gains)} rigs in which something was named, the median share of the held-out misfit that "
            f"goes away is {percent(ours.improvement)}."
        ),
        (
            "The oracle is told which mechanisms of the library are there, and nothing else; it fits them with the "
            "diagnosis' own code, without any threshold. Of what it removes the diagnosis removes "
            f"{percent(ours.of_oracle)} (median over the {ours.oracles} rigs that it was run on, those in which "
            "nothing was named among them; asked: 90 % or more)."
        ),
        f"Worse by more than 1 % on held-out data: {len(harmed)} of {len(gains)}.",
    ]
    tables = (Table(caption="Harmed", head=("case", "named", "misfit removed"), rows=harmed),) if harmed else ()
    return Chapter(
        anchor="improvement", title="Improvement on held-out data, and harm", lines=tuple(lines), tables=tables
    )


PERCENT = 100.0
