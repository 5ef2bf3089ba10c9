"""The calibrated nominal model from which every baseline starts."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.engine import Outcome
from torquerig.inference.measured_run import MeasuredRun
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class CalibratedRun:
    """One run with the angle of its motor.

    Parameters
    ----------
    rate : float
        Samples per second [Hz].
    torque : ndarray, shape (samples,)
        [N m]
    angle, speed : ndarray, shape (samples,)
        Of the motor [rad], [rad/s].
    steady : bool
        Whether the set-point of the speed was constant.
    held : ndarray of bool, shape (samples,)
        Which samples no fit sees.
    """

    rate: float
    torque: Floats
    angle: Floats
    speed: Floats
    steady: bool
    held: NDArray[np.bool_]

    @cached_property
    def mean_speed(self) -> float:
        """Mean speed of the motor [rad/s]."""
        return float(self.speed.mean())


@dataclass(frozen=True, kw_only=True, eq=False)
class Calibrated:
    """Runs, the rig of the scenario, and the same with its parameters fitted.

    Parameters
    ----------
    runs : tuple of CalibratedRun
    nominal, rig : Rig
        As stated, and with fitted parameters.
    diagnosis : dict
        Of the diagnosis that fitted them, in the contract's form.
    """

    runs: tuple[CalibratedRun, ...]
    nominal: Rig
    rig: Rig
    diagnosis: dict[str, Any]


def by_likelihood(outcome: Outcome, diagnosis: dict[str, Any]) -> Calibrated:
    """Return the model before anything was added to it, from a diagnosis by the likelihood."""
    return Calibrated(
        runs=tuple(map(_run, outcome.runs)), nominal=outcome.nominal.nominal, rig=outcome.nominal.fitted_rig,
        diagnosis=diagnosis,
    )  # fmt: skip


def _run(run: MeasuredRun) -> CalibratedRun:
    held = np.zeros(run.torque.size, dtype=bool)
    for block in run.blocks:
        held[block.samples] = block.held_out
    return CalibratedRun(
        rate=run.rate, torque=run.torque, angle=run.angle, speed=run.speed, steady=run.is_steady, held=held
    )
