"""Inputs of the machine, sample by sample, before and after the effects."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.laws import Laws
from proof.rig_program.load import load_course
from proof.rig_program.plan import Run
from proof.rig_program.speed import speed_course
from proof.rig_program.true_rig import TrueRig

NO_LIMIT = 1.0e9


@dataclass(frozen=True)
class Forcing:
    """The inputs of one run, settling included, each (n,).

    Parameters
    ----------
    set_point : array
        Motor speed that the controller is asked for [rad/s].
    load : array
        Torque of the bed [Nm], against the wear part's motion.
    push : array
        Any other torque on the wear part [Nm].
    coupling_limit : array
        Torque at which the coupling slips [Nm].
    line_phase : array
        Phase of the machine's line of no whole order [rad].
    """

    set_point: NDArray[np.float64]
    load: NDArray[np.float64]
    push: NDArray[np.float64]
    coupling_limit: NDArray[np.float64]
    line_phase: NDArray[np.float64]

    @property
    def samples(self) -> int:
        """Number of samples of the run, with settling."""
        return int(self.set_point.size)


def forcing_of(run: Run, rig: TrueRig, laws: Laws, rng: np.random.Generator, *, wanders: bool = True) -> Forcing:
    """Draw the inputs of a rig in one run."""
    set_point = speed_course(run, rng, speed_error=rig.speed_error, wanders=wanders)
    load = load_course(run, laws, rng, mean=rig.mean_load(run.occupancy), samples=set_point.size)
    nothing = np.zeros(set_point.size)
    return Forcing(set_point, load, nothing, np.full(set_point.size, NO_LIMIT), nothing)


def recorded_time(samples: int) -> NDArray[np.float64]:
    """Time of each sample of a forcing (n,) [s], counted from the beginning of the recording."""
    return np.asarray(np.arange(samples) / nominal.SAMPLE_RATE - nominal.SETTLING)
