"""Which further run separates two models, in one sentence."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from torquerig.errors import TorquerigError
from torquerig.inference.addition import Addition
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit, fitted
from torquerig.inference.isolability.further_runs import FurtherRun, further_runs
from torquerig.inference.likelihood import Discrepancy, floor_density, residuals
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.inference.search import LEAST_GAIN
from torquerig.rig.assembly import Rig


def separating_run(
    one: Rig, other: Rig, seen: Sequence[RunFeatures], off: Discrepancy, *, names: tuple[str, str]
) -> str:
    """Return the cheapest further run by which the likelihood of two models differs by ``LEAST_GAIN`` nats, as text."""
    first, second = (name.replace("_", " ") for name in names)
    rated = [(each, difference(one, other, each.seen, off)) for each in further_runs(seen, one)]
    enough = [(each, nats) for each, nats in rated if nats >= LEAST_GAIN]
    if not enough:
        return (
            f"No other speed, load, run-up or reversal separates {first} from {second}. "
            "Inspect the part, or put a sensor next to it."
        )
    best = min(enough, key=lambda row: (row[0].cost, -row[1]))
    return f"Record {_said(best[0])}. It separates {first} from {second} by {best[1]:.0f} nats of log-likelihood."


def exchanged(fit: Fit, data: Data, *, less: Addition, more: Addition) -> Rig | None:
    """Return a fitted model with one addition in the place of another; None where there is no such rig."""
    rig, gone = fit.rig, {part.name for part in less.parts}
    for name in gone:
        rig = rig.without(name)
    kept = [at for at, knob in enumerate(fit.knobs) if knob.part not in gone]
    try:
        return fitted(
            more.added_to(rig), (*(fit.knobs[at] for at in kept), *more.knobs), data, gains=fit.gains, off=fit.off,
            start=np.concatenate([fit.positions[kept], more.starts[0]]), nominal=fit.nominal,
        ).fitted_rig  # fmt: skip
    except (TorquerigError, ValueError, np.linalg.LinAlgError):
        return None


def difference(one: Rig, other: Rig, seen: RunFeatures, off: Discrepancy) -> float:
    """Return by how much a run that behaves as the first model is more likely under it than under the other [nats]."""
    try:
        true, wrong = expected_run(one, seen), expected_run(other, seen)
    except (TorquerigError, ValueError, OverflowError, np.linalg.LinAlgError):
        return 0.0
    made = _as_expected(seen, true)
    there, here = residuals(made, wrong, off), residuals(made, true, off)
    return 0.5 * float(np.sum(((there.value - here.value) / there.sd) ** 2))


def _as_expected(seen: RunFeatures, model: ExpectedRun) -> RunFeatures:
    """Return the features of a run that shows exactly what a model expects."""
    density = floor_density(replace(seen, segments=tuple(
        replace(each, bands=replace(each.bands, power=model.density[row])) for row, each in enumerate(seen.segments)
    )), model)  # fmt: skip
    segments = tuple(
        replace(
            each, line_power=model.line_power[row] + each.line_noise_bandwidth * density[row],
            bands=replace(each.bands, power=model.density[row]),
        )
        for row, each in enumerate(seen.segments)
    )  # fmt: skip
    return replace(seen, segments=segments, level=model.level)


def _said(run: FurtherRun) -> str:
    return f"{run.words}, {run.seen.run.recording.duration:.0f} s long"
