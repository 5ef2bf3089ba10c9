"""The tables of a diagnosis: parameters, rivals, places, what was set aside, fitted numbers, runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import pi

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import Finding, Mismatch
from torquerig.diagnosis.showing.comparison import Compared
from torquerig.reporting.diagnosis.sentences import chance_text, kind_text, mechanism_text, place_text
from torquerig.reporting.layout import Cell, Table, number, plain, words

SIZES = "The size of a line is its residual over its spread, that of a band the recording over the model."
BONFERRONI = "Bonferroni"


def parameters_table(finding: Finding) -> Table:
    """Return the identifying parameters with their intervals."""
    rows = [
        (*words(name), number(plain(each.value, 4)), number(f"{plain(each.low, 4)} to {plain(each.high, 4)}"),
         Cell(text=each.unit))
        for name, each in finding.parameters.items()
    ]  # fmt: skip
    return Table(caption="What identifies it", head=("parameter", "value", "95 % interval", "unit"), rows=tuple(rows))


def rivals_table(finding: Finding) -> Table:
    """Return the hypotheses that were fitted with all numbers free, and by what the misfit fell."""
    scores = [(finding.mechanism, finding.gain), *finding.rivals]
    rows = [
        (*words(mechanism_text(name)), number(plain(gain, 4)),
         number(f"{100 * gain / finding.gain:.1f} %" if finding.gain > 0 else "?"), *words(_judged(finding, name)))
        for name, gain in scores
    ]  # fmt: skip
    return Table(
        caption="It and its rivals, each fitted together with all numbers of the model",
        head=("mechanism", "misfit falls by", "of the best", "judgement"), rows=tuple(rows), emphasised=frozenset({0}),
        note="The misfit is a sum of squares in units of each feature's spread; each further number has been paid for. "
        "A rival is excluded where it fits worse, on fitted and held-out features, by more than 2.33 times what chance "
        "puts between the two.",
    )  # fmt: skip


def _judged(finding: Finding, name: str) -> str:
    if name == finding.mechanism:
        return "named"
    return "cannot be told from it" if name in finding.equivalent_to else "fits worse than chance allows"


def mismatch_table(mismatches: Sequence[Mismatch], *, sizes: str = SIZES, chance: str = BONFERRONI) -> Table:
    """Return the places where recordings and calibrated model differ.

    ``sizes`` says what their size counts, ``chance`` where their probability comes from.
    """
    rows = [
        (*words(place_text(each), kind_text(each)), number(f"{each.excess_dB:.1f}"),
         number(f"{100 * each.share_of_misfit:.1f} %"), number(chance_text(each.p_value)),
         Cell(text=", ".join(each.recordings)))
        for each in mismatches
    ]  # fmt: skip
    return Table(
        caption="Where recordings and model differ, largest share first",
        head=("place", "kind", "size [dB]", "share of misfit", "p", "recordings"), rows=tuple(rows),
        note="p is the chance that so large a difference stands anywhere among all places looked at "
        f"({chance}). {sizes}",
    )  # fmt: skip


def aside_table(
    reasons: Mapping[str, str], *, note: str = "Judged by what the calibrated nominal model leaves."
) -> Table:
    """Return the mechanisms that were set aside, each with its reason."""
    rows = tuple(words(mechanism_text(name), why) for name, why in reasons.items())
    return Table(caption="Mechanisms that were set aside, and why", head=("mechanism", "reason"), rows=rows, note=note)


def held_out_table(runs: Sequence[Compared]) -> Table:
    """Return the misfit of each run's held-out stretches."""
    alone = all(one.after is one.before for one in runs)
    rows = []
    for one in runs:
        sides = [one.before] if alone else [one.before, one.after]
        found = (number(plain(side.mean_square)) for side in sides)
        rows.append((*words(one.held.observed.name), number(str(one.before.misfit.seen)), *found))
    head = ("recording", "features", "calibrated model") + (() if alone else ("with what was found",))
    return Table(
        caption="Mean square of the residuals on held-out stretches, run by run, against one simulation of each model",
        head=head, rows=tuple(rows),
        note="Below 1 for a true model. The figures of the diagnosis take all runs together, and two simulations each "
        "where a gap is in question.",
    )  # fmt: skip


def runs_table(outcome: Outcome) -> Table:
    """Return the recordings with their conditions and where the shaft's angle comes from."""
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
