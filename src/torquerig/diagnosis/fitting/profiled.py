"""How well another rig would fit if the model's numbers gave way to it: a score before any fit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from torquerig.diagnosis.fitting.calibration import LIMIT, Calibrated, misfits_of
from torquerig.diagnosis.fitting.least_squares import weights
from torquerig.diagnosis.fitting.misfit import BEND, robust_squares
from torquerig.diagnosis.looking.features import Features
from torquerig.rig.assembly import Rig

_STEPS = 3  # reweighted ones, all by the same derivatives


def profiled_cost(model: Calibrated, rig: Rig, seen: Sequence[Features]) -> float:
    """Return the cost of ``rig``, the numbers of ``model`` moved to where their derivatives promise it is least.

    ``rig`` is the model's with something added. What is missing bends the numbers of a model that lacks it, so that
    adding it alone fits worse than before, and worst at the right place; with the numbers free it is the score of that
    place (Rao 1948, Proc. Camb. Phil. Soc. 44), by reweighted Gauss-Newton steps on the model's own derivatives.

    Parameters
    ----------
    model : Calibrated
        With its ``jacobian``.
    rig : Rig
    seen : sequence of Features
        That the model was fitted to.
    """
    missed = np.concatenate([one.paid() for one in misfits_of(rig, seen, model.corrections or None)])
    slopes, at, step = model.jacobian, model.positions, np.zeros(model.positions.size)
    if slopes is None:
        return float(robust_squares(missed).sum() + at @ at)
    for _ in range(_STEPS):
        counted = weights(missed + slopes @ step, BEND)
        curvature = slopes.T @ (counted[:, None] * slopes) + np.eye(at.size)
        step = np.linalg.solve(curvature, -(slopes.T @ (counted * missed) + at))
        step = np.clip(at + step, -LIMIT, LIMIT) - at
    return float(robust_squares(missed + slopes @ step).sum() + (at + step) @ (at + step))
