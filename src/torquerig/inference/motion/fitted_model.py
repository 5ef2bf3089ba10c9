"""A fitted model: where its parameters are, what it leaves, and how its rig is simulated along the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.knobs import turned
from torquerig.inference.motion.hypothesis import Model
from torquerig.inference.motion.imposed_run import ImposedRun
from torquerig.inference.motion.needed_effort import needed_effort
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]
PerRun = list[Floats]


@dataclass(frozen=True, eq=False)
class Fit:
    """A fitted model.

    Parameters
    ----------
    model : Model
    runs : tuple of ImposedRun
    names : list of str
        Of the parameters.
    positions : ndarray, shape (parameters,)
        In standard deviations of their priors.
    derivatives : dict of str to list of ndarray
        Change of the transformed effort of each run per unit of a parameter, each of shape (frames, bins).
    base : list of ndarray
        Measured minus simulated in frames and bins, of each run with fitted frames; else zero.
    residuals : list of ndarray
        The same minus the linear parameters.
    density : list of ndarray
        S of each run, shape (bins,).
    nodes : ndarray
        Of the density of the runs with fitted frames.
    hessian : ndarray, shape (parameters, parameters)
        Of minus the log posterior.
    log_posterior, log_evidence : float
        [nats]
    """

    model: Model
    runs: tuple[ImposedRun, ...]
    names: list[str]
    positions: Floats
    derivatives: dict[str, PerRun]
    base: PerRun
    residuals: PerRun
    density: PerRun
    nodes: Floats
    hessian: Floats
    log_posterior: float
    log_evidence: float

    @property
    def log_odds(self) -> float:
        """Log evidence plus prior log-odds [nats]."""
        return self.log_evidence + self.model.log_odds

    @property
    def rig(self) -> Rig:
        """The rig with its parameters at their estimates, without the additions that are linear."""
        return turned(self.model.rig, self.model.knobs, self.positions[: len(self.model.knobs)])

    @property
    def moving(self) -> int:
        """Number of parameters that are simulated; the linear ones follow."""
        return len(self.model.knobs) + (len(self.runs) if self.model.zeros else 0)

    @property
    def covariance(self) -> Floats:
        """Of the positions, shape (parameters, parameters)."""
        return np.asarray(np.linalg.inv(self.hessian))

    def start(self) -> dict[str, float]:
        """Return the positions by name."""
        return dict(zip(self.names, self.positions.tolist(), strict=True))


def effort_scale(runs: Sequence[ImposedRun]) -> float:
    """Return the rms of the measured effort of all runs [N m] or [N]."""
    return float(np.sqrt(np.mean(np.concatenate([run.effort for run in runs]) ** 2)))


def simulated_differences(fit: Fit, rows: Sequence[int], at: Floats | None = None) -> PerRun | None:
    """Return measured minus simulated effort of some runs in frames and bins, the others zero."""
    used = [row in rows for row in range(len(fit.runs))]
    return simulated(fit.model, fit.runs, fit.positions if at is None else at, used)


def simulated(model: Model, runs: Sequence[ImposedRun], at: Floats, used: Sequence[bool]) -> PerRun | None:
    """Return measured minus simulated effort of the used runs in frames and bins; None where a rig runs away."""
    knobs = model.knobs
    rig, answer = turned(model.rig, knobs, at[: len(knobs)]), list[Floats]()
    for row, (run, wanted) in enumerate(zip(runs, used, strict=True)):
        if not wanted:
            answer.append(np.zeros((run.seen.size, run.frequencies.size)))
            continue
        zero = model.zeros * float(at[len(knobs) + row]) if model.zeros else 0.0
        needed = needed_effort(rig, run, zero=zero)
        if needed is None or not np.isfinite(needed).all():
            return None
        answer.append(run.transformed(run.effort - needed))
    return answer
