"""How well a fit predicts the frames that it has not seen.

The predictive density of held-out data, with the posterior of the linear parameters as their prior,

    ln p(held | fitted) = max [ ln p(held | b) - 1/2 (b - b^)' L (b - b^) ] + 1/2 ln det L - 1/2 ln det(L + A' W A)

A zero of the position, or a size that belongs to one run alone, has its prior where no frame of that run was fitted.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.density import DEGREES_OF_FREEDOM, log_density, weights
from torquerig.inference.motion.fitted_model import Fit, PerRun, simulated_differences

Floats = NDArray[np.float64]

_STEPS = 4
_OF_A_RUN = 1.0  # [nats] standard deviation of the gain of the density of a run that no fit has seen


@dataclass(frozen=True, eq=False)
class HeldOut:
    """The judgement of a fit.

    Parameters
    ----------
    log_density : float
        Of all held-out frames [nats].
    residuals : list of ndarray
        Of each run in its held-out frames, shape (frames, bins): with the fitted parameters, and with the zeros and
        sizes of an unseen run estimated from that run.
    rows : tuple of int
        The runs with held-out frames.
    """

    log_density: float
    residuals: PerRun
    rows: tuple[int, ...]

    @property
    def square(self) -> float:
        """Sum of the squared residuals [(N m)^2] or [N^2]."""
        return sum(float((self.residuals[row] ** 2).sum()) for row in self.rows)


def held_out(fit: Fit) -> HeldOut | None:
    """Return the judgement of a fit by its held-out frames; None where its rig cannot be simulated there."""
    rows = _judging(fit)
    unseen = [row for row in rows if not fit.runs[row].seen.any()]
    at = fit.positions.copy()
    zeros = [len(fit.model.knobs) + row for row in unseen] if fit.model.zeros else []
    linear = list(range(fit.moving, len(fit.names)))
    local = [row for row in linear if any(fit.names[row].endswith(f"@{fit.runs[run].name}") for run in unseen)]
    slopes: dict[int, PerRun] = {}
    base = _base(fit, unseen, at)
    for _ in range(_STEPS if zeros else 0):  # a zero is not linear
        if base is None:
            return None
        slopes = _slopes(fit, unseen, zeros, at, base)
        moved = _estimated(fit, base, slopes, at, [*zeros, *local])
        at[[*zeros, *local]] = np.clip(moved, -4.0, 4.0)
        base = _base(fit, unseen, at)
    if base is None:
        return None
    if local:
        at[local] = _estimated(fit, base, slopes, at, local)
    residuals = [one[fit.runs[row].held] for row, one in enumerate(_residuals(fit, base, at))]
    return HeldOut(_log_density(fit, base, slopes, at, [*zeros, *linear]), residuals, rows)


def _judging(fit: Fit) -> tuple[int, ...]:
    return tuple(row for row, run in enumerate(fit.runs) if run.held.any())


def _base(fit: Fit, unseen: list[int], at: Floats) -> PerRun | None:
    if not unseen:
        return fit.base
    made = simulated_differences(fit, unseen, at)
    return None if made is None else [made[row] if row in unseen else one for row, one in enumerate(fit.base)]


def _slopes(fit: Fit, unseen: list[int], zeros: list[int], at: Floats, base: PerRun) -> dict[int, PerRun]:
    answer = {}
    for column, run in zip(zeros, unseen, strict=True):
        other = at.copy()
        other[column] += 0.05
        changed = simulated_differences(fit, [run], other)
        empty = [np.zeros_like(one) for one in base]
        if changed is not None:
            empty[run] = (base[run] - changed[run]) / 0.05
        answer[column] = empty
    return answer


def _residuals(fit: Fit, base: PerRun, at: Floats) -> PerRun:
    answer = [one.copy() for one in base]
    for column in range(fit.moving, len(fit.names)):
        if at[column]:
            for row, change in enumerate(fit.derivatives[fit.names[column]]):
                answer[row] -= at[column] * change
    return answer


def _rows(fit: Fit, rows: tuple[int, ...], each: PerRun) -> Floats:
    return np.concatenate([each[row][fit.runs[row].held].ravel() for row in rows])


def _design(fit: Fit, rows: tuple[int, ...], slopes: dict[int, PerRun], columns: list[int]) -> Floats:
    return np.column_stack([_rows(fit, rows, slopes.get(c) or fit.derivatives[fit.names[c]]) for c in columns])


def _density(fit: Fit, rows: tuple[int, ...], residual: Floats) -> Floats:
    """Return S of each held-out coefficient; the gain of an unseen run is estimated."""
    sizes = [int(fit.runs[row].held.sum()) * fit.runs[row].frequencies.size for row in rows]
    answer = []
    for row, part in zip(rows, np.split(residual, np.cumsum(sizes)[:-1]), strict=True):
        s = np.broadcast_to(fit.density[row], (int(fit.runs[row].held.sum()), fit.density[row].size)).ravel()
        gain = 0.0
        for _ in range(8 if not fit.runs[row].seen.any() else 0):
            ratio = part**2 / (s * np.exp(gain))
            score = 0.5 * ((DEGREES_OF_FREEDOM + 1) * ratio / (DEGREES_OF_FREEDOM + ratio) - 1).sum()
            gain += np.clip((score - gain / _OF_A_RUN**2) / (0.36 * part.size + 1 / _OF_A_RUN**2), -1.0, 1.0)
        answer.append(s * np.exp(gain))
    return np.concatenate(answer)


def _estimated(fit: Fit, base: PerRun, slopes: dict[int, PerRun], at: Floats, columns: list[int]) -> Floats:
    """Return the positions of some parameters of unseen runs that are best there, with their priors."""
    rows = _judging(fit)
    design, move = _design(fit, rows, slopes, columns), np.zeros(len(columns))
    start = _rows(fit, rows, _residuals(fit, base, at))
    for _ in range(4):
        residual = start - design @ move
        w = weights(residual, _density(fit, rows, residual))
        hessian = design.T @ (design * w[:, None]) + np.eye(len(columns))
        move = move + np.linalg.solve(hessian, design.T @ (w * residual) - at[columns] - move)
    return np.asarray(at[columns] + move)


def _log_density(fit: Fit, base: PerRun, slopes: dict[int, PerRun], at: Floats, columns: list[int]) -> float:
    rows = _judging(fit)
    known = [column for column in columns if column >= fit.moving]
    precision = np.eye(len(columns))
    places = [columns.index(column) for column in known]
    precision[np.ix_(places, places)] = fit.hessian[np.ix_(known, known)]
    design, move = _design(fit, rows, slopes, columns), np.zeros(len(columns))
    start, mean = _rows(fit, rows, _residuals(fit, base, at)), fit.positions[columns] - at[columns]
    for _ in range(4):
        residual = start - design @ move
        density = _density(fit, rows, residual)
        w = weights(residual, density)
        hessian = design.T @ (design * w[:, None]) + precision
        move = move + np.linalg.solve(hessian, design.T @ (w * residual) - precision @ (move - mean))
    residual = start - design @ move
    value = log_density(residual, _density(fit, rows, residual)) - 0.5 * float(
        (move - mean) @ precision @ (move - mean)
    )
    return value + 0.5 * float(np.linalg.slogdet(precision)[1] - np.linalg.slogdet(hessian)[1])
