"""Tables of a diagnosis: parameters, alternative hypotheses, mismatches, rejected mechanisms, residuals, runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import pi

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import Finding, Mismatch
from torquerig.diagnosis.showing.comparison import Compared
from torquerig.reporting.diagnosis.sentences import kind_text, mechanism_text, p_value_text, place_text
from torquerig.reporting.layout import Cell, Table, number, plain, words

SIZES = "Excess of a line: residual over its standard deviation. Excess of a frequency band: recording over model."
BONFERRONI = "It is corrected for all tested places (Bonferroni)."


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


def mismatch_table(mismatches: Sequence[Mismatch], *, sizes: str = SIZES, correction: str = BONFERRONI) -> Table:
    """Return the places where recordings and calibrated model differ.

    ``sizes`` defines the excess, ``correction`` how the p-value accounts for the number of tested places.
    """
    rows = [
        (*words(place_text(each), kind_text(each)), number(f"{each.excess_dB:.1f}"),
         number(f"{100 * each.share_of_misfit:.1f} %"), number(p_value_text(each.p_value)),
         Cell(text=", ".join(each.recordings)))
        for each in mismatches
    ]  # fmt: skip
    return Table(
        caption="Where recordings and model differ, largest share first",
        head=("where", "kind", "excess [dB]", "share of squared residual", "p-value", "recordings"), rows=tuple(rows),
        note="p-value: the probability of so large a difference at any tested place if the model is true. "
        f"{correction} {sizes}",
    )  # fmt: skip


def rejected_table(
    reasons: Mapping[str, str], *, note: str = "Tested on the residual of the calibrated nominal model."
) -> Table:
    """Return the rejected mechanisms, each with its reason."""
    rows = tuple(words(mechanism_text(name), why) for name, why in reasons.items())
    return Table(caption="Rejected mechanisms", head=("mechanism", "reason"), rows=rows, note=note)


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
