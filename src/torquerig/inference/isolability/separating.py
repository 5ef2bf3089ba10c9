"""Which further run separates two models, in one sentence."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.addition import Addition
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit, fitted
from torquerig.inference.isolability.further_runs import FurtherRun, further_runs
from torquerig.inference.knobs import Knob, turned
from torquerig.inference.likelihood import Residuals, floor_density, residuals
from torquerig.inference.load_spectrum import gain_shapes, with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.inference.search import LEAST_GAIN
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_STEP = 0.05  # [standard deviations] of a difference quotient
_FOLLOWED = 3  # runs of one cost, those that differ most, for which the parameters are followed


def separating_run(one: Rig, other: Rig, seen: Sequence[RunFeatures], fit: Fit, *, names: tuple[str, str]) -> str:
    """Return the cheapest further run by which the likelihood of two models differs by ``LEAST_GAIN`` nats, as text.

    ``seen`` are the recorded runs and ``fit`` is the fit to them, which says how well the parameters are known.
    """
    first, second = (name.replace("_", " ") for name in names)
    runs = list(further_runs(seen, one))
    for cost in sorted({each.cost for each in runs}):
        rated = [(each, _change(one, other, each.seen, fit)) for each in runs if each.cost == cost]
        clear = sorted(((each, change) for each, change in rated if change is not None),
                       key=lambda row: -float(row[1].value @ row[1].value))  # fmt: skip
        best = max(((each, _nats(one, change, fit)) for each, change in clear[:_FOLLOWED]),
                   key=lambda row: row[1], default=None)  # fmt: skip
        if best is not None and best[1] >= LEAST_GAIN:
            return (
                f"Record {_said(best[0])}. It separates {first} from {second} by {best[1]:.0f} nats of log-likelihood."
            )
    return (
        f"No other speed, load, run-up or reversal separates {first} from {second}. "
        "Inspect the part, or put a sensor next to it."
    )


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


@dataclass(frozen=True, eq=False)
class _Change:
    """How a run that behaves as one model differs from another, in standard deviations."""

    made: RunFeatures
    here: Residuals
    sd: Floats
    value: Floats


def _change(one: Rig, other: Rig, seen: RunFeatures, fit: Fit) -> _Change | None:
    """Return the change of the residuals of a run from one model to the other; None where one cannot be evaluated."""
    try:
        true, wrong = expected_run(one, seen), expected_run(other, seen)
    except (TorquerigError, ValueError, OverflowError, np.linalg.LinAlgError):
        return None
    made = _as_expected(seen, true)
    there, here = residuals(made, wrong, fit.off), residuals(made, true, fit.off)
    return _Change(made, here, there.sd, (there.value - here.value) / there.sd)


def _nats(one: Rig, change: _Change, fit: Fit) -> float:
    """Return by how much the run is more likely under the first model [nats].

    What the recorded runs leave open of the parameters, with the covariance K, and the strength of the load in the run
    may follow the other model: ``1/2 d' (I + J K J' + g g')^-1 d``.
    """
    spread = [column for knob, column in zip(fit.knobs, _roots(fit), strict=True) if _has(one, knob)]
    knobs = [knob for knob in fit.knobs if _has(one, knob)]
    slopes = np.stack([_slope(turned(one, [knob], np.array([_STEP])), change, fit) for knob in knobs], axis=1)
    open_ones = np.concatenate([slopes @ np.array(spread), _strength(one, change, fit)[:, None]], axis=1)
    followed = open_ones.T @ change.value
    inner = np.eye(open_ones.shape[1]) + open_ones.T @ open_ones
    return 0.5 * float(change.value @ change.value - followed @ np.linalg.solve(inner, followed))


def _roots(fit: Fit) -> Floats:
    """Return the lower root of the posterior covariance of the parameters."""
    count = len(fit.knobs)
    return np.asarray(np.linalg.cholesky(fit.covariance()[:count, :count] + 1e-12 * np.eye(count)))


def _has(rig: Rig, knob: Knob) -> bool:
    return any(part.name == knob.part for part in rig.parts)


def _slope(rig: Rig, change: _Change, fit: Fit) -> Floats:
    moved = residuals(change.made, expected_run(rig, change.made), fit.off)
    return np.asarray((moved.value - change.here.value) / (_STEP * change.sd))


def _strength(one: Rig, change: _Change, fit: Fit) -> Floats:
    """Return the derivative by the strength of the load in this run."""
    shape = gain_shapes(change.made, run=0, runs=(change.made.run,))
    gains = np.zeros(shape.count)
    gains[-3] = _STEP  # after it come the exponent of the speed and the slow load
    moved = residuals(change.made, with_gains(expected_run(one, change.made), shape, gains), fit.off)
    return np.asarray((moved.value - change.here.value) / (_STEP * change.sd))


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
