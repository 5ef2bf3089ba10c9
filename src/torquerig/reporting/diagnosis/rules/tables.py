"""Tables of a diagnosis by the first engine: parameters, alternative hypotheses, residuals, runs."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import Finding
from torquerig.diagnosis.showing.comparison import Compared
from torquerig.reporting.diagnosis.sentences import mechanism_text
from torquerig.reporting.layout import Cell, Table, number, plain, words


def parameters_table(finding: Finding) -> Table:
    """Return the parameters that identify a finding, with their 95 % intervals."""
    rows = [
        (*words(name), number(plain(each.value, 4)), number(f"{plain(each.low, 4)} to {plain(each.high, 4)}"),
         Cell(text=each.unit))
        for name, each in finding.parameters.items()
    ]  # fmt: skip
    return Table(
        caption="Identified parameters", head=("parameter", "value", "95 % interval", "unit"), rows=tuple(rows)
    )


def alternatives_table(finding: Finding) -> Table:
    """Return the hypotheses that were fitted with all parameters free, and by what chi-square fell."""
    scores = [(finding.mechanism, finding.gain), *finding.alternatives]
    rows = [
        (*words(mechanism_text(name)), number(plain(gain, 4)),
         number(f"{100 * gain / finding.gain:.1f} %" if finding.gain > 0 else "?"), *words(_judged(finding, name)))
        for name, gain in scores
    ]  # fmt: skip
    return Table(
        caption="Alternative hypotheses, each fitted together with all parameters of the model",
        head=("mechanism", "chi-square falls by", "of the best", "judgement"),
        rows=tuple(rows), emphasised=frozenset({0}),
        note="Chi-square is the sum of squared standardised residuals. The fall is net of the penalty for each further "
        "parameter. An alternative is rejected where it fits worse by more than 2.33 standard deviations of the "
        "difference. Fitted and held-out features both count.",
    )  # fmt: skip


def _judged(finding: Finding, name: str) -> str:
    if name == finding.mechanism:
        return "accepted"
    return "not distinguished by these recordings" if name in finding.equivalent_to else "rejected: fits worse"


def held_out_table(runs: Sequence[Compared]) -> Table:
    """Return the mean squared standardised residual of each run's held-out stretches."""
    alone = all(one.after is one.before for one in runs)
    rows = []
    for one in runs:
        sides = [one.before] if alone else [one.before, one.after]
        found = (number(plain(side.mean_square)) for side in sides)
        rows.append((*words(one.held.observed.name), number(str(one.before.misfit.seen)), *found))
    head = ("recording", "features", "calibrated model") + (() if alone else ("with findings",))
    return Table(
        caption="Mean squared standardised residual on held-out stretches, run by run",
        head=head, rows=tuple(rows),
        note="A true model is below 1. This table uses one simulation of each model. The values at the top combine all "
        "runs, and use two simulations where backlash is a hypothesis.",
    )  # fmt: skip


def runs_table(outcome: Outcome) -> Table:
    """Return the recordings with their conditions and the source of the shaft angle."""
    rows = []
    for held in outcome.held:
        run = held.observed
        load = "?" if run.run.occupancy_percent is None else f"{run.run.occupancy_percent:g} %"
        real = f"{run.mean_speed * 30 / pi:.1f}" if run.steady else ""
        rows.append((*words(run.name, run.run.profile), number(plain(run.run.speed_rpm, 5)), number(real), number(load),
                     number(f"{run.recording.duration:g}"), *words(run.origin)))  # fmt: skip
    return Table(
        caption="The recordings", rows=tuple(rows),
        head=("recording", "profile", "speed held [rpm]", "mean speed [rpm]", "occupancy", "length [s]", "shaft angle"),
    )  # fmt: skip
