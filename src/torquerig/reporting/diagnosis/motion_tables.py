"""The tables of a diagnosis under measured motion: what was tried for each finding, errors run by run, the runs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.evidence import LEAST_GAIN
from torquerig.diagnosis.motion.objections import LEAST_FALL
from torquerig.diagnosis.motion.tried import Step
from torquerig.diagnosis.outcome import Finding
from torquerig.diagnosis.showing.motion_comparison import MotionCompared, Scale
from torquerig.diagnosis.showing.motion_scores import Score, scores, without
from torquerig.reporting.diagnosis.sentences import mechanism_text
from torquerig.reporting.layout import Cell, Table, number, plain, words

SIZES = (
    "The size of a line is its power over the floor beside it, that of a speed the mean residual there over its "
    "standard deviation. Shares overlap, for what goes with the speed has lines too."
)
CHANCE = (
    "of lines and speeds by Bonferroni, of times and places of a stroke by as many stretches in another order or of "
    "another sign, which tell no less than 0.001"
)
NOWHERE = (
    "No line and no speed stands out of what the calibrated model leaves, so there is no picture of places: what was "
    "found shows in the course of the effort, below."
)
ASIDE = (
    "Judged on what fits may see. The library's other mechanisms are not looked for under measured motion: what they "
    "leave is told as a line over the place or in frequency."
)
_USED = {"split": "fit and held out, by turns", "fit": "fit", "held_out": "held out"}


def rivals_tables(outcome: MotionOutcome) -> list[Table | None]:
    """Return, for each finding, the hypotheses that were tried in its place and what each leaves.

    None for the first ones, which the samples showed: nothing was tried in their place.
    """
    found, seen = outcome.diagnosis.findings, len(outcome.diagnosis.findings) - len(outcome.steps)
    tried = [_rivals(finding, step, outcome) for finding, step in zip(found[seen:], outcome.steps, strict=True)]
    return [*([None] * seen), *tried]


def _rivals(finding: Finding, step: Step, outcome: MotionOutcome) -> Table:
    rows = [_row(one, finding) for one in scores(step, outcome)]
    nothing = (*words("none of them"), number("0"), number(""), number(""),
               number(_percent(without(step, outcome))), *words("the model without it"))  # fmt: skip
    return Table(
        caption="It and what was tried in its place",
        head=("mechanism", "gain", "of the best", "residual falls by", "held-out error", "judgement"),
        rows=(*rows, nothing), emphasised=frozenset({0}),
        note="The gain is twice the growth of the log likelihood on what fits see, with the colour of what is left "
        f"reckoned with and each further number paid for; below {LEAST_GAIN:g}, or where the residual falls by less "
        f"than {LEAST_FALL:.0%}, nothing is named. What gains clearly less by its own numbers alone is not fitted "
        "with all of the model.",
    )  # fmt: skip


def _row(one: Score, finding: Finding) -> tuple[Cell, ...]:
    variant = f" ({mechanism_text(one.variant)})" if one.variant else ""
    return (
        *words(mechanism_text(one.mechanism) + variant), number(plain(one.gain, 4)),
        number(_percent(one.gain / finding.gain)), number(_percent(one.fall)),
        number(_percent(one.held_out)), *words(_judged(one, finding)),
    )  # fmt: skip


def _percent(share: float) -> str:
    return f"{round(100 * share, 1) + 0.0:.1f} %"  # no minus before a zero


def _judged(one: Score, finding: Finding) -> str:
    if one.named:
        return "named"
    if one.mechanism == finding.mechanism:
        return "another form of the same"
    if one.mechanism in finding.equivalent_to:
        return "cannot be told from it"
    return "explains less" if one.gain > 0 else "is not worth its numbers"


def held_out_table(runs: Sequence[MotionCompared], *, scale: Scale) -> Table:
    """Return the error of each run's held-out samples."""
    alone = all(one.alone for one in runs)
    rows = []
    for one in runs:
        models = [one.before] if alone else [one.before, one.after]
        left = (number(f"{plain(one.left(each))} ({_percent(one.error(each))})") for each in models)
        held = f"{np.count_nonzero(one.run.held) / one.run.rate:.3g}"
        rows.append((*words(one.run.name), number(held), number(plain(one.effort_rms)), *left))
    unit = scale.effort
    head = ("recording", "held out [s]", f"effort, rms [{unit}]", f"calibrated model leaves [{unit}]")
    return Table(
        caption="What the models leave of the held-out effort, run by run (rms, and as a share of the effort)",
        head=head + (() if alone else (f"with what was found [{unit}]",)), rows=tuple(rows),
    )  # fmt: skip


def runs_table(outcome: MotionOutcome, *, scale: Scale) -> Table:
    """Return the recordings: how they moved, what was measured, and what they served for."""
    rows = []
    for run, used in zip(outcome.runs, outcome.diagnosis.recordings, strict=True):
        travel = plain(float(np.ptp(run.position)) / scale.place_unit)
        fastest = plain(float(np.abs(run.speed).max()) / scale.speed_unit)
        measured = f"{run.channel.quantity.replace('_', ' ')} [{run.channel.unit}]"
        rows.append((*words(run.name), number(f"{run.recording.duration:.4g}"), number(plain(run.rate, 5)),
                     number(travel), number(fastest), *words(measured, _USED[used.used_for])))  # fmt: skip
    return Table(
        caption="The recordings", rows=tuple(rows),
        head=("recording", "length [s]", "samples per second", f"travel [{scale.place}]",
              f"highest speed [{scale.speed}]", "effort measured as", "used for"),
    )  # fmt: skip
