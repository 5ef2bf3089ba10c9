"""What still stands out when a model is as good as it gets: lines, and speeds at which the level is wrong."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import erfc, log10, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnose.leftover import Mismatch
from torquerig.diagnose.motion.evidence import samples_that_count
from torquerig.diagnose.motion.fitted import FittedMotion
from torquerig.diagnose.motion.lines import Line, in_a_line, lines_in, moving
from torquerig.diagnose.motion.moved import Moved

Floats = NDArray[np.float64]

_BINS = 12
_OUT = 6.0  # standard deviations of a bin's mean
_TOLERANCE = 0.03  # of the rms effort: what nobody models


def mismatches(model: FittedMotion, runs: Sequence[Moved]) -> tuple[Mismatch, ...]:
    """Return the places where the model is significantly wrong, largest share of what it leaves first."""
    found = [_of_line(line, model, runs) for line in lines_in(model.residuals, runs)]
    found += _of_speed(model, runs)
    return tuple(sorted(found, key=lambda one: -one.share_of_misfit))


def _of_line(line: Line, model: FittedMotion, runs: Sequence[Moved]) -> Mismatch:
    left = model.of(runs)
    total = sum(float(each @ each) for each in left)
    count = sum(int((run.seen & moving(run)).sum()) for run in runs)
    axis = "Hz" if line.domain == "frequency" else "cycles/m" if in_a_line(runs) else "motor_shaft"
    return Mismatch(
        domain=line.domain, axis=axis, at=line.at, width=line.width, recordings=_names(runs), excess_dB=line.excess_db,
        share_of_misfit=min(1.0, 0.5 * line.amplitude**2 * count / total), p_value=line.p_value,
    )  # fmt: skip


def _of_speed(model: FittedMotion, runs: Sequence[Moved]) -> list[Mismatch]:
    """Return the band of speed at which the residual's mean is furthest from zero, if it is."""
    left, count = model.of(runs), samples_that_count(model.of(runs))
    every = np.concatenate(left)
    speed = np.concatenate([run.speed[run.seen] for run in runs])
    typical = float(np.sqrt(np.mean(np.concatenate([run.effort[run.seen] for run in runs]) ** 2)))
    edges = np.quantile(speed, np.linspace(0, 1, _BINS + 1))
    rows = [np.flatnonzero((speed >= low) & (speed <= high)) for low, high in pairwise(edges)]
    means = np.array([every[row].mean() if row.size else 0.0 for row in rows])
    spread = np.array([every[row].std() / sqrt(max(row.size * count / every.size, 1.0)) if row.size else 1.0
                       for row in rows]) + 1e-300  # fmt: skip
    worst = int(np.argmax(np.abs(means)))
    out = abs(means[worst]) / spread[worst]
    if out < _OUT or abs(means[worst]) < _TOLERANCE * typical:
        return []
    unit = 1.0 if in_a_line(runs) else 30 / pi
    return [Mismatch(
        domain="speed", axis="m/s" if in_a_line(runs) else "rpm", at=float(np.median(speed[rows[worst]])) * unit,
        width=float(np.ptp(speed[rows[worst]])) * unit, recordings=_names(runs), excess_dB=20 * log10(out),
        share_of_misfit=min(1.0, float((means**2 * np.array([row.size for row in rows])).sum() / (every @ every))),
        p_value=min(1.0, _BINS * erfc(out / sqrt(2))),
    )]  # fmt: skip


def _names(runs: Sequence[Moved]) -> tuple[str, ...]:
    return tuple(run.name for run in runs if run.seen.any())
