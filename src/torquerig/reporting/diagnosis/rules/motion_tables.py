"""Tables of a diagnosis under measured motion: alternative hypotheses, residuals run by run, the runs."""

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
from torquerig.reporting.diagnosis.rules.motion_panels import effort_name
from torquerig.reporting.diagnosis.sentences import mechanism_text
from torquerig.reporting.layout import Cell, Table, number, plain, words

SIZES = (
    "Excess of a line: its power over the neighbouring noise floor. Excess at a speed: the mean residual over its "
    "standard deviation. Shares can overlap, because a speed-dependent residual has spectral lines too."
)
CORRECTION = (
    "Lines and speeds: corrected for all tested places (Bonferroni). Times and positions: permutation or sign-flip "
    "test, with a smallest p-value of 0.001."
)
NO_PLACE = (
    "No line and no speed is significant in the residual of the calibrated model, so there is no figure of places. "
    "The figures over time show the effect of the findings."
)
REJECTED = (
    "Tested on the fitted data. The library's other mechanisms are not tested under measured motion. Their residuals "
    "are reported as lines over position or in frequency."
)
_USED = {"split": "fit and held out, alternating", "fit": "fit", "held_out": "held out"}


def alternatives_tables(outcome: MotionOutcome) -> list[Table | None]:
    """Return, for each finding, the alternative hypotheses with their residuals.

    None for findings from single samples, which have no alternatives.
    """
    found, of_samples = outcome.diagnosis.findings, len(outcome.diagnosis.findings) - len(outcome.steps)
    tried = [
        _alternatives(finding, step, outcome) for finding, step in zip(found[of_samples:], outcome.steps, strict=True)
    ]
    return [*([None] * of_samples), *tried]


def _alternatives(finding: Finding, step: Step, outcome: MotionOutcome) -> Table:
    rows = [_row(one, finding) for one in scores(step, outcome)]
    nothing = (*words("none of them"), number("0"), number(""), number(""),
               number(_percent(without(step, outcome))), *words("model without it"))  # fmt: skip
    return Table(
        caption="Alternative hypotheses",
        head=("mechanism", "gain", "of the best", "residual falls by", "held-out residual", "judgement"),
        rows=(*rows, nothing), emphasised=frozenset({0}),
        note="Gain: twice the increase of the log-likelihood of the fitted data, less the penalty for further "
        "parameters. The likelihood accounts for coloured residuals. A finding needs a gain of at least "
        f"{LEAST_GAIN:g} and a residual that falls by at least {100 * LEAST_FALL:.0f} %. Each candidate is "
        "first fitted alone; only the best are refitted together with the model.",
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
        return "accepted"
    if one.mechanism == finding.mechanism:
        return "variant of the same mechanism"
    if one.mechanism in finding.equivalent_to:
        return "not distinguished by these recordings"
    return "explains less" if one.gain > 0 else "gain below the penalty for its parameters"


def held_out_table(runs: Sequence[MotionCompared], *, scale: Scale) -> Table:
    """Return the rms residual of each run's held-out samples."""
    alone = all(one.alone for one in runs)
    rows = []
    for one in runs:
        models = [one.before] if alone else [one.before, one.after]
        residuals = (number(f"{plain(one.left(each))} ({_percent(one.error(each))})") for each in models)
        held = f"{np.count_nonzero(one.run.held) / one.run.rate:.3g}"
        rows.append((*words(one.run.name), number(held), number(plain(one.effort_rms)), *residuals))
    unit = scale.effort
    head = ("recording", "held out [s]", f"{effort_name(scale)}, rms [{unit}]", f"calibrated model [{unit}]")
    return Table(
        caption=f"Rms residual of held-out data, run by run, and as a share of the {effort_name(scale)}",
        head=head + (() if alone else (f"with findings [{unit}]",)), rows=tuple(rows),
    )  # fmt: skip


def runs_table(outcome: MotionOutcome, *, scale: Scale) -> Table:
    """Return the recordings with their motion, the measured quantity and their use."""
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
              f"highest speed [{scale.speed}]", f"{effort_name(scale)} measured as", "used for"),
    )  # fmt: skip
