"""The rms error of models in N m on held-out data.

Phases of random loads cannot be predicted, so recordings and model are compared as stationary processes. The smallest
rms difference that two such processes of densities S and M can have is ``integral (sqrt S - sqrt M)^2 df`` (the
2-Wasserstein distance of stationary Gaussian processes per unit of time; Gelbrich 1990, Math. Nachr. 147). Lines enter
with half the square of the difference of their amplitudes, mean torques with the square of their difference.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.answer.confidence import named, nameless
from torquerig.inference.answer.numbers import digits
from torquerig.inference.answer.sizes import without
from torquerig.inference.engine import Outcome
from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.fit import Data, Fit
from torquerig.inference.likelihood import floor_density
from torquerig.inference.load_spectrum import with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.rig.assembly import Rig
from torquerig.rig.reading_place import effort_unit

Floats = NDArray[np.float64]


def rms_errors(outcome: Outcome) -> dict[str, Any]:
    """Return the rms errors before and after, in all and by run; ``true_model`` is what random errors alone make."""
    fit, held = outcome.model.fit, outcome.held
    only = without(outcome.completed, nameless(outcome)) if named(outcome) else None
    before = squares(outcome.stated, outcome.stated_held, outcome.stated.fitted_rig)
    after = squares(fit, held, outcome.completed)
    named_only = before if only is None else squares(fit, held, only)
    lengths = np.array([_duration(seen) for seen in held.seen])
    chance = np.array([
        _random_error(seen, with_gains(expected_run(outcome.completed, seen), shape, fit.gains))
        for seen, shape in zip(held.seen, held.shapes, strict=True)
    ])  # fmt: skip
    rows = [
        {"file": seen.run.name, "before": digits(float(np.sqrt(one))), "after": digits(float(np.sqrt(other)))}
        for seen, one, other in zip(held.seen, before, after, strict=True)
    ]
    return {
        "unit": effort_unit(outcome.completed), "before": _root(before, lengths), "after": _root(after, lengths),
        "after_named_only": _root(named_only, lengths), "true_model": _root(chance, lengths), "recordings": rows,
    }  # fmt: skip


def squares(fit: Fit, held: Data, rig: Rig) -> Floats:
    """Return the mean squared error of a rig in each run [(N m)^2], with the load's spectrum of a fit."""
    return np.array([
        mean_square(seen, with_gains(expected_run(rig, seen), shape, fit.gains))
        for seen, shape in zip(held.seen, held.shapes, strict=True)
    ])  # fmt: skip


def mean_square(seen: RunFeatures, model: ExpectedRun) -> float:
    """Return the mean squared error of a model in one run [(N m)^2]."""
    table, width = seen.lines, seen.bands.high - seen.bands.low
    shown = table.count > 0
    total = model.line_power + np.where(shown, table.noise_bandwidth, 0.0) * floor_density(seen, model)
    lines = np.where(shown, 0.5 * (np.sqrt(np.where(shown, table.power, 0.0)) - np.sqrt(total)) ** 2, 0.0)
    power = np.where(np.isfinite(seen.band_power), seen.band_power, model.density)
    bands = (np.sqrt(power) - np.sqrt(model.density)) ** 2 * width
    return _mean(seen, lines.sum(axis=1) + bands.sum(axis=1), (seen.level - model.level) ** 2)


def _random_error(seen: RunFeatures, model: ExpectedRun) -> float:
    """Return the same that a true model has because spectra and means of finite records scatter [(N m)^2]."""
    table, width = seen.lines, seen.bands.high - seen.bands.low
    shown = table.count > 0
    noise = np.where(shown, table.noise_bandwidth, 0.0) * floor_density(seen, model)
    lines = np.where(shown, 0.5 * noise / (4 * np.maximum(table.count, 1.0)), 0.0)
    bands = np.where(np.isfinite(seen.band_power), width * model.density / (4 * np.maximum(seen.band_count, 1.0)), 0.0)
    return _mean(seen, lines.sum(axis=1) + bands.sum(axis=1), np.diag(model.level_covariance))


def _mean(seen: RunFeatures, segments: Floats, levels: Floats) -> float:
    """Return the mean over the segments by their length, plus the mean of the levels by theirs."""
    lengths = np.array([sum(block.stop - block.start for block in one.blocks) for one in seen.segments], dtype=float)
    spectral = float(segments @ lengths / lengths.sum()) if lengths.size else 0.0
    return spectral + (float(levels @ seen.level_duration / seen.level_duration.sum()) if levels.size else 0.0)


def _duration(seen: RunFeatures) -> float:
    return float(seen.level_duration.sum())


def _root(mean_squares: Floats, lengths: Floats) -> float:
    return digits(float(np.sqrt(mean_squares @ lengths / lengths.sum())))
