"""How large additions and residuals are, in N m or N."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from torquerig.inference.motion.engine import MotionOutcome, sizes_of
from torquerig.inference.motion.fit import fitted
from torquerig.inference.motion.fitted_model import PerRun
from torquerig.inference.motion.held_out import HeldOut
from torquerig.inference.motion.hypothesis import Hypothesis
from torquerig.inference.motion.imposed_run import ImposedRun

RELEVANCE = 0.03  # of the rms effort: the contract's limit below which an effect changes no verdict


def size(outcome: MotionOutcome, each: Hypothesis) -> float:
    """Return the rms of the effort that an addition makes, all other parameters held [N m] or [N]."""
    fit = outcome.fit
    used = [run.seen.any() for run in fit.runs]
    if each.columns is not None:
        rows = [row for row, name in enumerate(fit.names) if name.startswith(f"{each.name}[")]
        made = [
            sum(fit.positions[row] * fit.derivatives[fit.names[row]][at] for row in rows) for at in range(len(used))
        ]
        return _rms([one for one, wanted in zip(made, used, strict=True) if wanted], _samples(fit.runs))
    less = fitted(fit.model.minus(each.name), fit.runs, after=replace(fit, positions=fit.positions), steps=0)
    if less is None:
        return 0.0
    made = [one - two for one, two, wanted in zip(less.base, fit.base, used, strict=True) if wanted]
    return _rms(made, _samples(fit.runs))


def amplitude(outcome: MotionOutcome, each: Hypothesis) -> float:
    """Return the amplitude of a family of lines, the mean over directions and runs that have their own [N m] or [N]."""
    sizes = sizes_of(outcome.fit, each.name, scale=each.scale).reshape(-1, 2 * len(each.orders))
    return float(np.sqrt(np.mean((sizes**2).sum(axis=1)[(sizes != 0).any(axis=1)])))


def relevance(outcome: MotionOutcome) -> float:
    """Return the size below which an effect without a name changes no verdict [N m] or [N]."""
    return RELEVANCE * _rms([run.transformed(run.effort) for run in outcome.runs if run.seen.any()],
                            _samples(outcome.runs))  # fmt: skip


def held_out_rms(outcome: MotionOutcome, judged: HeldOut, rows: tuple[int, ...] | None = None) -> float:
    """Return the rms residual of held-out frames [N m] or [N], of some runs or all."""
    chosen = judged.rows if rows is None else rows
    samples = sum(int(outcome.runs[row].held.sum()) * outcome.runs[row].bins for row in chosen)
    return _rms([judged.residuals[row] for row in chosen], samples)


def held_out_effort(outcome: MotionOutcome) -> float:
    """Return the rms of the measured effort in held-out frames, in the compared band [N m] or [N]."""
    rows = outcome.held[0].rows
    samples = sum(int(outcome.runs[row].held.sum()) * outcome.runs[row].bins for row in rows)
    return _rms(
        [outcome.runs[row].transformed(outcome.runs[row].effort)[outcome.runs[row].held] for row in rows], samples
    )


def share(outcome: MotionOutcome, each: Hypothesis, *, of: float) -> float:
    """Return the share of a mean square ``of`` squared that an addition makes [1], at most 1."""
    return min(1.0, (size(outcome, each) / max(of, 1e-300)) ** 2)


def _rms(parts: PerRun, samples: int) -> float:
    return float(np.sqrt(sum(float((one**2).sum()) for one in parts) / max(samples, 1)))


def _samples(runs: tuple[ImposedRun, ...]) -> int:
    return sum(run.seen.size * run.bins for run in runs if run.seen.any())
