"""Sparse regression: the torque of all runs on a column per effect, small coefficients dropped, what stays is named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from proof.baselines.columns import Column, columns_of
from proof.baselines.residual_fft import lines_of
from proof.baselines.stlsq import solver, stlsq
from proof.baselines.verdict import Named, verdict
from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.looking.observed import Observed
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

THRESHOLDS = (0.1, 0.05, 0.025, 0.012, 0.006, 0.003)  # [N m] rms of a column's share; the held-out part chooses
_AS_GOOD = 1.002  # a sparser model is taken where it is no worse than this
_SAMPLES = 10_000  # of each run, drawn without order so that neighbours are far apart
_ABSORBED = 1e-5  # share of a column's variance beside the model's own columns below which nothing of it can be seen
_NOTHING = 1e-12  # of the largest: what falls off with the speed may be as good as zero all along
_TONES = 4


@dataclass(frozen=True)
class Sums:
    """Products of columns with each other and with the torque, over ``count`` samples; enough for any fit."""

    gram: Floats
    cross: Floats
    square: float
    count: int

    def error(self, coefficients: Floats) -> float:
        """Return the mean square of what these coefficients leave [N^2 m^2]."""
        left = self.square - 2 * coefficients @ self.cross + coefficients @ self.gram @ coefficients
        return max(float(left), 0.0) / self.count


def sparse_regression(outcome: Outcome) -> dict[str, Any]:
    """Return the verdict: every mechanism of which a column stays, by its share of the torque's power."""
    runs, rig = outcome.before.runs, outcome.before.nominal
    tones = _tones(outcome)
    names, seen = _sums(runs, rig, tones, held=False)
    _, held = _sums(runs, rig, tones, held=True)
    own = np.array([not one.mechanism for one in names])
    bare = _with_own(seen, own, np.zeros(int((~own).sum())))
    fits = [_with_own(seen, own, _sparse(seen, own, threshold)) for threshold in THRESHOLDS]
    errors = [held.error(fit) for fit in fits]
    best = fits[next(at for at, error in enumerate(errors) if error <= _AS_GOOD * min(errors))]
    if held.error(bare) <= _AS_GOOD * held.error(best):
        best = bare
    found = _named(names, best, seen)
    return verdict(
        "missing_physics" if found else "adequate", outcome, found, before=held.error(bare), after=held.error(best),
        metric=f"mean square of held-out torque samples beside a regression on columns [N^2 m^2], {solver()}",
    )  # fmt: skip


def _tones(outcome: Outcome) -> list[float]:
    """Suggest the strongest nameless lines of the spectra as fixed tones."""
    rig = outcome.before.model.rig
    lines = [line for run in outcome.before.runs if run.steady for line in lines_of(run, rig) if line.named is None]
    lines.sort(key=lambda line: -line.amplitude)
    return [line.frequency for line in lines[:_TONES]]


def _sums(runs: Sequence[Observed], rig: Rig, tones: Sequence[float], *, held: bool) -> tuple[list[Column], Sums]:
    """Return the columns (without values) and their sums over samples that fits may see, or may not."""
    gram, cross, square, count, names = np.zeros((0, 0)), np.zeros(0), 0.0, 0, list[Column]()
    for number, run in enumerate(runs):
        rows = _rows(run, held=held, seed=number)
        names = list(columns_of(run, rows, rig, runs=len(runs), number=number, tones=tones))
        values, torque = np.array([one.values for one in names]), run.torque[rows]
        gram = gram + values @ values.T if gram.size else values @ values.T
        cross = cross + values @ torque if cross.size else values @ torque
        square, count = square + float(torque @ torque), count + rows.size
    return names, Sums(gram, cross, square, count)


def _rows(run: Observed, *, held: bool, seed: int) -> NDArray[np.int64]:
    every = np.concatenate([np.arange(each.start, each.stop) for each in run.stretches if each.held == held])
    rng = np.random.default_rng([seed, int(held)])
    return np.asarray(np.sort(rng.choice(every, min(_SAMPLES, every.size), replace=False)))


def _sparse(seen: Sums, own: NDArray[np.bool_], threshold: float) -> Floats:
    """Return the coefficients of the effects' columns, the model's own columns fitted beside them."""
    effects = ~own
    other = np.linalg.lstsq(seen.gram[np.ix_(own, own)], seen.gram[np.ix_(own, effects)], rcond=1e-10)[0]
    gram = seen.gram[np.ix_(effects, effects)] - seen.gram[np.ix_(effects, own)] @ other
    cross = seen.cross[effects] - other.T @ seen.cross[own]
    power = np.diag(seen.gram)[effects]
    kept = (power > _NOTHING * power.max(initial=0.0)) & (np.diag(gram) > _ABSORBED * power)
    answer = np.zeros(kept.size)
    if not kept.any():
        return answer
    scale = np.sqrt(power[kept] / seen.count)
    scaled = gram[np.ix_(kept, kept)] / np.outer(scale, scale) / seen.count
    # a triangle with the same normal equations as all samples
    triangle = np.linalg.cholesky(scaled + 1e-9 * np.eye(scale.size)).T
    target = np.linalg.solve(triangle.T, cross[kept] / scale / seen.count)
    answer[kept] = stlsq(np.asarray(triangle), np.asarray(target), threshold=threshold) / scale
    return answer


def _with_own(seen: Sums, own: NDArray[np.bool_], effects: Floats) -> Floats:
    """Return all coefficients, the model's own ones fitted to what these of the effects leave."""
    answer = np.zeros(own.size)
    answer[~own] = effects
    left = seen.cross[own] - seen.gram[np.ix_(own, ~own)] @ effects
    answer[own] = np.linalg.lstsq(seen.gram[np.ix_(own, own)], left, rcond=1e-10)[0]
    return answer


def _named(columns: Sequence[Column], fit: Floats, seen: Sums) -> list[Named]:
    """Return each mechanism of which a column stayed, the strongest first; its strongest column states the place."""
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
                explanation=f"its columns carry {np.sqrt(total):.3g} N m rms of the torque",
                parameters={column.parameter: stated},
            )
        )  # fmt: skip
    return found
