"""How the values of a reading are spread: equal neighbours, a pile at the end, jumps; what codes and limits change."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_JUMP = 12.0  # robust sigma of the steps
_RELATIVE = np.array([0.15, 0.15, 0.075])  # spread of the three numbers: of the number of jumps 0.15, of its root half
_FLOORS = np.array([0.01, 2e-3, 1.22])  # the chance of a count and of the mean of two simulated ones


def value_features(observed: Observed, *, held: bool) -> Floats:
    """Return ``of_values`` of the raw torque channel's held-out or other stretches, shape (3,)."""
    volts = observed.recording.torque_values()
    return of_values(np.concatenate([volts[s.start : s.stop] for s in observed.stretches if s.held == held]))


def of_values(volts: Floats) -> Floats:
    """Return the share of equal neighbours, the share of samples on the end value, and the jumps, shape (3,).

    Jumps are steps of more than 12 spreads of those steps that move at all: a reading that stands at its limit for a
    third of the time would otherwise seem to jump wherever it does not. Steps up and down make up for each other, so
    that their spread is taken about zero: on coarse codes nearly all are one code, up or down, and the median is
    either, with no spread about it. They are counted as twice the root of their number, which chance spreads by 1
    (Anscombe 1948, Biometrika 35).
    """
    steps = np.diff(volts)
    moving = steps[steps != 0]
    sigma = spread_about_zero(moving) if moving.size else 0.0
    on_end = max(float(np.mean(volts == volts.max())), float(np.mean(volts == volts.min())))
    jumps = float(np.sum(np.abs(steps) > _JUMP * sigma)) if sigma > 0 else 0.0
    return np.array([float(np.mean(steps == 0)), on_end, 2 * np.sqrt(jumps + 0.375)])


def value_misfit(measured: Floats, model: Floats) -> Floats:
    """Return the residuals of the three numbers in units of their spread, shape (3,)."""
    spread = np.sqrt(_FLOORS**2 + (_RELATIVE * np.maximum(measured, model)) ** 2)
    return np.asarray((measured - model) / spread)
