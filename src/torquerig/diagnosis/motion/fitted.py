"""A rig with the numbers that come nearest to the measured effort, through the simulator."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square, samples_that_count
from torquerig.diagnosis.motion.moved import BAND, Mask, Moved
from torquerig.diagnosis.motion.predicted import predicted
from torquerig.inference.knobs import Knob, turned
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

ZERO_SPREAD = 0.03  # of the rms effort: how far the zero of the effort's channel may stand off, one sigma
_THIN = int(0.4 / BAND)  # nothing stands above the band, so every fourth sample holds it all
_AT_THE_END = 0.98
_LIMIT = 6.0  # a knob goes no further than this many of its spreads
_PRECISE, _AS_IF = 0.05, 400.0  # against the knobs' spreads: so precise [1] and so many samples, until colour is known


@dataclass(frozen=True, eq=False)
class FittedMotion:
    """A fitted rig.

    Parameters
    ----------
    rig : Rig
    knobs : tuple of Knob
    positions : ndarray, shape (knobs,)
        In spreads.
    covariance : ndarray, shape (knobs, knobs)
        Of the positions, with the residuals' colour in it.
    zero : float
        Of the effort's channel [N m] or [N], one for all runs.
    residuals : tuple of ndarray
        Measured less predicted less zero of every run, all samples.
    """

    rig: Rig
    knobs: tuple[Knob, ...]
    positions: Floats
    covariance: Floats
    zero: float
    residuals: tuple[Floats, ...]

    def of(self, runs: Sequence[Moved], *, held: bool = False) -> list[Floats]:
        """Return the residuals that fits saw, or those held out; runs without any are left out."""
        masks = [run.held if held else run.seen for run in runs]
        return [each[mask] for each, mask in zip(self.residuals, masks, strict=True) if mask.any()]

    def sigma(self, index: int) -> float:
        """Return the standard deviation of a knob's position."""
        return float(np.sqrt(max(self.covariance[index, index], 0.0)))


def residuals_of(rig: Rig, runs: Sequence[Moved], *, zero: float = 0.0) -> tuple[Floats, ...]:
    """Return measured less predicted less ``zero`` of every run, all samples."""
    return tuple(run.effort - predicted(rig, run) - zero for run in runs)


def fitted(
    rig: Rig, runs: Sequence[Moved], knobs: Sequence[Knob], *, start: Floats | None = None,
    masks: Sequence[Mask] | None = None, evaluations: int = 25,
) -> FittedMotion:  # fmt: skip
    """Return the rig whose knobs, and the zero beside them, come nearest to what the runs show.

    Parameters
    ----------
    start : ndarray, shape (knobs,), optional
        Positions to start from; zero without.
    masks : sequence of ndarray of bool, optional
        What is fitted, in place of what the runs say may be seen.
    evaluations : int
        Of the model and its slopes, at most.
    """
    from scipy.optimize import least_squares

    chosen = [run.seen for run in runs] if masks is None else list(masks)
    pairs = [(run, np.flatnonzero(mask)[::_THIN]) for run, mask in zip(runs, chosen, strict=True) if mask.any()]
    typical = root_mean_square([run.effort[kept] for run, kept in pairs])
    count = sum(kept.size for _, kept in pairs)
    weight = np.sqrt(min(1.0, _AS_IF / count)) / (_PRECISE * typical)

    def rest(positions: Floats) -> list[Floats]:
        made = turned(rig, knobs, positions[:-1])
        zero = positions[-1] * ZERO_SPREAD * typical
        return [(run.effort - predicted(made, run))[kept] - zero for run, kept in pairs]

    def cost(positions: Floats) -> Floats:
        return np.concatenate([*(weight * each for each in rest(positions)), positions])

    first = np.zeros(len(knobs) + 1) if start is None else np.append(start, 0.0)
    found = least_squares(
        cost, np.clip(first, -0.99 * _LIMIT, 0.99 * _LIMIT), bounds=(-_LIMIT, _LIMIT), max_nfev=evaluations,
        ftol=1e-5, xtol=1e-4, diff_step=1e-3,
    )  # fmt: skip
    zero = float(found.x[-1]) * ZERO_SPREAD * typical
    made = turned(rig, knobs, found.x[:-1])
    left = rest(found.x)
    slope = found.jac[: -len(first)] / weight
    noise = root_mean_square(left) ** 2 * count / samples_that_count(left)
    covariance = np.linalg.pinv(slope.T @ slope / noise + np.eye(len(first)))
    return FittedMotion(
        made, tuple(knobs), found.x[:-1], covariance[:-1, :-1], zero, residuals_of(made, runs, zero=zero)
    )


def at_their_ends(model: FittedMotion, *, of: Sequence[Knob]) -> tuple[str, ...]:
    """Return a sentence for each number among ``of`` that went as far as it may: it stands in for what is missing."""
    pairs = zip(model.knobs, model.positions, strict=True)
    far = [knob for knob, at in pairs if knob in of and abs(at) > _AT_THE_END * _LIMIT]
    return tuple(
        f"{knob.part}.{knob.field}: the fit stops at {knob.value(model.rig):.3g}, {_LIMIT:g} prior standard deviations "
        "away. Correct the stated value if it is wrong. Otherwise, a missing effect acts like this deviation."
        for knob in far
    )
