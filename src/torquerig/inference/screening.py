"""What hypotheses promise: the gain of posterior odds by one linear step, before any of them is fitted.

Where numbers of the rig have moved far to explain what a hypothesis explains, the step begins with these numbers at
their stated values too, and the size of the hypothesis moves with it: no linear step leads back so far.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import TorquerigError
from torquerig.inference.addition import Addition
from torquerig.inference.context import Context
from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.knobs import turned
from torquerig.inference.likelihood import log_density_of
from torquerig.inference.one_number import stated_again, without_priors
from torquerig.inference.prediction.expected_run import ExpectedRun, expected_run
from torquerig.inference.slopes import after_step, gradient_of, hessian_of, stacked
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_PER_PARAMETER = 1.5  # [nats] that the freedom of a parameter costs before it is fitted
_STEPS = 12  # in the local model
_STEP = 1e-3  # [standard deviations] of a derivative


class _Origin(NamedTuple):
    """The rig with its parameters at some positions."""

    rig: Rig
    positions: Floats


def screened(context: Context, each: Addition) -> tuple[float, tuple[float, ...]]:
    """Return the gain of posterior odds that the local model promises [nats], and from which start."""
    if not each.parts:  # a number with a wider prior gains at most what it would gain without one
        _, gains = without_priors(context.fit)
        own = (gains[at] for at, knob in enumerate(context.fit.knobs) if knob.name in each.names)
        return float(sum(own)) + each.log_odds, each.starts[0]
    origins = _origins(context, each)
    tried = [(_promised(context, each, start, origin), start, origin) for start in each.starts for origin in origins]
    best, start, origin = max(tried, key=lambda one: one[0])
    if len(origins) > 1 and not each.places and np.isfinite(best):  # no found line has set its size
        best = max(best, _promised(context, each, start, origin, own=True))
    return best, start


def begins_at(fit: Fit, each: Addition) -> Floats:
    """Return the parameters with which a fit of an addition begins."""
    return np.where([knob.name in each.stated for knob in fit.knobs], 0.0, fit.positions)


def _origins(context: Context, each: Addition) -> list[_Origin]:
    """Return where a step begins: at the fit, and with numbers that have moved far at their stated values."""
    fit, here = context.fit, begins_at(context.fit, each)
    stated = np.where(here == fit.positions, stated_again(fit), here)
    rig = turned(fit.rig, fit.knobs, here) if each.stated else context.rig
    first = _Origin(rig, here)
    return [first] if (stated == here).all() else [first, _Origin(turned(fit.rig, fit.knobs, stated), stated)]


def _promised(
    context: Context, each: Addition, start: tuple[float, ...], origin: _Origin, *, own: bool = False
) -> float:
    """Return the gain with the other parameters moved by one linear step.

    With its ``own`` ones the steps go on in the local model: at first what is far off weighs little.
    """
    fit, rig = context.fit, each.added_to(origin.rig)
    there = _residuals(context, rig, each, start)
    if there is None:
        return -np.inf
    value, sd = there[0] / fit.sd, fit.sd  # of the base model: the sizes of the discrepancy have not followed yet
    slopes, position, prior = fit.jacobian, np.concatenate([origin.positions, fit.gains]), np.square(start).sum()
    if own:
        at = np.array(start) + _STEP * np.eye(len(start))
        moved = [_residuals(context, rig, each, one) or there for one in at.tolist()]
        changes = [stacked((one - there[0]) / sd, np.log(wide / there[1])) / _STEP for one, wide in moved]
        slopes, position, prior = np.column_stack([slopes, *changes]), np.concatenate([position, start]), 0.0
    step = np.zeros(position.size)
    here = value, sd
    for _ in range(_STEPS if own else 1):
        step -= np.linalg.solve(hessian_of(slopes, here[0]), gradient_of(slopes, here[0]) + position + step)
        here = after_step(slopes, value, sd, step)
    after = log_density_of(*here) - 0.5 * float(np.square(position + step).sum() + prior)
    return after - fit.log_posterior + each.log_odds - _PER_PARAMETER * len(start)


def _residuals(context: Context, rig: Rig, each: Addition, at: Sequence[float]) -> tuple[Floats, Floats] | None:
    """Return the residuals of the rig with an addition and their standard deviations, shape (features,) each.

    None where there cannot be such a rig.
    """
    expected = _expected(rig, each, at, context.data)
    if expected is None:
        return None
    there = all_residuals(context.data, expected, context.fit.gains, context.fit.off)
    return np.concatenate([one.value for one in there]), np.concatenate([one.sd for one in there])


def _expected(rig: Rig, each: Addition, start: Sequence[float], data: Data) -> list[ExpectedRun] | None:
    """Return what the rig with an addition is expected to show; None where there cannot be such a rig."""
    try:
        at = turned(rig, each.knobs, np.array(start))
        return [expected_run(at, seen) for seen in data.seen]
    except (TorquerigError, ValueError, np.linalg.LinAlgError):
        return None
