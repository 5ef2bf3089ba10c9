"""Baseline of sparse regression: torque on a column per mechanism; mechanisms with remaining columns are named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from proof.baselines.calibrated import Calibrated, CalibratedRun
from proof.baselines.columns import Column, columns_of
from proof.baselines.residual_fft import lines_of
from proof.baselines.stlsq import solver, stlsq
from proof.baselines.verdict import Named, verdict
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

THRESHOLDS = (0.1, 0.05, 0.025, 0.012, 0.006, 0.003)  # [N m] rms of a column; chosen on held-out data
_AS_GOOD = 1.002  # [1] largest error of a sparser model over the least error
_SAMPLES = 10_000  # of each run, at random so that neighbours are far apart
_ABSORBED = 1e-5  # [1] least share of a column's variance that the nominal columns do not explain
_NOTHING = 1e-12  # [1] least power of a column over the largest one
_TONES = 4


@dataclass(frozen=True)
class Sums:
    """Products of columns with each other and with the torque, summed over ``count`` samples."""

    gram: Floats
    cross: Floats
    square: float
    count: int

    def error(self, coefficients: Floats) -> float:
        """Return the mean squared residual of these coefficients [N^2 m^2]."""
        left = self.square - 2 * coefficients @ self.cross + coefficients @ self.gram @ coefficients
        return max(float(left), 0.0) / self.count


def sparse_regression(start: Calibrated) -> dict[str, Any]:
    """Return the verdict: every mechanism with a remaining column, by its share of the torque's power."""
    runs, rig = start.runs, start.nominal
    tones = _tones(start)
    names, seen = _sums(runs, rig, tones, held=False)
    _, held = _sums(runs, rig, tones, held=True)
    nominal = np.array([not one.mechanism for one in names])
    bare = _with_nominal(seen, nominal, np.zeros(int((~nominal).sum())))
    fits = [_with_nominal(seen, nominal, _sparse(seen, nominal, threshold)) for threshold in THRESHOLDS]
    errors = [held.error(fit) for fit in fits]
    best = fits[next(at for at, error in enumerate(errors) if error <= _AS_GOOD * min(errors))]
    if held.error(bare) <= _AS_GOOD * held.error(best):
        best = bare
    found = _named(names, best, seen)
    return verdict(
        "missing_physics" if found else "adequate", start, found, before=held.error(bare), after=held.error(best),
        metric=f"Mean squared residual of held-out torque samples in a regression [N^2 m^2], {solver()}.",
    )  # fmt: skip


def _tones(start: Calibrated) -> list[float]:
    """Return the frequencies of the strongest unexplained lines [Hz]."""
    lines = [line for run in start.runs if run.steady for line in lines_of(run, start.rig) if line.named is None]
    lines.sort(key=lambda line: -line.amplitude)
    return [line.frequency for line in lines[:_TONES]]


def _sums(runs: Sequence[CalibratedRun], rig: Rig, tones: Sequence[float], *, held: bool) -> tuple[list[Column], Sums]:
    """Return the columns (without values) and their sums over fitted or held-out samples."""
    gram, cross, square, count, names = np.zeros((0, 0)), np.zeros(0), 0.0, 0, list[Column]()
    for number, run in enumerate(runs):
        rows = _rows(run, held=held, seed=number)
        names = list(columns_of(run, rows, rig, runs=len(runs), number=number, tones=tones))
        values, torque = np.array([one.values for one in names]), run.torque[rows]
        gram = gram + values @ values.T if gram.size else values @ values.T
        cross = cross + values @ torque if cross.size else values @ torque
        square, count = square + float(torque @ torque), count + rows.size
    return names, Sums(gram, cross, square, count)


def _rows(run: CalibratedRun, *, held: bool, seed: int) -> NDArray[np.int64]:
    every = np.flatnonzero(run.held == held)
    rng = np.random.default_rng([seed, int(held)])
    return np.asarray(np.sort(rng.choice(every, min(_SAMPLES, every.size), replace=False)))


def _sparse(seen: Sums, nominal: NDArray[np.bool_], threshold: float) -> Floats:
    """Return the coefficients of the mechanisms' columns, fitted together with the nominal columns."""
    effects = ~nominal
    other = np.linalg.lstsq(seen.gram[np.ix_(nominal, nominal)], seen.gram[np.ix_(nominal, effects)], rcond=1e-10)[0]
    gram = seen.gram[np.ix_(effects, effects)] - seen.gram[np.ix_(effects, nominal)] @ other
    cross = seen.cross[effects] - other.T @ seen.cross[nominal]
    power = np.diag(seen.gram)[effects]
    kept = (power > _NOTHING * power.max(initial=0.0)) & (np.diag(gram) > _ABSORBED * power)
    answer = np.zeros(kept.size)
    if not kept.any():
        return answer
    scale = np.sqrt(power[kept] / seen.count)
    scaled = gram[np.ix_(kept, kept)] / np.outer(scale, scale) / seen.count
    # a triangular matrix with the same normal equations as all samples
    triangle = np.linalg.cholesky(scaled + 1e-9 * np.eye(scale.size)).T
    target = np.linalg.solve(triangle.T, cross[kept] / scale / seen.count)
    answer[kept] = stlsq(np.asarray(triangle), np.asarray(target), threshold=threshold) / scale
    return answer


def _with_nominal(seen: Sums, nominal: NDArray[np.bool_], effects: Floats) -> Floats:
    """Return all coefficients, with the nominal ones fitted to the residual of ``effects``."""
    answer = np.zeros(nominal.size)
    answer[~nominal] = effects
    residual = seen.cross[nominal] - seen.gram[np.ix_(nominal, ~nominal)] @ effects
    answer[nominal] = np.linalg.lstsq(seen.gram[np.ix_(nominal, nominal)], residual, rcond=1e-10)[0]
    return answer


def _named(columns: Sequence[Column], fit: Floats, seen: Sums) -> list[Named]:
    """Return each mechanism with a remaining column, strongest first; its strongest column gives the parameter."""
    power = fit**2 * np.diag(seen.gram) / seen.count
    sums: dict[str, float] = {}
    for one, share in zip(columns, power, strict=True):
        if one.mechanism and share > 0.0:
            sums[one.mechanism] = sums.get(one.mechanism, 0.0) + float(share)
    found = []
    for name, total in sorted(sums.items(), key=lambda pair: -pair[1]):
        at = max((i for i, one in enumerate(columns) if one.mechanism == name), key=lambda i: float(power[i]))
        column = columns[at]
        stated = column.at or float(fit[at])
        found.append(
            Named(
                mechanism=name, confidence=min(0.99, total / sum(sums.values())),
                explanation=f"Its columns explain {np.sqrt(total):.3g} N m rms of the torque.",
                parameters={column.parameter: stated},
            )
        )  # fmt: skip
    return found
