"""Whether a mechanism explains the features that it changes: its name claims that one cause makes them all.

A mechanism can raise the likelihood although it is not the cause: where something unknown makes a comb of lines, each
of them is a tone, and all of them together are a ringing mode. Then much of what it should make is left.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace

import numpy as np

from torquerig.inference.addition import Addition
from torquerig.inference.adequacy import LEVEL_OF_TEST, JudgedRun, excesses, judged_run, judged_runs
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit
from torquerig.inference.likelihood import Residuals
from torquerig.inference.model import Model
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run


def refuted(model: Model, data: Data, held: Data) -> tuple[Addition, ...]:
    """Return the mechanisms of a model that leave more of the features that they change than they make of them.

    Tested as in ``adequacy``, of fitted and of held-out blocks: what is left is also more than chance and a right model
    leave. True causes of 15 development cases left 0.8 of themselves at most, a ringing mode in a comb of tones 38.
    """
    named = [each for each in model.additions if each.is_named]
    runs = judged_runs(model.fit, data, held) if named else ()
    return tuple(each for each in named if _is_refuted(each, model.fit, data, held, runs))


def _is_refuted(each: Addition, fit: Fit, data: Data, held: Data, runs: Sequence[JudgedRun]) -> bool:
    less = without_parts(fit, data, [each])
    size = max(map(difference, data.seen, fit.expected, less.expected))
    own = [_changed(*both) for both in zip(runs, judged_runs(less, data, held), strict=True)]
    return any(left.p_value < LEVEL_OF_TEST for left in excesses(own, size))


def _changed(run: JudgedRun, less: JudgedRun) -> JudgedRun:
    """Return a run with those features that a model without the mechanism misses by a standard deviation more."""
    given = run.residuals
    own = np.abs(less.residuals.value - given.value) > given.sd
    rows = Residuals(*(getattr(given, each.name)[own] for each in fields(given)))
    return replace(judged_run(run.seen, rows), common=None if run.common is None else run.common[own])


def without_parts(fit: Fit, data: Data, less: Sequence[Addition]) -> Fit:
    """Return a fit without the parts of some additions, the other parameters as they are."""
    names, rig = {part.name for each in less for part in each.parts}, fit.rig
    for name in sorted(names):
        rig = rig.without(name)
    kept = [at for at, knob in enumerate(fit.knobs) if knob.part not in names]
    columns = [*kept, *range(len(fit.knobs), fit.jacobian.shape[1])]
    fit = replace(
        fit, rig=rig, knobs=tuple(fit.knobs[at] for at in kept), positions=fit.positions[kept],
        jacobian=fit.jacobian[:, columns],
    )  # fmt: skip
    return replace(fit, expected=tuple(expected_run(fit.fitted_rig, seen) for seen in data.seen))


def difference(seen: RunFeatures, full: ExpectedRun, less: ExpectedRun) -> float:
    """Return the rms by which two models differ in the reading of a run [N m].

    Of lines, of the spectrum between them and of mean torques; those are uncorrelated.
    """
    width = seen.bands.high - seen.bands.low
    lines = 0.5 * (np.sqrt(full.line_power) - np.sqrt(less.line_power)) ** 2
    noise = (np.sqrt(full.density) - np.sqrt(less.density)) ** 2 * width
    shown = (lines.sum(axis=1) + noise.sum(axis=1)).max(initial=0.0)
    levels = np.mean((full.level - less.level) ** 2) if full.level.size else 0.0
    return float(np.sqrt(shown + levels))
