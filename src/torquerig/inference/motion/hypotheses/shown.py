"""What the residuals of a fit show before anything is fitted: signals, sizes, and starting values."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.motion.density import weights
from torquerig.inference.motion.fitted_model import Fit
from torquerig.inference.motion.imposed_run import ImposedRun
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import Body, Motor, Slide

Floats = NDArray[np.float64]


def fitted_runs(fit: Fit) -> list[tuple[ImposedRun, Floats]]:
    """Return the runs with fitted frames, and their residuals as signals, zero in frames that are held out."""
    return [
        (run, run.signal(np.where(run.seen[:, None], each, 0.0)))
        for run, each in zip(fit.runs, fit.residuals, strict=True) if run.seen.any()
    ]  # fmt: skip


def weighted_signals(fit: Fit) -> list[tuple[ImposedRun, Floats]]:
    """Return the residuals over their variance as signals: what a sum with a column scores."""
    return [
        (run, run.signal(np.where(run.seen[:, None], weights(each, s) * each, 0.0)))
        for run, each, s in zip(fit.runs, fit.residuals, fit.density, strict=True) if run.seen.any()
    ]  # fmt: skip


def residual_scale(fit: Fit) -> float:
    """Return the rms of the residuals of fitted frames [N m] or [N]."""
    every = np.concatenate([each[run.seen].ravel() for run, each in zip(fit.runs, fit.residuals, strict=True)])
    samples = sum(int(run.seen.sum()) * run.bins for run in fit.runs)
    return float(np.sqrt((every**2).sum() / samples))


def least_squares(fit: Fit, columns: list[Floats]) -> Floats:
    """Return the sizes of columns, one array (samples, sizes) for each fitted run, that the residuals show."""
    pairs = fitted_runs(fit)
    design = np.vstack([each[run.samples_of(run.seen)] for (run, _), each in zip(pairs, columns, strict=True)])
    left = np.concatenate([signal[run.samples_of(run.seen)] for run, signal in pairs])
    return np.asarray(np.linalg.lstsq(design, left, rcond=None)[0])


def top_speed(fit: Fit) -> float:
    """Return the largest speed of all runs [rad/s] or [m/s]."""
    return max(float(np.abs(run.speed).max()) for run in fit.runs)


def stroke(fit: Fit) -> float:
    """Return the largest range of the position in a run [rad] or [m]."""
    return max(float(np.ptp(run.position)) for run in fit.runs)


def carrier(rig: Rig) -> str | None:
    """Return the last part with an inertia, None where no part has one.

    Friction of the imposed part acts alike where the chain is stiff; behind a play it is at the last part alone.
    """
    named = [part.name for part in rig.parts if isinstance(part, Slide | Body | Motor)]
    return named[-1] if named else None


def in_a_line(fit: Fit) -> bool:
    """Return whether the imposed part moves in a line."""
    imposed = imposed_part(fit.model.nominal)
    assert imposed is not None
    return fit.model.nominal.in_a_line(imposed)


def hats(values: Floats, nodes: Floats) -> Floats:
    """Return piecewise linear functions with one at a node each, shape (values, nodes)."""
    return np.asarray(np.array([np.interp(values, nodes, row) for row in np.eye(nodes.size)]).T)
